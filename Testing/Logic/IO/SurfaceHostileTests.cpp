#include <gmock/gmock.h>
#include <cstring>
#include <limits>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class HostileFiles : public testing::Test {
 protected:
  std::string refusal(const std::string& name, const std::string& bytes) {
    put(folder / name, bytes);
    return refusalOf([&] { (void)readSurface(folder / name); });
  }
  std::string written(const std::string& name) {
    writeSurface(folder / name, fullSurface(), Overwrite::Replace);
    return readTextFile(folder / name);
  }
  TemporaryFolder folder;
};

TEST_F(HostileFiles, MissingEmptyFolderAndUnknownAreToldApart) {
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "no.vtp"); }), HasSubstr("no such file"));
  std::filesystem::create_directory(folder / "f.ply");
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "f.ply"); }), HasSubstr("it is a folder"));
  EXPECT_THAT(refusal("s.docx", "x"), HasSubstr("extension"));
  for (const std::string& extension : surfaceExtensions()) {
    EXPECT_THAT(refusal("s" + extension, ""), HasSubstr("empty")) << extension;
    EXPECT_NE(refusal("s" + extension, "this is no surface\n"), "no error") << extension;
    EXPECT_NE(refusal("s" + extension, std::string(300, '\0')), "no error") << extension;
  }
  EXPECT_THAT(refusal("s.obj", "# nothing\n"), HasSubstr("no points"));
}

TEST_F(HostileFiles, TruncationAtAnyLengthIsRefusedInOneLine) {
  for (const std::string name : {"s.vtp", "s.vtk", "s.ply", "s.stl"}) {
    const std::string bytes = written(name);
    for (std::size_t k = 0; k < 150; ++k) {
      const std::size_t length = bytes.size() * k / 150;
      const std::string message = refusal(name, bytes.substr(0, length));
      EXPECT_THAT(message, AllOf(HasSubstr(name), Not(HasSubstr("\n")))) << name << " cut at " << length;
      EXPECT_NE(message, "no error") << name << " cut at " << length;
    }
  }
}

TEST_F(HostileFiles, DataCutOutOfTheMiddleOfAVtpAreMissed) {
  const std::string bytes = written("s.vtp");
  const std::size_t appended = bytes.find("<AppendedData");
  ASSERT_NE(appended, std::string::npos);
  const std::size_t end = bytes.find("</AppendedData>");
  for (std::size_t k = 0; k < 20; ++k) {
    std::string cut = bytes;
    const std::size_t from = appended + 40 + (end - appended - 60) * k / 20;
    cut.erase(from, end - from - 4);
    EXPECT_NE(refusal("s.vtp", cut), "no error") << "from " << from;
  }
}

TEST_F(HostileFiles, NotANumberAndAbsurdCoordinatesAreRefused) {
  EXPECT_THAT(refusal("s.obj", "v 0 0 nan\n"), HasSubstr("finite"));
  EXPECT_THAT(refusal("s.xyz", "0 0 0\n0 inf 0\n"), HasSubstr("finite"));
  EXPECT_THAT(refusal("s.xyz", "x y z 1\n0 0 0\n"), HasSubstr("mixes names"));
  EXPECT_THAT(refusal("s.xyz", "0 0 0\n0 0 1e7\n"), HasSubstr("1e6 mm"));
  std::string stl = written("s.stl");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(stl.data() + 84 + 12, &nan, sizeof nan);
  EXPECT_THAT(refusal("s.stl", stl), HasSubstr("finite"));
}

TEST_F(HostileFiles, WrongArraySizesAndLabelsAreRefused) {
  const std::string head =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 10 0 0 0 10 0\n";
  EXPECT_THAT(refusal("s.vtk", head + "POINT_DATA 2\nSCALARS a float 1\nLOOKUP_TABLE default\n1 2\n"),
              HasSubstr("2 values for 3 points"));
  EXPECT_THAT(refusal("s.vtk", head + "POINT_DATA 3\nFIELD FieldData 1\na 1 2 float\n1 2\n"),
              HasSubstr("values for 3 points"));
  EXPECT_THAT(refusal("s.vtk", head + "POINT_DATA 3\nSCALARS Patch float 1\nLOOKUP_TABLE default\n0 0.5 1\n"),
              HasSubstr("whole numbers"));
  EXPECT_THAT(refusal("s.vtk", head + "POLYGONS 1 4\n3 0 1 3\n"), HasSubstr("names point 3 of 3"));
  EXPECT_THAT(refusal("s.vtk", head + "POLYGONS 1 4\n9 0 1 2\n"), HasSubstr("impossible number of corners"));
  EXPECT_THAT(refusal("s.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"),
              HasSubstr("no surface"));
  EXPECT_THAT(refusal("s.obj", "v 0 0 0\nv 1 0 0\nv 0 9 0\nf 1 2 4\n"), HasSubstr("names point 3"));
  EXPECT_THAT(refusal("s.csv", "x,y,z,Patch\n0,0,0,256\n"), HasSubstr("0 to 255"));
  EXPECT_THAT(refusal("s.csv", "x,y,z\n0,0,0\n1,2\n"), HasSubstr("line 3"));
}

TEST_F(HostileFiles, AnnouncingTooMuchCostsNoMemory) {
  EXPECT_THAT(refusal("s.ply",
                      "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
                      "property float z\nend_header\n1 2 3\n"),
              HasSubstr("truncated"));
  EXPECT_THAT(
      refusal(
          "s.ply",
          "ply\nformat ascii 1.0\nelement ghost 18446744073709551615\nelement vertex 1\nproperty float x\n"
          "property float y\nend_header\n1 2\n"),
      HasSubstr("lack x, y or z"));
  EXPECT_THAT(
      refusal("s.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 99999999999 float\n"),
      HasSubstr("bytes hold"));
  std::string stl = written("s.stl");
  stl[83] = '\x7F';
  EXPECT_THAT(refusal("s.stl", stl), HasSubstr("truncated"));
}

TEST_F(HostileFiles, UnitsThatLookWrongAreWarnedOf) {
  put(folder / "s.xyz", "# SPACE=LPS\n0 0 0\n0.2 0.1 0\n");
  EXPECT_THAT(readSurface(folder / "s.xyz").warnings, testing::ElementsAre(HasSubstr("scale it by 1000")));
  put(folder / "s.xyz", "# SPACE=LPS\n0 0 0\n200000 0 0\n");
  EXPECT_THAT(readSurface(folder / "s.xyz").warnings, testing::ElementsAre(HasSubstr("scale it by 0.001")));
}

TEST_F(HostileFiles, AnInvalidSurfaceIsNotWritten) {
  Surface surface = fullSurface();
  surface.patch.pop_back();
  for (const char* name : {"s.vtp", "s.ply"})
    EXPECT_THROW(writeSurface(folder / name, surface, Overwrite::Refuse), InputError);
  EXPECT_THROW(writeSurface(folder / "s.xyz", fullSurface(), Overwrite::Refuse), InputError);
  EXPECT_THROW(writeSurface(folder / "s.vtp", {}, Overwrite::Refuse), InputError);
  EXPECT_EQ(entriesIn(folder.path()), 0);
}

}  // namespace
}  // namespace falciform
