#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <type_traits>
#include <vector>

#include "Logic/IO/Deflate.h"
#include "Logic/IO/NiftiFile.h"

namespace falciform {

namespace {

static_assert(std::endian::native == std::endian::little, "the writers store memory as it is");

constexpr std::size_t kVoxOffset = 352;
using Header = std::array<char, kVoxOffset>;

template <class Stored>
void put(Header& header, std::size_t offset, double value) {
  const auto stored = static_cast<Stored>(value);
  std::memcpy(&header[offset], &stored, sizeof stored);
}

/// Quaternion, qfac and offset of a grid with perpendicular axes (NIfTI-1 "method 2").
void putQform(Header& header, const Matrix3d& axes, const Vector3d& origin) {
  Matrix3d rotation = axes;
  const double qfac = axes.determinant() < 0 ? -1 : 1;
  rotation.col(2) *= qfac;
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;  // a is not stored and read as positive
  put<float>(header, 76, qfac);
  put<std::int16_t>(header, 252, 1);
  const std::array<double, 6> values{q.x(), q.y(), q.z(), origin.x(), origin.y(), origin.z()};
  for (std::size_t i = 0; i < values.size(); ++i) put<float>(header, 256 + 4 * i, values[i] + 0.0);  // no -0
}

void putSform(Header& header, const Matrix4d& ras) {
  put<std::int16_t>(header, 254, 1);
  for (Index row = 0; row < 3; ++row)
    for (Index column = 0; column < 4; ++column)
      put<float>(header, static_cast<std::size_t>(280 + 16 * row + 4 * column), ras(row, column));
}

Header headerOf(const Vector3i& size, const Matrix4d& worldFromIndex, int datatype, int bits) {
  Header header{};
  put<std::int32_t>(header, 0, 348);
  header[38] = 'r';
  const std::array<int, 8> dim{3, size.x(), size.y(), size.z(), 1, 1, 1, 1};
  for (std::size_t d = 0; d < dim.size(); ++d) put<std::int16_t>(header, 40 + 2 * d, dim[d]);
  put<std::int16_t>(header, 70, datatype);
  put<std::int16_t>(header, 72, bits);

  const Matrix4d ras = lpsFromRas() * worldFromIndex;
  const Vector3d spacing = ras.topLeftCorner<3, 3>().colwise().norm();
  const Matrix3d axes = ras.topLeftCorner<3, 3>() * spacing.cwiseInverse().asDiagonal();
  put<float>(header, 76, 1);
  for (Index d = 0; d < 3; ++d) put<float>(header, static_cast<std::size_t>(80 + 4 * d), spacing(d));
  put<float>(header, 108, kVoxOffset);
  put<float>(header, 112, 1);  // scl_slope
  header[123] = 2;             // mm
  putSform(header, ras);
  // A qform cannot say a shear; float32 rounding of a perpendicular grid stays below this.
  if ((axes.transpose() * axes - Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-5)
    putQform(header, axes, ras.topRightCorner<3, 1>());
  std::memcpy(&header[344], "n+1", 4);
  return header;
}

void writeParts(const std::filesystem::path& file, const Header& header, Bytes voxels, bool deflated) {
  const std::array<Bytes, 2> parts{Bytes{header.data(), header.size()}, voxels};
  std::ofstream out(file, std::ios::binary);
  if (deflated) {
    writeDeflated(out, parts.data(), parts.size(), DeflateFormat::Gzip);
  } else {
    for (const Bytes& part : parts)
      out.write(static_cast<const char*>(part.data), static_cast<std::streamsize>(part.count));
  }
  checkWritten(out);
}

}  // namespace

template <class T>
void writeNifti(const std::filesystem::path& file, const Volume<T>& volume, bool deflated) {
  constexpr bool labels = std::is_same_v<T, std::uint16_t>;
  const Header header = headerOf(volume.size, volume.worldFromIndex, labels ? 512 : 16, labels ? 16 : 32);
  writeParts(file, header, {volume.voxels.data(), volume.voxels.size() * sizeof(T)}, deflated);
}

void writeNiftiDisplacements(const std::filesystem::path& file, const DisplacementGrid& grid, bool deflated) {
  Header header = headerOf(grid.size, grid.worldFromIndex, 16, 32);
  put<std::int16_t>(header, 40, 5);     // dim[0]: x, y, z, no time, components
  put<std::int16_t>(header, 50, 3);     // dim[5]
  put<std::int16_t>(header, 68, 1006);  // NIFTI_INTENT_DISPVECT
  put<float>(header, 92, 1);            // pixdim[4] and [5]: said by some readers to be needed
  put<float>(header, 96, 1);
  std::vector<float> components;
  components.reserve(3 * grid.voxels.size());
  for (Index axis = 0; axis < 3; ++axis) {
    const float sign = axis < 2 ? -1.0F : 1.0F;  // LPS to RAS; 0 stays +0, for the bytes' sake
    for (const Eigen::Vector3f& vector : grid.voxels) components.push_back(sign * vector[axis] + 0.0F);
  }
  writeParts(file, header, {components.data(), components.size() * sizeof(float)}, deflated);
}

template void writeNifti(const std::filesystem::path&, const LabelMap&, bool);
template void writeNifti(const std::filesystem::path&, const Image&, bool);

}  // namespace falciform
