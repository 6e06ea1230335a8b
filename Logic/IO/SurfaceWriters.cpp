#include <bit>
#include <cstring>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceParts.h"

namespace falciform {

namespace {

// All machines that this program is built for are little endian, as both binary formats are.
static_assert(std::endian::native == std::endian::little);

template <class Number>
void append(std::string& bytes, Number value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

}  // namespace

std::string plyOf(const Surface& surface, const std::string& textureFile) {
  const bool normals = surface.normals.rows() > 0, colours = surface.colours.rows() > 0,
             patches = !surface.patch.empty(), texture = !textureFile.empty();
  std::string bytes = "ply\nformat binary_little_endian 1.0\ncomment " + spaceTagOf(surface) + "\n";
  for (const std::string& comment : patchNameComments(surface)) bytes += "comment " + comment + "\n";
  if (texture) bytes += "comment TextureFile " + textureFile + "\n";
  bytes += "element vertex " + std::to_string(surface.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\n";
  if (normals) bytes += "property double nx\nproperty double ny\nproperty double nz\n";
  if (colours) bytes += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  if (texture) bytes += "property float s\nproperty float t\n";
  if (patches) bytes += "property uchar Patch\n";
  if (surface.triangles.rows() > 0)
    bytes += "element face " + std::to_string(surface.triangles.rows()) +
             "\nproperty list uchar int vertex_indices\n";
  bytes += "end_header\n";
  for (Index i = 0; i < surface.size(); ++i) {
    for (Index k = 0; k < 3; ++k) append(bytes, surface.points(i, k));
    for (Index k = 0; normals && k < 3; ++k) append(bytes, surface.normals(i, k));
    for (Index k = 0; colours && k < 3; ++k) append(bytes, surface.colours(i, k));
    for (Index k = 0; texture && k < 2; ++k) append(bytes, surface.textureAt(i, k));
    if (patches) append(bytes, static_cast<std::uint8_t>(surface.patchAt(i)));
  }
  for (Index i = 0; i < surface.triangles.rows(); ++i) {
    append(bytes, std::uint8_t{3});
    for (Index k = 0; k < 3; ++k) append(bytes, static_cast<std::int32_t>(surface.triangles(i, k)));
  }
  return bytes;
}

std::string objOf(const Surface& surface, const std::string& library) {
  std::string text = "# " + spaceTagOf(surface) + "\n";
  if (!library.empty()) text += "mtllib " + library + "\n";
  for (Index i = 0; i < surface.size(); ++i) {
    text += 'v';
    for (Index k = 0; k < 3; ++k) text += ' ' + numberText(surface.points(i, k));
    text += '\n';
  }
  if (!library.empty()) {
    for (Index i = 0; i < surface.size(); ++i)
      text += surface.textureAt.row(i).allFinite() ? "vt " + numberText(surface.textureAt(i, 0)) + ' ' +
                                                         numberText(surface.textureAt(i, 1)) + '\n'
                                                   : std::string("vt 0 0\n");
    text += "usemtl scan\n";
  }
  for (Index i = 0; i < surface.triangles.rows(); ++i) {
    text += 'f';
    for (Index k = 0; k < 3; ++k) {
      const std::string id = std::to_string(surface.triangles(i, k) + 1);
      const bool placed = !library.empty() && surface.textureAt.row(surface.triangles(i, k)).allFinite();
      text += ' ' + id + (placed ? '/' + id : "");
    }
    text += '\n';
  }
  return text;
}

std::string stlOf(const Surface& surface) {
  if (surface.triangles.rows() == 0)
    throw InputError("STL holds triangles only, and this is a cloud of points; write .ply or .vtp instead");
  // Not "solid ...", by which readers know the text form.
  std::string bytes = ("falciform " + spaceTagOf(surface)).substr(0, 80);
  bytes.resize(80, ' ');
  append(bytes, static_cast<std::uint32_t>(surface.triangles.rows()));
  for (Index i = 0; i < surface.triangles.rows(); ++i) {
    Eigen::Matrix<float, 3, 3, Eigen::RowMajor> corners;
    for (Index k = 0; k < 3; ++k) corners.row(k) = surface.points.row(surface.triangles(i, k)).cast<float>();
    const Vector3d a = surface.points.row(surface.triangles(i, 0)),
                   b = surface.points.row(surface.triangles(i, 1)),
                   c = surface.points.row(surface.triangles(i, 2));
    const Eigen::Vector3f normal = (b - a).cross(c - a).normalized().cast<float>();
    for (Index k = 0; k < 3; ++k) append(bytes, normal[k]);
    for (Index k = 0; k < 9; ++k) append(bytes, corners.data()[k]);
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace falciform
