#include "Modules/CommandLine/SuggestPicture.h"

#include <array>

#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

RenderedImage suggestPicture(const Surface& painted, const AnatomicalAxes& axes) {
  const Vector3d front = axes.rows.row(1), head = axes.rows.row(2);
  struct Side {
    const char* title;
    Vector3d from, up;
  };
  const std::array sides{
      Side{"from the front", front, head},
      Side{"from the front and below", (front - head).normalized(), (front + head).normalized()}};
  const auto surface = std::make_shared<const Surface>(painted);
  std::vector<RenderedImage> tiles;
  for (const Side& side : sides) {
    const std::unique_ptr<Scene> scene = titledScene(side.title, TextPlace::TopCentre);
    scene->add<SurfacePresenter>().show(surface);
    std::vector<LegendEntry> legend;
    for (const int label : patchLabels(painted))
      legend.push_back({patchColour(label), patchName(painted, label)});
    scene->add<LegendPresenter>(scene->style().textPx, scene->style().text).show(legend);
    tiles.push_back(drawnTile(*scene, painted.points, {side.from, side.up}, {0.05, 0.05, 0.06, 0.2}));
  }
  return sheetOf(tiles, 2);
}

}  // namespace falciform::commandline
