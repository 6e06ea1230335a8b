#pragma once
#include <filesystem>

#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

/// Reads the image that belongs to raw.surface.textureAt, if there is any: the one that the file or its
/// material names, or one beside it. Gives the surface its texture, and colours if it has none. Without an
/// image, or with one that cannot be read, the places go too, with a warning. Several images give colours
/// alone. Inside Logic/IO only.
void attachTexture(RawSurface& raw, const std::filesystem::path& file);

}  // namespace falciform
