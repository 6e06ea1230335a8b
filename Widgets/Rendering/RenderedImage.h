#pragma once
#include <vtkRenderWindow.h>

#include <filesystem>

#include "Logic/Core/ColourImage.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// What a window shows: red, green, blue pixels, row 0 at the top.
using RenderedImage = ColourImage;

/// What the window shows now, without rendering again.
[[nodiscard]] RenderedImage grab(vtkRenderWindow* window);

/// Half the size, each pixel the mean of four: how a picture drawn twice as large becomes smooth.
[[nodiscard]] RenderedImage halved(const RenderedImage& image);

/// Writes a PNG whose text chunk says that it is for research use only. Throws InputError as writeFile does.
void savePng(const RenderedImage& image, const std::filesystem::path& file, Overwrite overwrite);

/// Reads a picture as readColourImage does.
[[nodiscard]] RenderedImage readPng(const std::filesystem::path& file);

}  // namespace falciform
