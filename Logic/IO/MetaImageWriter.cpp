#include <fstream>
#include <sstream>
#include <type_traits>

#include "Logic/IO/Deflate.h"
#include "Logic/IO/MetaImageFile.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

constexpr std::size_t kDigits = 20;  // of the largest 64-bit number

template <class T>
std::string headerText(const Volume<T>& volume) {
  const Vector3d spacing = volume.spacing();
  const Matrix4d& m = volume.worldFromIndex;
  std::ostringstream text;
  text << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData "
          "= True\nTransformMatrix =";
  for (Index axis = 0; axis < 3; ++axis)
    for (Index d = 0; d < 3; ++d) text << ' ' << numberText(m(d, axis) / spacing(axis));
  text << "\nOffset =";
  for (Index d = 0; d < 3; ++d) text << ' ' << numberText(m(d, 3));
  text << "\nCenterOfRotation = 0 0 0\nElementSpacing =";
  for (Index axis = 0; axis < 3; ++axis) text << ' ' << numberText(spacing(axis));
  text << "\nDimSize = " << volume.size.x() << ' ' << volume.size.y() << ' ' << volume.size.z()
       << "\nElementType = " << (std::is_same_v<T, std::uint16_t> ? "MET_USHORT" : "MET_FLOAT") << '\n';
  return text.str();
}

std::string sizeText(std::uint64_t bytes) {
  std::string text = std::to_string(bytes);
  return text.append(kDigits - text.size(), ' ');
}

}  // namespace

template <class T>
void writeMetaImage(const std::filesystem::path& file, const Volume<T>& volume) {
  std::ofstream out(file, std::ios::binary);
  out << headerText(volume) << "CompressedDataSize = ";
  const auto sizeAt = out.tellp();  // known, and filled in, only when all is packed
  out << sizeText(0) << "\nElementDataFile = LOCAL\n";
  const std::uint64_t bytes =
      writeDeflated(out, volume.voxels.data(), volume.voxels.size() * sizeof(T), DeflateFormat::Zlib);
  out.seekp(sizeAt);
  out << sizeText(bytes);
  checkWritten(out);
}

template <class T>
void writeMetaImageHeader(const std::filesystem::path& file, const Volume<T>& volume,
                          const std::string& dataName, std::uint64_t dataBytes) {
  std::ofstream out(file, std::ios::binary);
  out << headerText(volume) << "CompressedDataSize = " << dataBytes << "\nElementDataFile = " << dataName
      << '\n';
  checkWritten(out);
}

template void writeMetaImage(const std::filesystem::path&, const LabelMap&);
template void writeMetaImage(const std::filesystem::path&, const Image&);
template void writeMetaImageHeader(const std::filesystem::path&, const LabelMap&, const std::string&,
                                   std::uint64_t);
template void writeMetaImageHeader(const std::filesystem::path&, const Image&, const std::string&,
                                   std::uint64_t);

}  // namespace falciform
