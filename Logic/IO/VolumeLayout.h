#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// The number types that a volume file may store.
enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

[[nodiscard]] std::size_t bytesOf(Scalar scalar);

/// How the voxels stand in their file: as they are in memory, deflated (gzip or zlib), or as text.
enum class Packing { Raw, Deflated, Text };

/// All that a header says of a volume, whatever its format: what is needed to find, decode and place its
/// voxels.
struct VolumeLayout {
  std::filesystem::path file;      ///< the file that the user named, for messages
  std::filesystem::path dataFile;  ///< the file with the voxels
  std::uint64_t fileOffset = 0;    ///< bytes of `dataFile` before the (packed) data
  std::uint64_t streamOffset = 0;  ///< bytes of the unpacked stream before the first voxel
  Packing packing = Packing::Raw;
  Scalar scalar = Scalar::UInt8;
  bool bigEndian = false;
  Vector3i size = Vector3i::Zero();
  Matrix4d worldFromIndex = Matrix4d::Identity();  ///< LPS mm of a voxel's centre
  double slope = 1, intercept = 0;                 ///< value = slope * stored + intercept
  std::vector<std::string> warnings;
};

/// Throws InputError "'FILE': message".
[[noreturn]] void refuseVolume(const std::filesystem::path& file, const std::string& message);

/// Sizes as a header gives them, each at least 1 and together no more than 2^31 voxels; throws InputError
/// otherwise.
[[nodiscard]] Vector3i checkedSize(const std::filesystem::path& file, std::int64_t i, std::int64_t j,
                                   std::int64_t k);

/// Refuses a geometry that is not finite, singular or beyond 1e6 mm, a slope of 0 or not finite; warns of an
/// extent that looks like metres or micrometres and of axes that are not perpendicular. Every reader's last
/// step.
void checkGeometry(VolumeLayout& layout);

/// diag(-1, -1, 1, 1): from RAS to LPS and back.
[[nodiscard]] Matrix4d lpsFromRas();

}  // namespace falciform
