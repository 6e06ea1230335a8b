#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Fuzz/FuzzTarget.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {

namespace {

/// Formats that we do not write, or write otherwise.
std::string asText(const Surface& surface, const std::string& kind) {
  std::ostringstream text;
  if (kind == "xyz") text << "x y z\n" << surface.points << '\n';
  if (kind == "csv") {
    text << "x,y,z\n";
    for (Index p = 0; p < surface.size(); ++p)
      text << surface.points(p, 0) << ',' << surface.points(p, 1) << ',' << surface.points(p, 2) << '\n';
  }
  if (kind == "vtk") {
    text << "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS " << surface.size() << " float\n"
         << surface.points << "\nPOLYGONS " << surface.triangles.rows() << ' ' << 4 * surface.triangles.rows()
         << '\n';
    for (Index i = 0; i < surface.triangles.rows(); ++i) text << "3 " << surface.triangles.row(i) << '\n';
    text << "POINT_DATA " << surface.size() << "\nSCALARS a float 1\nLOOKUP_TABLE default\n"
         << surface.points.col(0) << '\n';
  }
  if (kind == "ply") {
    text << "ply\nformat ascii 1.0\nelement vertex " << surface.size()
         << "\nproperty float x\nproperty float y\nproperty float z\n"
         << "element face " << surface.triangles.rows()
         << "\nproperty list uchar int vertex_indices\nend_header\n"
         << surface.points << '\n';
    for (Index i = 0; i < surface.triangles.rows(); ++i) text << "3 " << surface.triangles.row(i) << '\n';
  }
  if (kind == "stl") {
    text << "solid\n";
    for (Index i = 0; i < surface.triangles.rows(); ++i) {
      text << "facet normal 0 0 0\nouter loop\n";
      for (Index k = 0; k < 3; ++k) text << "vertex " << surface.points.row(surface.triangles(i, k)) << '\n';
      text << "endloop\nendfacet\n";
    }
    text << "endsolid\n";
  }
  return text.str();
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void readSound(const std::filesystem::path& file) {
  const Surface surface = readSurface(file).value;
  checkSurface(surface, "mutant");
  demand(surface.size() > 0, "a surface without points");
}

}  // namespace

std::vector<FuzzTarget> surfaceTargets() {
  std::vector<FuzzTarget> targets;
  for (const std::string kind : {"ply", "obj", "stl", "vtk", "vtp"})
    targets.push_back({"written_" + kind, "s." + kind,
                       [kind](const std::filesystem::path& folder) {
                         Surface surface = fullSurface();
                         surface.arrays.erase("mean_curvature_per_mm");
                         const std::filesystem::path good = folder / ("good." + kind);
                         writeSurface(good, surface, Overwrite::Refuse);
                         const std::string bytes = contentOf(good);
                         std::filesystem::remove(good);
                         return bytes;
                       },
                       readSound});
  for (const std::string kind : {"ply", "stl", "vtk", "xyz", "csv"})
    targets.push_back({"text_" + kind, "s." + kind,
                       [kind](const std::filesystem::path&) { return asText(sphere(50, 1), kind); },
                       readSound});
  return targets;
}

}  // namespace falciform::test
