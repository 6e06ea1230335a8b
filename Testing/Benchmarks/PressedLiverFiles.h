#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// A frame of the depth camera that watched the pressed liver, with its pose beside it: the points alone, in
/// the frame of its tracker, mm. Depths come in whole mm.
[[nodiscard]] Surface readDepthFrame(const std::filesystem::path& depthFile);

/// The nodes of an ASCII unstructured grid in VTK's legacy format. Throws
/// std::runtime_error for a file that is not like that.
[[nodiscard]] Points readNodes(const std::filesystem::path& file);

}  // namespace falciform::bench
