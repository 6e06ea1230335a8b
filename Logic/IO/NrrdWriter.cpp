#include <fstream>
#include <set>
#include <sstream>
#include <type_traits>

#include "Logic/IO/Deflate.h"
#include "Logic/IO/NrrdFile.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

std::string vectorText(const Vector3d& v) {
  return "(" + numberText(v.x()) + "," + numberText(v.y()) + "," + numberText(v.z()) + ")";
}

template <class T>
std::string headerText(const Volume<T>& volume) {
  const Matrix4d& m = volume.worldFromIndex;
  std::ostringstream text;
  text << "NRRD0004\n"
       << "type: " << (std::is_same_v<T, std::uint16_t> ? "unsigned short" : "float") << "\n"
       << "dimension: 3\nspace: left-posterior-superior\n"
       << "sizes: " << volume.size.x() << ' ' << volume.size.y() << ' ' << volume.size.z()
       << "\nspace directions:";
  for (Index axis = 0; axis < 3; ++axis) text << ' ' << vectorText(m.block<3, 1>(0, axis));
  text << "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: "
       << vectorText(m.topRightCorner<3, 1>()) << "\n";
  return text.str();
}

/// 3D Slicer's keys: one segment a label, all in layer 0.
std::string segmentKeys(const LabelMap& map) {
  std::set<std::uint16_t> labels;
  std::uint16_t last = 0;
  for (const std::uint16_t value : map.voxels)
    if (value != last) labels.insert(last = value);
  labels.erase(0);
  std::ostringstream text;
  int segment = 0;
  for (const std::uint16_t label : labels) {
    const std::string start = "Segment" + std::to_string(segment++) + "_";
    text << start << "ID:=Segment_" << label << '\n'
         << start << "Name:=Label " << label << '\n'
         << start << "LabelValue:=" << label << '\n'
         << start << "Layer:=0\n";
  }
  return text.str();
}

}  // namespace

template <class T>
void writeNrrd(const std::filesystem::path& file, const Volume<T>& volume, bool segments) {
  std::ofstream out(file, std::ios::binary);
  out << headerText(volume);
  if constexpr (std::is_same_v<T, std::uint16_t>)
    if (segments) out << segmentKeys(volume);
  out << '\n';
  writeDeflated(out, volume.voxels.data(), volume.voxels.size() * sizeof(T), DeflateFormat::Gzip);
  checkWritten(out);
}

template <class T>
void writeNrrdHeader(const std::filesystem::path& file, const Volume<T>& volume,
                     const std::string& dataName) {
  std::ofstream out(file, std::ios::binary);
  out << headerText(volume) << "data file: " << dataName << "\n\n";
  checkWritten(out);
}

void writeNrrdDisplacements(const std::filesystem::path& file, const DisplacementGrid& grid) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "vectors stand in memory as in the file");
  const Matrix4d& m = grid.worldFromIndex;
  std::ofstream out(file, std::ios::binary);
  out << "NRRD0004\ntype: float\ndimension: 4\nspace: left-posterior-superior\nsizes: 3 " << grid.size.x()
      << ' ' << grid.size.y() << ' ' << grid.size.z() << "\nspace directions: none";
  for (Index axis = 0; axis < 3; ++axis) out << ' ' << vectorText(m.block<3, 1>(0, axis));
  out << "\nkinds: vector domain domain domain\nendian: little\nencoding: gzip\nspace origin: "
      << vectorText(m.topRightCorner<3, 1>()) << "\ndisplacement field type:=resampling\n\n";
  writeDeflated(out, grid.voxels.data(), grid.voxels.size() * sizeof(Eigen::Vector3f), DeflateFormat::Gzip);
  checkWritten(out);
}

template void writeNrrd(const std::filesystem::path&, const LabelMap&, bool);
template void writeNrrd(const std::filesystem::path&, const Image&, bool);
template void writeNrrdHeader(const std::filesystem::path&, const LabelMap&, const std::string&);
template void writeNrrdHeader(const std::filesystem::path&, const Image&, const std::string&);

}  // namespace falciform
