#pragma once
#include <filesystem>

#include "Logic/Core/Types.h"

namespace falciform {

/// A pinhole camera that measures distances along its axis: x right, y down, z forward.
struct DepthCamera {
  double fx = 0, fy = 0, cx = 0, cy = 0;  ///< pixels; pixel centres are whole numbers
  int width = 0, height = 0;              ///< of the images that these belong to; 0: not said
  double unitsPerMm = 1;                  ///< of stored depths
};

/// Reads intrinsics: JSON of Open3D ("intrinsic_matrix", column by column) or with fx, fy, cx or ppx, cy or
/// ppy, or "K" row by row, and "depth_scale" (stored units a metre, such as 1000 or TUM's 5000; below 1:
/// metres a unit); or a text "width height" and a 3 x 3 matrix, or "fx fy cx cy". Throws InputError for
/// anything else.
[[nodiscard]] DepthCamera readDepthCamera(const std::filesystem::path& file);

/// Reads where the camera was, tracker from camera, mm: a transform file (TransformFiles.h), or a tracker's
/// XML with <position_camera> of a quaternion x y z w and a translation. Throws InputError for anything else.
[[nodiscard]] Isometry3d readCameraPose(const std::filesystem::path& file);

}  // namespace falciform
