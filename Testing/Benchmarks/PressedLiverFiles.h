#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// A frame of the depth camera that watched the pressed liver: the points that it saw, in the frame of its
/// tracker, mm. `depthFile`: int32 width and height, then by pixel 4 bytes of colour and uint16 depth, mm,
/// little-endian; `poseFile`: the camera in that frame, quaternion x y z w, then translation. Depths come in
/// whole mm. Throws std::runtime_error for a file that is not like that.
[[nodiscard]] Surface readDepthFrame(const std::filesystem::path& depthFile,
                                     const std::filesystem::path& poseFile);

/// The nodes of an ASCII unstructured grid in VTK's legacy format. Throws as above.
[[nodiscard]] Points readNodes(const std::filesystem::path& file);

}  // namespace falciform::bench
