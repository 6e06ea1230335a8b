#include "Modules/CommandLine/UpdateTiles.h"

#include <algorithm>

#include "Modules/CommandLine/UpdateOutputs.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/OrientationCubePresenter.h"
#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {
namespace {

const ViewMargins kMargins{0.04, 0.2, 0.12, 0.1};
const Vector3d kBefore(0.62, 0.62, 0.62), kVessel(0.16, 0.34, 0.67), kTumour(0.80, 0.33, 0.05);

/// Points of the scan, thinned: more would hide the liver under them.
std::shared_ptr<const Surface> thinned(const Surface& scan) {
  auto cloud = std::make_shared<Surface>();
  const Index step = std::max<Index>(1, scan.size() / 4000);
  cloud->points.resize((scan.size() + step - 1) / step, 3);
  for (Index i = 0; i < cloud->points.rows(); ++i) cloud->points.row(i) = scan.points.row(i * step);
  return cloud;
}

SurfaceStyle plain(const Vector3d& colour, double opacity = 1) {
  SurfaceStyle style;
  style.colour = colour;
  style.opacity = opacity;
  style.ownColours = style.patches = false;
  return style;
}

}  // namespace

UpdateTiles::UpdateTiles(const Surface& preop, const Surface& updated, const Surface& scan,
                         const Isometry3d& scanFromPreopRigid)
    : rigidPose_(scanFromPreopRigid),
      rigid_(std::make_shared<const Surface>(transformed(preop, scanFromPreopRigid, scan.frame))),
      moved_(std::make_shared<const Surface>(updated)),
      cloud_(thinned(scan)),
      view_(viewOfScan(scan, rigid_->points, scanFromPreopRigid)) {
  within_.resize(rigid_->size() + moved_->size(), 3);
  within_ << rigid_->points, moved_->points;
}

std::unique_ptr<Scene> UpdateTiles::scene(const std::string& title) const {
  auto made = titledScene(title);
  made->orientation().setSceneFromLps(rigidPose_.linear());
  return made;
}

RenderedImage UpdateTiles::draw(Scene& scene) const { return drawnTile(scene, within_, view_, kMargins); }

void UpdateTiles::addScan(Scene& scene) const {
  SurfaceStyle style;
  style.colour = Vector3d(0.1, 0.1, 0.1);
  auto& presenter = scene.add<SurfacePresenter>();
  presenter.setStyle(style);
  presenter.show(cloud_);
}

RenderedImage UpdateTiles::registered() const {
  const auto made = scene("Rigid registration, scan as points");
  made->add<SurfacePresenter>().show(rigid_);
  addScan(*made);
  return draw(*made);
}

RenderedImage UpdateTiles::mapped(const std::string& title, const ScalarMap& colours, bool scan) const {
  const auto made = scene(title);
  showMapped(*made, moved_, colours);
  if (scan) addScan(*made);
  return draw(*made);
}

RenderedImage UpdateTiles::moved() const {
  const double largest = moved_->arrays.at(kDisplacement).maxCoeff();
  return mapped("Model update, scan as points", magnitudeMap(kDisplacement, "Displacement", "mm", largest),
                true);
}

bool UpdateTiles::expectsError() const { return moved_->arrays.count(kExpectedError) > 0; }

RenderedImage UpdateTiles::expectedError() const {
  const double largest = moved_->arrays.at(kExpectedError).maxCoeff();
  return mapped("Expected error", magnitudeMap(kExpectedError, "Expected error", "mm", largest), false);
}

RenderedImage UpdateTiles::residual(const std::string& title, const Surface& scanWithDistance,
                                    const ScalarMap& colours) const {
  const auto made = scene(title);
  showMapped(*made, std::make_shared<const Surface>(scanWithDistance), colours);
  return draw(*made);
}

RenderedImage UpdateTiles::structures(const Structures& preop, const Structures& updated) const {
  const auto made = scene("Inside: registered (grey), updated");
  const auto show = [&](const std::shared_ptr<const Surface>& surface, const SurfaceStyle& style) {
    auto& presenter = made->add<SurfacePresenter>();
    presenter.setStyle(style);
    presenter.show(surface);
  };
  for (const auto& [name, surface] : preop)
    show(std::make_shared<const Surface>(transformed(*surface, rigidPose_, moved_->frame)), plain(kBefore));
  for (const auto& [name, surface] : updated)
    show(surface, plain(name.find("umour") != std::string::npos ? kTumour : kVessel));
  SurfaceStyle liver = plain(kLiverColour, 0.18);
  liver.frontOnly = true;
  show(moved_, liver);
  return draw(*made);
}

}  // namespace falciform::commandline
