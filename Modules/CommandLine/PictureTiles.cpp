#include "Modules/CommandLine/PictureTiles.h"

#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {
namespace {

constexpr int kTileWidth = 560, kTileHeight = 440;

}  // namespace

std::filesystem::path picturePath(const ParsedArguments& arguments) {
  const std::filesystem::path picture = arguments.path("picture");
  if (!picture.empty() && picture.extension() != ".png")
    throw InputError("--picture is '" + picture.string() + "'; pictures are written as .png");
  return picture;
}

std::unique_ptr<Scene> titledScene(const std::string& title, TextPlace place) {
  SceneStyle style;
  style.textPx = 2 * kTileHeight / 26;
  auto scene = std::make_unique<Scene>(style);
  auto& text = scene->add<TextPresenter>(place, style.textPx, style.text);
  text.setBold(true);
  text.setText(title);
  return scene;
}

void showMapped(Scene& scene, const std::shared_ptr<const Surface>& surface, const ScalarMap& colours) {
  auto& presenter = scene.add<SurfacePresenter>();
  presenter.show(surface);
  presenter.setScalarMap(colours);
  scene.add<ColourBarPresenter>(scene.style().textPx, scene.style().text).show(colours);
}

RenderedImage drawnTile(Scene& scene, const Points& within, const ViewDirection& view,
                        const ViewMargins& margins) {
  fitView(scene.renderer(), within, view, static_cast<double>(kTileWidth) / kTileHeight, margins);
  OffscreenWindow window(2 * kTileWidth, 2 * kTileHeight);
  window.show(scene);
  return halved(window.image());
}

RenderedImage sheetOf(const std::vector<RenderedImage>& tiles, int columns) {
  const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
  RenderedImage sheet{.width = columns * kTileWidth, .height = rows * kTileHeight, .rgb = {}};
  sheet.rgb.assign(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * 3, 255);
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    const std::size_t left = (t % static_cast<std::size_t>(columns)) * kTileWidth,
                      top = (t / static_cast<std::size_t>(columns)) * kTileHeight;
    for (std::size_t y = 0; y < kTileHeight; ++y)
      std::copy_n(tiles[t].rgb.begin() + static_cast<std::ptrdiff_t>(3 * y * kTileWidth), 3 * kTileWidth,
                  sheet.rgb.begin() + static_cast<std::ptrdiff_t>(
                                          3 * ((top + y) * static_cast<std::size_t>(sheet.width) + left)));
  }
  return sheet;
}

}  // namespace falciform::commandline
