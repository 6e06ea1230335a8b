#include <gmock/gmock.h>

#include <sstream>

#include "Logic/Geometry/Measures.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/ScanSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

class RangeRasters : public testing::Test {
 protected:
  Surface read(const std::string& name, const std::string& text) {
    put(folder / name, text);
    return readSurface(folder / name).value;
  }
  TemporaryFolder folder;
};

TEST_F(RangeRasters, StanfordGridsFaceTheirScannerAboveZ) {
  Points sheet = tiltedSheet(6, 9);
  sheet.col(1) *= -1;  // y up, as Stanford's
  const Surface scan = read("s.ply", rangeGridOf(sheet, 6, 9, {0, 30}));
  EXPECT_EQ(scan.size(), 52);
  // The corner takes one triangle with it, the inner sample four of the eight triangles of its cells.
  EXPECT_EQ(scan.triangles.rows(), 80 - 1 - 4);
  EXPECT_EQ(facingShare(scan, Vector3d(0, 0, 1e6)), 1);
}

TEST_F(RangeRasters, AStanfordGridOfAnotherSizeThanAnnouncedIsRefused) {
  std::string text = rangeGridOf(tiltedSheet(6, 9), 6, 9, {});
  text.replace(text.find("num_rows 6"), 10, "num_rows 7");
  put(folder / "s.ply", text);
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "s.ply"); }), HasSubstr("num_rows"));
}

TEST_F(RangeRasters, ATextWithNamedRowsAndColumnsIsJoined) {
  std::ostringstream text;
  text << "row,column,x,y,z,intensity\n";
  const Points sheet = tiltedSheet(5, 4);
  for (int i = 19; i >= 0; --i)  // in any order, one missing
    if (i != 6)
      text << i / 4 << ',' << i % 4 << ',' << sheet(i, 0) << ',' << sheet(i, 1) << ',' << sheet(i, 2)
           << ",1\n";
  const Surface scan = read("s.csv", text.str());
  EXPECT_EQ(scan.size(), 19);
  EXPECT_EQ(scan.triangles.rows(), 2 * 4 * 3 - 4);
  EXPECT_EQ(facingShare(scan, Vector3d::Zero()), 1);
  EXPECT_EQ(scan.arrays.count("row") + scan.arrays.count("column"), 0U);
  EXPECT_EQ(scan.arrays.count("intensity"), 1U);
}

TEST_F(RangeRasters, AnAnnouncedRasterTakesNanForMissingSamples) {
  std::ostringstream text;
  text << "# raster 3 4\n";
  const Points sheet = tiltedSheet(3, 4);
  for (Index i = 0; i < 12; ++i)
    if (i == 0)
      text << "nan nan nan\n";
    else
      text << sheet.row(i) << '\n';
  const Surface scan = read("s.xyz", text.str());
  EXPECT_EQ(scan.size(), 11);
  EXPECT_EQ(scan.triangles.rows(), 11);
  put(folder / "short.xyz", "# raster 3 4\n0 0 0\n");
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "short.xyz"); }), HasSubstr("nan nan nan"));
}

TEST_F(RangeRasters, AlmostEmptyRastersAreRefusedRatherThanAllocated) {
  put(folder / "s.csv", "row,column,x,y,z\n0,0,0,0,0\n900000,900000,1,1,1\n");
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "s.csv"); }), HasSubstr("without gaps"));
}

TEST_F(RangeRasters, JumpsInDepthAreNotBridged) {
  Points sheet = tiltedSheet(6, 10);
  for (Index i = 0; i < sheet.rows(); ++i)
    if (sheet(i, 0) >= 5) sheet(i, 2) += 40;  // mm: a step between columns 4 and 5
  const Surface scan = read("s.ply", rangeGridOf(sheet, 6, 10, {}));
  EXPECT_EQ(scan.triangles.rows(), 2 * 5 * 4 * 2);
  // All that is left is as flat as the sheet: its area is that of the two halves.
  EXPECT_NEAR(area(scan), 2 * 5 * 4 * std::sqrt(1.01), 1e-3);
}

}  // namespace
}  // namespace falciform
