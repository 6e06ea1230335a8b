#include "Testing/Logic/IO/VolumeBytes.h"

namespace falciform::test {

std::string goldenGzip() {
  static const char bytes[] =
      "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x63\x64\x62\x66\x61\x65\x63\xe7\xe0\xe4\xe2\xe6"
      "\xe1\xe5\xe3\x17\x10\x14\x12\x16\x11\x15\x13\x97\x00\x00\xa3\x10\x8e\x92\x18\x00\x00\x00";
  return {bytes, sizeof bytes - 1};
}

std::string goldenZlib() {
  static const char bytes[] =
      "\x78\x9c\x63\x64\x62\x66\x61\x65\x63\xe7\xe0\xe4\xe2\xe6\xe1\xe5\xe3\x17\x10\x14\x12\x16"
      "\x11\x15\x13\x97\x00\x00\x0a\x40\x01\x2d";
  return {bytes, sizeof bytes - 1};
}

std::filesystem::path writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

NiftiBytes::NiftiBytes(bool bigEndian) : bigEndian_(bigEndian), header_(352, '\0') {
  put<std::int32_t>(0, 348);
  const int dim[] = {3, 2, 3, 4, 1, 1, 1, 1};
  for (std::size_t d = 0; d < 8; ++d) put<std::int16_t>(40 + 2 * d, dim[d]);
  type(2, 8);
  for (std::size_t d = 0; d < 4; ++d) put<float>(76 + 4 * d, 1);
  put<float>(108, 352);
  put<std::uint8_t>(123, 2);
  header_.replace(344, 4, std::string("n+1\0", 4));
}

NiftiBytes& NiftiBytes::sform(const Eigen::Matrix<double, 3, 4>& ras) {
  put<std::int16_t>(254, 1);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      put<float>(280 + 16 * row + 4 * column, ras(static_cast<Index>(row), static_cast<Index>(column)));
  return *this;
}

NiftiBytes& NiftiBytes::qform(double qfac, const Vector3d& bcd, const Vector3d& offset,
                              const Vector3d& spacing) {
  put<std::int16_t>(252, 1).put<float>(76, qfac);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto i = static_cast<Index>(d);
    put<float>(80 + 4 * d, spacing(i)).put<float>(256 + 4 * d, bcd(i)).put<float>(268 + 4 * d, offset(i));
  }
  return *this;
}

NiftiBytes& NiftiBytes::type(int code, int bits) {
  return put<std::int16_t>(70, code).put<std::int16_t>(72, bits);
}

bool warns(const std::vector<std::string>& warnings, const std::string& text) {
  for (const std::string& warning : warnings)
    if (warning.find(text) != std::string::npos) return true;
  return false;
}

LabelMap smallMap() {
  LabelMap map;
  map.size = {6, 5, 4};
  map.worldFromIndex.topLeftCorner<3, 3>() = Vector3d(-0.75, 0.75, 1.5).asDiagonal();
  for (int v = 0; v < 120; ++v) map.voxels.push_back(static_cast<std::uint16_t>(v % 9));
  return map;
}

}  // namespace falciform::test
