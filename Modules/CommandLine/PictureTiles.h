#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "Modules/CommandLine/ParsedArguments.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/RenderedImage.h"
#include "Widgets/Rendering/ScalarMap.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/TextPresenter.h"

namespace falciform::commandline {

/// --picture, empty where it is not given. Throws InputError if it is no .png.
[[nodiscard]] std::filesystem::path picturePath(const ParsedArguments& arguments);

// Sheets of pictures of one size, drawn without a display.

/// A scene for one tile, empty but for its title.
[[nodiscard]] std::unique_ptr<Scene> titledScene(const std::string& title,
                                                 TextPlace place = TextPlace::TopLeft);
/// Puts the surface in, coloured by one of its arrays, and the bar of its colours.
void showMapped(Scene& scene, const std::shared_ptr<const Surface>& surface, const ScalarMap& colours);
/// Draws it so that `within` fills the tile but for the margins.
[[nodiscard]] RenderedImage drawnTile(Scene& scene, const Points& within, const ViewDirection& view,
                                      const ViewMargins& margins);
/// Tiles side by side, row by row; what is left of the last row stays white.
[[nodiscard]] RenderedImage sheetOf(const std::vector<RenderedImage>& tiles, int columns);

}  // namespace falciform::commandline
