#include "Logic/IO/NiftiFile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "Logic/IO/ByteReader.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

constexpr double kLongestExtensions = 1 << 28;

/// The fields of both versions that we need, as they stand (nifti1.h, nifti2.h).
struct NiftiFields {
  std::array<std::int64_t, 8> dim{};
  std::array<double, 8> pixdim{};
  int datatype = 0, qformCode = 0, sformCode = 0, units = 0;
  double voxOffset = 0, slope = 0, intercept = 0;
  std::array<double, 6> quatern{};  // b, c, d, offset x, y, z
  std::array<double, 12> srow{};
};

/// Reads numbers of the file's byte order out of the header's bytes.
class Fields {
 public:
  Fields(const std::vector<unsigned char>& bytes, bool bigEndian) : bytes_(bytes), bigEndian_(bigEndian) {}

  template <class Stored>
  [[nodiscard]] Stored at(std::size_t offset) const {
    unsigned char ordered[sizeof(Stored)];
    const bool swap = bigEndian_ != (std::endian::native == std::endian::big);
    for (std::size_t b = 0; b < sizeof(Stored); ++b)
      ordered[b] = bytes_[offset + (swap ? sizeof(Stored) - 1 - b : b)];
    return std::bit_cast<Stored>(ordered);
  }
  template <class Stored, class Array>
  void fill(Array& array, std::size_t offset) const {
    for (auto& value : array) {
      value = at<Stored>(offset);
      offset += sizeof(Stored);
    }
  }

 private:
  const std::vector<unsigned char>& bytes_;
  bool bigEndian_;
};

NiftiFields fieldsOfVersion1(const Fields& header) {
  NiftiFields f;
  header.fill<std::int16_t>(f.dim, 40);
  header.fill<float>(f.pixdim, 76);
  header.fill<float>(f.quatern, 256);
  header.fill<float>(f.srow, 280);
  f.datatype = header.at<std::int16_t>(70);
  f.voxOffset = header.at<float>(108);
  f.slope = header.at<float>(112);
  f.intercept = header.at<float>(116);
  f.units = header.at<std::uint8_t>(123);
  f.qformCode = header.at<std::int16_t>(252);
  f.sformCode = header.at<std::int16_t>(254);
  return f;
}

NiftiFields fieldsOfVersion2(const Fields& header) {
  NiftiFields f;
  header.fill<std::int64_t>(f.dim, 16);
  header.fill<double>(f.pixdim, 104);
  header.fill<double>(f.quatern, 352);
  header.fill<double>(f.srow, 400);
  f.datatype = header.at<std::int16_t>(12);
  f.voxOffset = static_cast<double>(header.at<std::int64_t>(168));
  f.slope = header.at<double>(176);
  f.intercept = header.at<double>(184);
  f.units = header.at<std::int32_t>(500);
  f.qformCode = header.at<std::int32_t>(344);
  f.sformCode = header.at<std::int32_t>(348);
  return f;
}

NiftiFields readFields(VolumeLayout& layout) {
  layout.packing = isGzip(layout.file) ? Packing::Deflated : Packing::Raw;
  ByteReader reader(layout.file, 0, layout.packing);
  std::vector<unsigned char> bytes(540);
  bytes.resize(reader.read(bytes.data(), bytes.size()));
  if (bytes.size() < 348)
    refuseVolume(layout.file, "it has " + std::to_string(bytes.size()) +
                                  " bytes, too few for a NIfTI header; copy it again");
  const Fields little(bytes, false), big(bytes, true);
  for (const bool bigEndian : {false, true}) {
    const Fields& header = bigEndian ? big : little;
    const auto size = header.at<std::int32_t>(0);
    layout.bigEndian = bigEndian;
    if (size == 348 && std::memcmp(&bytes[344], "n+1", 4) == 0) return fieldsOfVersion1(header);
    if (size == 540 && bytes.size() == 540 && std::memcmp(&bytes[4], "n+2", 4) == 0)
      return fieldsOfVersion2(header);
    if (size == 348 || size == 540)
      refuseVolume(layout.file,
                   "this is an ANALYZE header or one half of a .hdr/.img pair; convert it to one .nii or "
                   ".nii.gz file");
  }
  refuseVolume(layout.file, "this is no NIfTI file; give a file that begins with a NIfTI header");
}

Scalar scalarOf(const std::filesystem::path& file, int datatype) {
  switch (datatype) {
    case 2:
      return Scalar::UInt8;
    case 4:
      return Scalar::Int16;
    case 8:
      return Scalar::Int32;
    case 16:
      return Scalar::Float32;
    case 64:
      return Scalar::Float64;
    case 256:
      return Scalar::Int8;
    case 512:
      return Scalar::UInt16;
    case 768:
      return Scalar::UInt32;
    case 1024:
      return Scalar::Int64;
    case 1280:
      return Scalar::UInt64;
    case 128:
    case 2304:
      refuseVolume(file, "its voxels are RGB colours; give a volume with one number a voxel");
    case 32:
    case 1792:
    case 2048:
      refuseVolume(file, "its voxels are complex numbers; give a volume with one real number a voxel");
    default:
      refuseVolume(file, "its data type code is " + std::to_string(datatype) +
                             "; convert it to whole or floating-point numbers of 8 to 64 bits");
  }
}

Vector3i sizeOf(const std::filesystem::path& file, const std::array<std::int64_t, 8>& dim) {
  if (dim[0] < 3 || dim[0] > 7)
    refuseVolume(file, "it has " + std::to_string(dim[0]) + " dimensions; give a volume with three");
  for (std::size_t d = 4; d <= static_cast<std::size_t>(dim[0]); ++d)
    if (dim[d] > 1)
      refuseVolume(file,
                   d == 4 ? "it is a time series of " + std::to_string(dim[d]) +
                                " volumes; take one of them out and give that"
                          : "it holds " + std::to_string(dim[d]) + " values a voxel; give a volume with one");
  return checkedSize(file, dim[1], dim[2], dim[3]);
}

void needSpacing(const std::filesystem::path& file, const NiftiFields& f) {
  for (std::size_t d = 1; d <= 3; ++d)
    if (!(f.pixdim[d] > 0) || !std::isfinite(f.pixdim[d]))
      refuseVolume(file, "its pixdim[" + std::to_string(d) + "] is " + shortText(f.pixdim[d]) +
                             "; a spacing must be above 0: correct the header");
}

/// NIfTI "method 2": quaternion, offset and qfac, as nifti_quatern_to_mat44 of the reference library has it.
/// RAS, header units.
Matrix4d fromQform(const std::filesystem::path& file, const NiftiFields& f) {
  needSpacing(file, f);
  const double b = f.quatern[0], c = f.quatern[1], d = f.quatern[2];
  const double squares = b * b + c * c + d * d;
  // float32 rounding may lift the sum above 1 by some 1e-7; more is a damaged header.
  if (!(squares <= 1.001))
    refuseVolume(file, "its qform quaternion has a squared length of " + shortText(squares) +
                           "; it must not be above 1: correct the header");
  Eigen::Quaterniond rotation(std::sqrt(std::max(0.0, 1 - squares)), b, c, d);
  rotation.normalize();
  const double qfac = f.pixdim[0] < 0 ? -1 : 1;
  Matrix4d ras = Matrix4d::Identity();
  ras.topLeftCorner<3, 3>() =
      rotation.toRotationMatrix() * Vector3d(f.pixdim[1], f.pixdim[2], qfac * f.pixdim[3]).asDiagonal();
  ras.topRightCorner<3, 1>() = Vector3d(f.quatern[3], f.quatern[4], f.quatern[5]);
  return ras;
}

Matrix4d fromSform(const NiftiFields& f) {
  Matrix4d ras = Matrix4d::Identity();
  for (Index r = 0; r < 3; ++r)
    for (Index c = 0; c < 4; ++c) ras(r, c) = f.srow[static_cast<std::size_t>(4 * r + c)];
  return ras;
}

/// How far apart two grids put the farthest voxel, in their own units.
double disagreement(const Matrix4d& a, const Matrix4d& b, const Vector3i& size) {
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3i last = size - Vector3i::Ones();
    const Eigen::Vector4d index((corner & 1) * last.x(), (corner >> 1 & 1) * last.y(),
                                (corner >> 2) * last.z(), 1);
    farthest = std::max(farthest, ((a - b) * index).norm());
  }
  return farthest;
}

Matrix4d rasFromIndex(VolumeLayout& layout, const NiftiFields& f) {
  if (f.sformCode > 0) {
    const Matrix4d sform = fromSform(f);
    if (f.qformCode > 0) {
      const double apart = disagreement(sform, fromQform(layout.file, f), layout.size);
      if (apart > 0.1 * sform.topLeftCorner<3, 3>().colwise().norm().minCoeff())
        layout.warnings.push_back("the header's sform and qform lie up to " + shortText(apart) +
                                  " units apart; the sform was used");
    }
    return sform;
  }
  if (f.qformCode > 0) return fromQform(layout.file, f);
  needSpacing(layout.file, f);
  layout.warnings.emplace_back(
      "the header has neither sform nor qform: axes taken as right, anterior, superior with the first voxel "
      "at 0; left and right may be "
      "exchanged");
  return Eigen::Vector4d(f.pixdim[1], f.pixdim[2], f.pixdim[3], 1).asDiagonal();
}

double mmOfHeader(VolumeLayout& layout, int units) {
  switch (units & 7) {
    case 1:
      return 1000;
    case 2:
      return 1;
    case 3:
      return 0.001;
    default:
      layout.warnings.emplace_back("the header does not say its unit of length; mm assumed");
      return 1;
  }
}

}  // namespace

VolumeLayout readNiftiLayout(const std::filesystem::path& file) {
  VolumeLayout layout;
  layout.file = layout.dataFile = file;
  const NiftiFields f = readFields(layout);
  layout.size = sizeOf(file, f.dim);
  layout.scalar = scalarOf(file, f.datatype);
  if (!(f.voxOffset >= 348 && f.voxOffset <= kLongestExtensions))
    refuseVolume(file, "its vox_offset is " + shortText(f.voxOffset) +
                           "; voxels begin at byte 352 or later: correct the header");
  layout.streamOffset = static_cast<std::uint64_t>(f.voxOffset);
  if (f.slope != 0 &&
      std::isfinite(f.slope)) {  // else "no scaling": the standard writes 0, some programs NaN
    layout.slope = f.slope;
    layout.intercept = f.intercept;
  }
  const Matrix4d ras = rasFromIndex(layout, f);
  const double mm = mmOfHeader(layout, f.units);
  layout.worldFromIndex = lpsFromRas() * Eigen::Vector4d(mm, mm, mm, 1).asDiagonal() * ras;
  checkGeometry(layout);
  return layout;
}

}  // namespace falciform
