#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"
#include "Logic/IO/Loaded.h"

namespace falciform {

/// The files of one frame of a depth camera.
struct DepthFrameFiles {
  std::filesystem::path depth;   ///< .png of 16 bits, or .rgbd (below)
  std::filesystem::path colour;  ///< .png or .jpg of the same view; empty: none
  std::filesystem::path camera;  ///< intrinsics, see readDepthCamera
  std::filesystem::path pose;    ///< see readCameraPose; empty: the scan is in the camera's own frame
};

/// Whether the file is one that holds depths: .rgbd by its extension, .png by its head.
[[nodiscard]] bool isDepthFrame(const std::filesystem::path& file);

/// The other files by the names that people give them. Camera: NAME.json, camera_intrinsic.json,
/// intrinsics.json, camera.json, camera.txt or the only *.calib, beside the depths or one folder up. Colours:
/// "depth" in the file's or its folder's name replaced by "color", "colour" or "rgb". Pose: replaced by
/// "pose"
/// (.txt, .tfm, .json), NAME_pose.txt, or polaris_N.xml for rgbd_N.rgbd. `camera`: the one to
/// take; empty: looked for. Throws InputError if there is none.
[[nodiscard]] DepthFrameFiles depthFrameBeside(const std::filesystem::path& depth,
                                               const std::filesystem::path& camera = {});

/// Reads the frame as readSurface reads a file: one point for each pixel with a depth, joined to triangles,
/// with the photograph as its texture; in the camera's frame ("scanner"), or, with a pose, the tracker's
/// ("tracker"). An .rgbd file is int32 width and height, then for each pixel red, green, blue and an unused
/// byte and a uint16 depth, little-endian; colours that are all 0 are none. Throws InputError for damage, and
/// for images and camera of different sizes.
[[nodiscard]] Loaded<Surface> readSurface(const DepthFrameFiles& files);

}  // namespace falciform
