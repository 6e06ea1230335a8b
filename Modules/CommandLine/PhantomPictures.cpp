#include <memory>

#include "Logic/Geometry/Topology.h"
#include "Modules/CommandLine/PhantomExperiment.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/Pictures.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

namespace {

constexpr PictureSize kSize{1200, 900};

/// The scan's spheres without labels, so that they keep their own colour.
Surface spheresOf(const Surface& wholeView) {
  std::vector<int> ids;
  for (Index i = 0; i < wholeView.size(); ++i)
    if (wholeView.patchAt(i) >= patch::kFirstNamed) ids.push_back(static_cast<int>(i));
  Surface spheres = subset(wholeView, ids);
  spheres.patch.clear();
  return spheres;
}

/// Surfaces in LPS as the scanner looks at them, drawn twice as large and halved.
void save(const std::vector<Surface>& shown, const std::string& title, const PhantomExperiment& experiment,
          const std::filesystem::path& file) {
  SceneStyle look;
  look.textPx = 2 * kSize.height / 45;
  Scene scene(look);
  for (const Surface& surface : shown)
    scene.add<SurfacePresenter>().show(std::make_shared<const Surface>(surface));
  auto& heading = scene.add<TextPresenter>(TextPlace::TopCentre, look.textPx * 5 / 4, look.text);
  heading.setBold(true);
  heading.setText(title);
  scene.add<LegendPresenter>(look.textPx, look.text)
      .show({{patchColour(patch::kFalciform), "falciform"},
             {patchColour(patch::kInferiorRidge), "inferior ridge"}});
  const Vector3d from = towardsScanner(experiment.plan.scanner);
  const Vector3d up = (Vector3d::UnitZ() - from.z() * from).normalized();
  Index count = 0;
  for (const Surface& surface : shown) count += surface.size();
  Points all(count, 3);
  Index next = 0;
  for (const Surface& surface : shown) {
    all.middleRows(next, surface.size()) = surface.points;
    next += surface.size();
  }
  fitView(scene.renderer(), all, {from, up}, static_cast<double>(kSize.width) / kSize.height,
          {0.05, 0.05, 0.10, 0.09});
  OffscreenWindow window(2 * kSize.width, 2 * kSize.height);
  window.show(scene);
  savePng(halved(window.image()), file, Overwrite::Replace);
}

}  // namespace

std::vector<std::filesystem::path> phantomPictures(const std::filesystem::path& folder) {
  return {folder / "pictures" / "scan.png", folder / "pictures" / "scan_subregion.png",
          folder / "pictures" / "preop.png"};
}

void writePhantomPictures(const PhantomExperiment& experiment, const std::filesystem::path& folder,
                          const Outputs& outputs) {
  const Isometry3d preopFromScan = experiment.made.scanFromPreop.inverse();
  const auto inPreop = [&](const Surface& surface) { return transformed(surface, preopFromScan, "LPS"); };
  const auto files = phantomPictures(folder);
  save({inPreop(experiment.made.scan), inPreop(spheresOf(experiment.made.wholeView))}, "Whole scan",
       experiment, outputs.staged(files[0]));
  save({inPreop(experiment.made.subRegion)}, "Sub-region", experiment, outputs.staged(files[1]));
  save({experiment.preop}, "CT surface", experiment, outputs.staged(files[2]));
}

}  // namespace falciform::commandline
