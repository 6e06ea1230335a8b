#include "Widgets/Views/CaseScene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "Logic/Core/Settings.h"
#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/SurfaceGeometry.h"

namespace falciform {
namespace {

constexpr int kLandmarkPx = 12;
const Vector3d kSeedColour(1.0, 0.27, 0.23);
constexpr double kGhostOpacity = 0.45;
constexpr double kPreviewOpacity = 0.6;    // seeds are seen through it
constexpr double kCubeAboveNotice = 0.09;  // share of the height

SurfaceStyle styleOf(const PartLook& look) {
  SurfaceStyle style;
  style.colour = {look.colour[0], look.colour[1], look.colour[2]};
  style.opacity = look.opacity;
  style.visible = look.visible;
  return style;
}

/// "packing under left lobe, pushed 20 mm"
std::string supportCaption(const SupportRegion& region) {
  std::string caption = region.name + ", " + enumToString(region.kind);
  if (region.kind == SupportRegionKind::Pushed) {
    char distance[32];
    std::snprintf(distance, sizeof distance, " %g mm", region.pushMm);
    caption += distance;
  }
  return caption;
}

/// Landmarks as a cloud of large points.
std::shared_ptr<const Surface> cloudOf(const Landmarks& landmarks) {
  if (landmarks.points.empty()) return nullptr;
  auto cloud = std::make_shared<Surface>();
  cloud->points.resize(static_cast<Index>(landmarks.points.size()), 3);
  for (std::size_t i = 0; i < landmarks.points.size(); ++i)
    cloud->points.row(static_cast<Index>(i)) = landmarks.points[i].position.transpose();
  cloud->normals = Points::Zero(cloud->size(), 3);
  cloud->normals.col(1).setConstant(-1);  // given, since a handful of points has no normals to fit
  return cloud;
}

}  // namespace

/// What case and options come to: which surfaces, where, in what colours.
struct CaseScene::Wanted {
  std::shared_ptr<const Surface> preop, scan;
  Isometry3d sceneFromPreop = Isometry3d::Identity(), sceneFromScan = Isometry3d::Identity();
  std::optional<ScalarMap> preopMap, scanMap;
  bool distance = false, supports = false, deformed = false, update = false, preview = false;
  [[nodiscard]] bool bar() const { return preopMap || scanMap; }
};

CaseScene::CaseScene(const Case& document, const ViewState& view, int textPx)
    : case_(document),
      view_(view),
      textPx_(textPx),
      scene_(screenStyle(textPx)),
      preop_(scene_.add<SurfacePresenter>()),
      scan_(scene_.add<SurfacePresenter>()),
      preopLandmarks_(scene_.add<SurfacePresenter>()),
      scanLandmarks_(scene_.add<SurfacePresenter>()),
      targets_(scene_.add<SurfacePresenter>()),
      seeds_(scene_.add<SurfacePresenter>()),
      suggestion_(scene_.add<BrushCursorPresenter>()),
      bar_(scene_.add<ColourBarPresenter>(textPx, scene_.style().text)),
      legend_(scene_.add<LegendPresenter>(textPx, scene_.style().text)),
      title_(scene_.add<TextPresenter>(TextPlace::TopCentre, textPx, scene_.style().text)),
      corner_(scene_.add<TextPresenter>(TextPlace::TopLeft, textPx, scene_.style().text)) {}

CaseScene::Wanted CaseScene::wanted() const {
  const ViewOptions& options = view_.options();
  Wanted result;
  if (!scanAlone()) {
    result.preop = case_.preop();
    if (options.arrangement == Arrangement::Together) result.scan = case_.scan();
    if (options.livePreopFromScan)
      result.sceneFromScan.matrix() = *options.livePreopFromScan;
    else if (case_.registration() && options.afterRegistration)
      result.sceneFromScan = case_.registration()->scanFromPreop.inverse();
    else
      result.sceneFromScan.matrix() = options.startPreopFromScan;
  } else {
    result.scan = case_.scan();
  }
  result.deformed = options.liveDeformed && !options.painting && result.preop &&
                    options.liveDeformed->size() == result.preop->size();
  if (result.deformed) result.preop = options.liveDeformed;
  result.preview = options.previewSurface && !scanAlone();
  if (result.preview) result.preop = options.previewSurface;
  result.update = result.deformed && options.updateShown;
  if (result.update) {
    if (options.updateColours && result.preop->arrays.contains(options.updateColours->array))
      result.preopMap = options.updateColours;
  } else if (result.deformed && options.displacementColours) {
    result.preopMap = ScalarMap{kDisplacement,    "Displacement",     "mm", 0, options.displacementLimitMm,
                                OutOfRange::Ends, Palette::Sequential};
  } else if (result.preop && options.supportsShown) {
    result.supports = true;
    result.preop = withSupports(result.preop);
  }
  result.distance = options.distanceShown && case_.distance() && case_.registration() && !scanAlone();
  if (result.distance) {
    const auto& map = case_.distance();
    // The map's surfaces are both in the scan's frame; the scene is in LPS.
    result.sceneFromScan = result.sceneFromPreop = case_.registration()->scanFromPreop.inverse();
    result.preop = {map, &map->preop};
    result.scan = {map, &map->scan};
    (options.distanceOnScan ? result.scanMap : result.preopMap) = options.distanceColours;
  }
  return result;
}

// Made once for each pair: while a stroke runs, the presenter shows labels that the case has not yet.
std::shared_ptr<const Surface> CaseScene::withSupports(const std::shared_ptr<const Surface>& liver) const {
  if (supported_.liver == liver && supported_.painting == case_.supports()) return supported_.shown;
  auto labelled = std::make_shared<Surface>(*liver);
  labelled->patch = case_.supports() ? case_.supports()->labels : std::vector<int>();
  labelled->patchNames.clear();
  if (case_.supports())
    for (const auto& [label, region] : case_.supports()->regions) labelled->patchNames[label] = region.name;
  supported_ = {liver, case_.supports(), labelled};
  return labelled;
}

bool CaseScene::follow() {
  const Wanted now = wanted();
  const bool onScan = view_.options().distanceOnScan;
  const auto draw = [](SurfacePresenter& presenter, const std::shared_ptr<const Surface>& surface,
                       const Isometry3d& motion, const std::optional<ScalarMap>& map,
                       const SurfaceStyle& style) {
    presenter.setScalarMap(surface ? map : std::nullopt);
    presenter.setStyle(style);
    if (presenter.surface() != surface) presenter.show(surface);
    presenter.setSceneFromSurface(motion);
  };
  SurfaceStyle preopStyle = styleOf(view_.look(part::kPreop)), scanStyle = styleOf(view_.look(part::kScan));
  if (now.distance) {
    preopStyle.patches = scanStyle.patches = false;
    // The other side lies on the coloured one and would hide or tint the colours.
    (onScan ? preopStyle : scanStyle).visible = false;
  }
  if (now.update && now.preopMap) scanStyle.visible = false;
  if (now.supports && case_.supports())
    for (const auto& [label, region] : case_.supports()->regions)
      preopStyle.patchColours[label] = supportColour(region.kind, label);
  else
    dressPatches(preopStyle, false);
  // Of two patches on each other, one must be told from the other.
  dressPatches(scanStyle, now.preop && now.scan);
  if (now.preview && view_.options().previewIsSketch)
    preopStyle.opacity = std::min(preopStyle.opacity, kPreviewOpacity);
  draw(preop_, now.preop, now.sceneFromPreop, now.preopMap, preopStyle);
  draw(scan_, now.scan, now.sceneFromScan, now.scanMap, scanStyle);
  followStructures(now);
  followLandmarks(now);
  followSuggestion(now);
  followTexts(now);
  scene_.orientation().setVisible(!scanAlone() || case_.registration() != nullptr);
  scene_.orientation().setSceneFromLps(sceneFromLps());

  const std::vector<ShownSurface> visible = shown();
  const auto known = [&](const ShownSurface& one) {
    return std::any_of(fitted_.begin(), fitted_.end(), [&](const ShownSurface& old) {
      return old.part == one.part && (old.surface == one.surface || sameGeometry(*old.surface, *one.surface));
    });
  };
  // A distance map's surfaces are the case's own, moved: no news to the eye.
  // A scan that is shown elsewhere must not be lost from sight, and the view returns when it does. Not while
  // a hand drags it.
  const bool elsewhere = now.scan && !view_.options().moving && !now.distance &&
                         !followedScan_.isApprox(now.sceneFromScan, 1e-9);
  const bool outside = elsewhere && outOfSight(scan_);
  const bool strayed = outside || (elsewhere && fittedWide_);
  if (elsewhere) {
    fittedWide_ = outside;
    followedScan_ = now.sceneFromScan;
  }
  // A front that grows is looked at from one place too, unless it grows out of sight.
  const bool grown = now.preview && (!fittedPreview_ || outOfSight(preop_));
  fittedPreview_ = now.preview;
  const Index seeds = view_.options().seeds ? view_.options().seeds->rows() : 0;
  const bool planted = visible.empty() && std::exchange(fittedSeeds_, seeds) != seeds && seeds > 0;
  const bool news =
      strayed || grown || planted || fittedBar_ != now.bar() || fittedDistance_ != now.distance ||
      directedScanAlone_ != scanAlone() || fittedRegistration_ != case_.registration() ||
      (!now.distance && !now.deformed && !now.preview && !std::all_of(visible.begin(), visible.end(), known));
  if (!now.distance && !now.deformed && !now.preview)
    fitted_ = visible;  // a liver that moves is looked at from one place
  fittedBar_ = now.bar();
  fittedDistance_ = now.distance;
  fittedRegistration_ = case_.registration();
  return news;
}

void CaseScene::followStructures(const Wanted& now) {
  const ViewOptions& options = view_.options();
  for (const auto& [name, surface] : case_.structures()) {
    const auto moved = options.movedStructures.find(name);
    const bool elsewhere = now.update && moved != options.movedStructures.end();
    // A liver that supports move has moved them as well, and nobody has said where to.
    drawStructure(name, elsewhere ? moved->second : surface, structures_[name],
                  !scanAlone() && (!now.deformed || now.update), false);
    drawStructure(name, surface, ghosts_[name], elsewhere && options.structuresBefore, true);
  }
  for (auto* list : {&structures_, &ghosts_})
    std::erase_if(*list, [&](const auto& entry) {
      const bool gone = !case_.structures().count(entry.first);
      if (gone) scene_.remove(*entry.second);
      return gone;
    });
}

void CaseScene::drawStructure(const std::string& name, const std::shared_ptr<const Surface>& surface,
                              SurfacePresenter*& presenter, bool visible, bool ghost) {
  if (!presenter) presenter = &scene_.add<SurfacePresenter>();
  SurfaceStyle style = styleOf(view_.look(part::structure(name)));
  style.visible = style.visible && visible;
  if (ghost) {
    style.colour = kBeforeColour;
    style.opacity *= kGhostOpacity;
  }
  presenter->setStyle(style);
  if (presenter->surface() != surface && style.visible) presenter->show(surface);
}

void CaseScene::dressPatches(SurfaceStyle& style, bool light) const {
  for (int label = patch::kFalciform; label <= patch::kMax && light; ++label)
    style.patchColours[label] = scanPatchColour(label);
  for (const auto& [label, look] : view_.options().patchLooks) {
    const Vector3d colour(look.colour[0], look.colour[1], look.colour[2]);
    style.patchColours[label] = light ? scanPatchColour(colour) : colour;
    if (!look.visible) style.hiddenPatches.insert(label);
  }
}

void CaseScene::followLandmarks(const Wanted& now) {
  const auto draw = [&](SurfacePresenter& presenter, const Landmarks& landmarks, const char* part,
                        bool visible) {
    SurfaceStyle style = styleOf(view_.look(part));
    style.pointPx = kLandmarkPx;
    style.visible = style.visible && visible;
    presenter.setStyle(style);
    presenter.show(cloudOf(landmarks));
  };
  draw(preopLandmarks_, case_.preopLandmarks(), part::kPreopLandmarks, preop_.surface() != nullptr);
  draw(scanLandmarks_, case_.scanLandmarks(), part::kScanLandmarks, scan_.surface() != nullptr);
  scanLandmarks_.setSceneFromSurface(scan_.sceneFromSurface());
  const ViewOptions& options = view_.options();
  Landmarks targets = case_.targets();
  const auto& moved = options.movedTargets;
  if (now.update && moved && moved->rows() == static_cast<Index>(targets.points.size()))
    for (std::size_t i = 0; i < targets.points.size(); ++i)
      targets.points[i].position = moved->row(static_cast<Index>(i)).transpose();
  Landmarks seeds;
  if (options.seeds && !scanAlone())
    for (Index s = 0; s < options.seeds->rows(); ++s)
      seeds.points.push_back({std::to_string(s + 1), options.seeds->row(s).transpose()});
  draw(seeds_, seeds, part::kPreopLandmarks, true);
  SurfaceStyle seedStyle = seeds_.style();
  seedStyle.colour = kSeedColour;
  seeds_.setStyle(seedStyle);
  // Where supports push them nobody has said.
  draw(targets_, targets, part::kTargets, preop_.surface() != nullptr && (!now.deformed || now.update));
  targets_.setSceneFromSurface(preop_.sceneFromSurface());
}

void CaseScene::followSuggestion(const Wanted& now) {
  const ViewOptions& options = view_.options();
  if (!options.suggestedLine || !now.preop || now.deformed) return suggestion_.hide();
  const auto& colour = view_.patchLook(options.suggestedLabel).colour;
  suggestion_.show(transformed(*options.suggestedLine, now.sceneFromPreop), Points(0, 3),
                   {colour[0], colour[1], colour[2]});
}

void CaseScene::followTexts(const Wanted& now) {
  const ViewOptions& options = view_.options();
  narrow_ = now.update && options.comparedLiver;
  scene_.orientation().setBottom(narrow_ ? kCubeAboveNotice : 0);
  corner_.setText(narrow_ ? options.deformedCaption : "");
  std::vector<LegendEntry> entries;
  const bool low = options.slicesShown || options.slicesWanted;  // the bar's lower words would meet the cube
  if (now.distance) {
    bar_.show(now.preopMap ? *now.preopMap : *now.scanMap, !low);
    title_.setText(metricOf(options.distanceColours.array, options.distanceOnScan).meaning);
  } else if (now.bar()) {
    if (options.colourBarShown)
      bar_.show(*now.preopMap, !narrow_ && !low);
    else
      bar_.clear();
    title_.setText(options.deformedCaption);
  } else {
    bar_.clear();
    const bool outdated = case_.registrationStale() && now.preop && now.scan && options.afterRegistration;
    title_.setText(!now.preop && !now.scan && structures_.empty() && !case_.ct() && !case_.labels()
                       ? "Open or drop a label map, surface, scan or case"
                   : now.preview               ? options.previewCaption
                   : now.deformed              ? options.deformedCaption
                   : options.livePreopFromScan ? options.liveCaption
                   : outdated                  ? "Registration is out of date"
                                               : "");
    const bool both = now.preop && now.scan;
    for (const auto& surface : {now.preop, now.scan}) {
      if (!surface) continue;
      const bool light = both && surface == now.scan;
      const bool held = now.supports && surface == now.preop;
      const SurfaceStyle& style = (surface == now.scan ? scan_ : preop_).style();
      for (const int label : patchLabels(*surface)) {
        if (style.hiddenPatches.contains(label)) continue;
        const auto own = style.patchColours.find(label);
        entries.push_back(
            {own != style.patchColours.end() ? own->second : patchColour(label),
             (light  ? "scan: "
              : both ? "liver: "
                     : "") +
                 (held ? supportCaption(case_.supports()->regions.at(label)) : patchName(*surface, label))});
      }
    }
  }
  if (narrow_) {
    title_.setText("");
    entries.clear();  // they would lie on the liver
  }
  legend_.show(entries);
  legendLines_ = static_cast<int>(entries.size());
}

std::vector<ShownSurface> CaseScene::shown() const {
  std::vector<ShownSurface> visible;
  const auto add = [&](const std::string& part, const std::string& title, const SurfacePresenter& presenter) {
    if (presenter.surface() && presenter.style().visible && presenter.style().opacity > 0)
      visible.push_back(
          {part, title, presenter.surface(), presenter.sceneFromSurface(), presenter.scalarMap(), {}});
    // A distance map's surfaces are in the scan's frame, and the scene is the patient's.
    if (presenter.scalarMap() && fittedDistance_)
      visible.back().lpsFromSurface = presenter.sceneFromSurface();
  };
  add(part::kPreop, "Pre-op liver", preop_);
  add(part::kScan, "Scan", scan_);
  for (const auto& [name, presenter] : structures_) add(part::structure(name), name, *presenter);
  return visible;
}

}  // namespace falciform
