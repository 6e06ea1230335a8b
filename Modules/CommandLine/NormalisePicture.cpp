#include "Modules/CommandLine/NormalisePicture.h"

#include <algorithm>

#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

namespace {

const ViewMargins kMargins{0.04, 0.2, 0.12, 0.1};

RenderedImage tile(const std::string& title, const Surface& surface, const ScalarMap* colours) {
  const auto scene = titledScene(title);
  const auto shown = std::make_shared<const Surface>(surface);
  if (colours != nullptr)
    showMapped(*scene, shown, *colours);
  else
    scene->add<SurfacePresenter>().show(shown);
  return drawnTile(*scene, surface.points, directionOf(StandardView::Anterior), kMargins);
}

}  // namespace

void saveNormaliseSheet(const Surface& target, const Surface& source, const Surface& moved,
                        const std::filesystem::path& file, Overwrite overwrite) {
  const std::string array = "distance_to_target_mm";
  // A millimetre is what matters: less is not drawn as if it were much.
  ScalarMap colours = magnitudeMap(array, "Distance to the target", "mm",
                                   std::max(1.0, symmetricEnd(moved.arrays.at(array))));
  colours.outOfRange = OutOfRange::Ends;
  savePng(sheetOf({tile("Target", target, nullptr), tile("Source", source, nullptr),
                   tile("Source on target", moved, &colours)},
                  3),
          file, overwrite);
}

}  // namespace falciform::commandline
