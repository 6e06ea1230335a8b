#include "Widgets/Rendering/PictureScenes.h"

#include <vtkCamera.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/ConvergencePresenter.h"
#include "Widgets/Rendering/HistogramPresenter.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/ScanView.h"
#include "Widgets/Rendering/SurfaceGeometry.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

namespace {

// Thesis Fig. III.10: patches of the pre-operative surface red, of the scan blue; both clear of the surfaces'
// colours.
const Vector3d kPreopPatchRed{0.80, 0.05, 0.10}, kScanPatchBlue{0.00, 0.20, 0.75};
const Vector3d kOverlayScan{0.60, 0.80, 0.80};

/// The margins leave room for a title and the legend above, the research notice below.
constexpr ViewMargins kPlain{0.05, 0.05, 0.10, 0.09};
constexpr ViewMargins kWithBar{0.04, 0.16, 0.16, 0.09};

std::unique_ptr<Scene> emptyScene(PictureSize size) {
  SceneStyle style;
  style.textPx = std::max(8, std::min(size.height / 45, size.width / 50));
  return std::make_unique<Scene>(style);
}

double aspectOf(PictureSize size) { return static_cast<double>(size.width) / size.height; }

/// A picture outlives no surface: presenters keep a shared copy.
std::shared_ptr<const Surface> shared(const Surface& surface) {
  return std::make_shared<const Surface>(surface);
}

void addTitle(Scene& scene, const std::string& title) {
  auto& text =
      scene.add<TextPresenter>(TextPlace::TopCentre, scene.style().textPx * 5 / 4, scene.style().text);
  text.setBold(true);
  text.setText(title);
}

std::vector<LegendEntry> patchEntries(const Surface& surface) {
  std::vector<LegendEntry> entries;
  for (const int label : patchLabels(surface))
    entries.push_back({patchColour(label), patchName(surface, label)});
  return entries;
}

/// Points of a cloud so wide that they close into a surface, as the camera stands.
void closeCloud(SurfacePresenter& presenter, vtkRenderer* renderer, PictureSize size) {
  const Surface& cloud = *presenter.surface();
  if (cloud.triangles.rows() > 0 || cloud.size() < 5) return;
  vtkCamera* camera = renderer->GetActiveCamera();
  const double mmPerPixel =
      2 * camera->GetDistance() * std::tan(camera->GetViewAngle() / 2 * std::numbers::pi / 180) / size.height;
  SurfaceStyle style = presenter.style();
  const double pixels = 1.15 * pointSpacing(cloud.points) / mmPerPixel;
  style.pointPx = static_cast<int>(std::lround(std::clamp(pixels, 2.0, size.height / 40.0)));
  presenter.setStyle(style);
}

/// All labels of `surface` in one colour.
std::map<int, Vector3d> oneColour(const Surface& surface, const Vector3d& colour) {
  std::map<int, Vector3d> colours;
  for (const int label : patchLabels(surface)) colours[label] = colour;
  return colours;
}

Points stacked(const Points& a, const Points& b) {
  Points both(a.rows() + b.rows(), 3);
  both << a, b;
  return both;
}

}  // namespace

ViewDirection viewOfScan(const Surface& scan, const Points& preopInScan, const Isometry3d& scanFromPreop) {
  Vector3d from = seenFrom(scan);
  // A scan shows the outside: once the surfaces lie together, the liver's bulk is behind the scan.
  if (preopInScan.rows() > 0 && scan.size() > 0) {
    const Vector3d outwards = (scan.points.colwise().mean() - preopInScan.colwise().mean()).transpose();
    if (from.dot(outwards) < 0) from = -from;
  }
  const Vector3d superior = scanFromPreop.linear() * Vector3d::UnitZ();
  const Vector3d up = superior - superior.dot(from) * from;
  return {from, up.norm() > 0.2 ? Vector3d(up.normalized()) : uprightFor(scan, from)};
}

std::unique_ptr<Scene> preopScene(const Surface& preop, const Structures& structures, PictureSize size) {
  auto scene = emptyScene(size);
  auto& liver = scene->add<SurfacePresenter>();
  SurfaceStyle style;
  // See-through only as far as is needed to find the structures inside.
  style.opacity = structures.empty() ? 1.0 : 0.45;
  style.frontOnly = !structures.empty();
  liver.setStyle(style);
  liver.show(shared(preop));
  std::vector<LegendEntry> entries = patchEntries(preop);
  static const std::array<Vector3d, 5> colours{Vector3d(0.35, 0.10, 0.45), Vector3d(0.00, 0.35, 0.25),
                                               Vector3d(0.10, 0.15, 0.55), Vector3d(0.55, 0.05, 0.15),
                                               Vector3d(0.25, 0.25, 0.25)};
  std::size_t next = 0;
  for (const auto& [name, surface] : structures) {
    if (!surface) continue;
    SurfaceStyle inside;
    inside.colour = colours[next++ % colours.size()];
    inside.patches = false;
    auto& presenter = scene->add<SurfacePresenter>();
    presenter.setStyle(inside);
    presenter.show(surface);
    entries.push_back({inside.colour, name});
  }
  scene->add<LegendPresenter>(scene->style().textPx, scene->style().text).show(entries);
  const bool lps = preop.frame == "LPS";
  addTitle(*scene, lps ? "Pre-operative surface, from anterior" : "Pre-operative surface");
  scene->orientation().setVisible(lps);
  fitView(scene->renderer(), preop.points, directionOf(StandardView::Anterior), aspectOf(size), kPlain);
  return scene;
}

std::unique_ptr<Scene> scanScene(const Surface& scan, PictureSize size) {
  auto scene = emptyScene(size);
  auto& presenter = scene->add<SurfacePresenter>();
  SurfaceStyle style;
  style.colour = kScanColour;
  presenter.setStyle(style);
  presenter.show(shared(scan));
  scene->add<LegendPresenter>(scene->style().textPx, scene->style().text).show(patchEntries(scan));
  addTitle(*scene, "Intra-operative scan");
  scene->orientation().setVisible(scan.frame == "LPS");
  const Vector3d from = seenFrom(scan);
  fitView(scene->renderer(), scan.points, {from, uprightFor(scan, from)}, aspectOf(size), kPlain);
  closeCloud(presenter, scene->renderer(), size);
  return scene;
}

std::unique_ptr<Scene> overlayScene(const Surface& preop, const Surface& scan,
                                    const Isometry3d& scanFromPreop, const std::string& title,
                                    PictureSize size, const std::optional<ViewDirection>& view) {
  auto scene = emptyScene(size);
  const Surface moved = transformed(preop, scanFromPreop, scan.frame);
  auto& liver = scene->add<SurfacePresenter>();
  SurfaceStyle preopStyle;
  preopStyle.opacity = 0.7;
  preopStyle.frontOnly = true;
  preopStyle.patchColours = oneColour(preop, kPreopPatchRed);
  liver.setStyle(preopStyle);
  liver.show(shared(moved));
  auto& seen = scene->add<SurfacePresenter>();
  SurfaceStyle style;
  style.colour = kOverlayScan;
  style.ownColours = false;
  style.patchColours = oneColour(scan, kScanPatchBlue);
  seen.setStyle(style);
  seen.show(shared(scan));

  std::vector<LegendEntry> entries{{kLiverColour, "pre-operative surface"}};
  if (!patchLabels(preop).empty()) entries.push_back({kPreopPatchRed, "its patches"});
  entries.push_back({kOverlayScan, "scan"});
  if (!patchLabels(scan).empty()) entries.push_back({kScanPatchBlue, "the scan's patches"});
  scene->add<LegendPresenter>(scene->style().textPx, scene->style().text).show(entries);
  addTitle(*scene, title);
  scene->orientation().setVisible(preop.frame == "LPS");
  scene->orientation().setSceneFromLps(scanFromPreop.linear());
  fitView(scene->renderer(), stacked(moved.points, scan.points),
          view.value_or(viewOfScan(scan, moved.points, scanFromPreop)), aspectOf(size), kPlain);
  closeCloud(seen, scene->renderer(), size);
  return scene;
}

std::unique_ptr<Scene> distanceScene(const DistanceMap& map, DistanceSide side, PictureSize size,
                                     const std::optional<Isometry3d>& scanFromPreop) {
  auto scene = emptyScene(size);
  const bool onPreop = side == DistanceSide::Preop;
  const Surface& surface = onPreop ? map.preop : map.scan;
  const ScalarMap colours = symmetricMap(kSignedDistance, "Signed distance", "mm", {&map.preop, &map.scan});
  auto& presenter = scene->add<SurfacePresenter>();
  presenter.setScalarMap(colours);
  presenter.show(shared(surface));
  scene->add<ColourBarPresenter>(scene->style().textPx, scene->style().text).show(colours);
  addTitle(*scene, onPreop ? "Distance on the pre-operative surface" : "Distance on the scan");
  scene->add<TextPresenter>(TextPlace::BottomLeft, scene->style().textPx, scene->style().text, 1)
      .setText(
          "Positive: the scan lies outside the pre-operative surface;\nnegative: inside; grey: no value.");
  scene->orientation().setVisible(scanFromPreop.has_value());
  if (scanFromPreop) scene->orientation().setSceneFromLps(scanFromPreop->linear());
  ViewDirection view = viewOfScan(map.scan, map.preop.points, scanFromPreop.value_or(Isometry3d::Identity()));
  if (!scanFromPreop) view.up = uprightFor(map.scan, view.from);
  fitView(scene->renderer(), surface.points, view, aspectOf(size), kWithBar);
  closeCloud(presenter, scene->renderer(), size);
  return scene;
}

std::unique_ptr<Scene> histogramScene(const DistanceMap& map, PictureSize size) {
  auto scene = emptyScene(size);
  scene->orientation().setVisible(false);
  scene->add<HistogramPresenter>(scene->style().textPx, scene->style().text).show(map);
  return scene;
}

std::unique_ptr<Scene> convergenceScene(const RegistrationResult& registration, PictureSize size) {
  auto scene = emptyScene(size);
  scene->orientation().setVisible(false);
  scene->add<ConvergencePresenter>(scene->style().textPx, scene->style().text).show(registration.history);
  return scene;
}

}  // namespace falciform
