#include <gtest/gtest.h>

#include <random>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

// Damaged files are refused or read as something sound: never a crash, another exception, or an array of a
// wrong length.

namespace falciform {
namespace {

using namespace test;

std::string mutated(std::string bytes, std::mt19937& random) {
  const auto place = [&] { return random() % bytes.size(); };
  for (unsigned edits = 1 + random() % 4; edits > 0 && !bytes.empty(); --edits) {
    switch (random() % 6) {
      case 0:
        bytes[place()] = static_cast<char>(random() % 256);
        break;
      case 1:
        bytes[place()] ^= static_cast<char>(1 << random() % 8);
        break;
      case 2:
        bytes.erase(place(), 1 + random() % 8);
        break;
      case 3:
        bytes.insert(place(), 1 + random() % 3, static_cast<char>('0' + random() % 10));
        break;
      case 4:
        bytes.resize(place());
        break;
      default: {  // a digit of the head: the counts stand there
        const std::size_t at =
            bytes.find_first_of("0123456789", random() % std::min<std::size_t>(bytes.size(), 400));
        if (at != std::string::npos) bytes[at] = static_cast<char>('0' + random() % 10);
      }
    }
  }
  return bytes;
}

std::string asText(const Surface& surface, const std::string& kind) {
  std::ostringstream text;
  if (kind == "xyz") text << "x y z\n" << surface.points << '\n';
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

void fuzz(const std::string& name, const std::string& bytes, unsigned seed) {
  const TemporaryFolder folder;
  std::mt19937 random(seed);
  int refused = 0, read = 0;
  for (int trial = 0; trial < 300; ++trial) {
    put(folder / name, mutated(bytes, random));
    try {
      const Surface surface = readSurface(folder / name).value;
      checkSurface(surface, name);
      EXPECT_GT(surface.size(), 0);
      ++read;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << name << " trial " << trial << ": " << error.what();
    }
  }
  EXPECT_GT(refused, 30);  // the damage reaches the readers
  EXPECT_EQ(refused + read, 300);
}

class Mutations : public testing::TestWithParam<std::string> {};

TEST_P(Mutations, OfWrittenFilesAreRefusedOrSound) {
  const TemporaryFolder folder;
  Surface surface = fullSurface();
  surface.arrays.erase("mean_curvature_per_mm");
  writeSurface(folder / GetParam(), surface, Overwrite::Refuse);
  fuzz(GetParam(), readTextFile(folder / GetParam()), 11);
}

INSTANTIATE_TEST_SUITE_P(Formats, Mutations, testing::Values("s.ply", "s.obj", "s.stl", "s.vtk", "s.vtp"),
                         [](const auto& format) { return format.param.substr(2); });

class TextMutations : public testing::TestWithParam<std::string> {};

TEST_P(TextMutations, OfHandWrittenFilesAreRefusedOrSound) {
  const Surface small = sphere(50, 1);
  fuzz("s." + GetParam(), asText(small, GetParam()), 12);
}

INSTANTIATE_TEST_SUITE_P(Formats, TextMutations, testing::Values("ply", "stl", "vtk", "xyz"),
                         [](const auto& format) { return format.param; });

}  // namespace
}  // namespace falciform
