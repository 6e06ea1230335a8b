#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/IO/MeshFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

class MeshCommand : public testing::Test {
 protected:
  MeshCommand() {
    writeSurface(at("liver.vtp"), sphere(60, 4), Overwrite::Refuse);
    writeSurface(at("one.vtp"), sphere(12, 3, {20, 0, 0}), Overwrite::Refuse);
    writeSurface(at("two.vtp"), sphere(9, 3, {-20, 0, 0}), Overwrite::Refuse);
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  Ran mesh(std::vector<std::string> more, const std::string& liver = "liver.vtp") const {
    std::vector<std::string> words{"mesh", "--preop", at(liver), "--out", at("mesh.vtu")};
    words.insert(words.end(), more.begin(), more.end());
    return falciform(words);
  }
  std::vector<std::string> words(const std::string& liver) const {
    return {"mesh", "--preop", at(liver), "--out", at("mesh.vtu"), "--edge-length", "15"};
  }

  TemporaryFolder folder_;
};

#ifndef FALCIFORM_WITH_TETGEN

TEST_F(MeshCommand, SaysHowToGetTetGenWhereTheBuildIsWithoutIt) {
  expectRefusal(words("liver.vtp"), folder_.path(), "FALCIFORM_WITH_TETGEN");
}

#else

TEST_F(MeshCommand, WritesTheLibrarysMeshWithItsTumours) {
  const Ran ran = mesh({"--tumours", at("one.vtp") + "," + at("two.vtp"), "--edge-length", "15"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  const TetrahedralMesh written = readMesh(at("mesh.vtu")).value;
  MeshSettings settings;
  settings.edgeLengthMm = 15;
  const auto read = [&](const char* name) { return readSurface(at(name)).value; };
  const LiverMesh expected = meshLiver(read("liver.vtp"), {read("one.vtp"), read("two.vtp")}, settings);
  EXPECT_TRUE(written.points == expected.mesh.points && written.elements == expected.mesh.elements);
  EXPECT_EQ(written.regions, expected.mesh.regions);
  EXPECT_THAT(ran.out, HasSubstr("tumour 2: "));
}

TEST_F(MeshCommand, SidecarTellsShapeDistanceAndRegions) {
  ASSERT_EQ(mesh({"--tumours", at("one.vtp"), "--order", "linear", "--edge-length", "20", "--report",
                  at("report.json")})
                .exitCode,
            0);
  const auto json = nlohmann::json::parse(readTextFile(at("mesh.vtu.json")));
  EXPECT_EQ(nlohmann::json::parse(readTextFile(at("report.json"))), json);
  EXPECT_EQ(json["settings"]["mesh"]["order"], "linear");
  EXPECT_EQ(json["inputs"].size(), 2U);
  const auto& figures = json["figures"];
  EXPECT_EQ(figures["elements"], readMesh(at("mesh.vtu")).value.size());
  EXPECT_GT(figures["min_dihedral_deg"], 0);
  EXPECT_GT(figures["max_distance_mm"], figures["mean_distance_mm"]);
  EXPECT_EQ(figures["regions"].size(), 2U);
  EXPECT_TRUE(figures["regions"][1]["conforming"]);
}

TEST_F(MeshCommand, DrawsTheMeshCutOpen) {
  ASSERT_EQ(mesh({"--edge-length", "20", "--picture", at("mesh.png")}).exitCode, 0);
  EXPECT_EQ(readTextFile(at("mesh.png")).substr(1, 3), "PNG");
}

TEST_F(MeshCommand, InfoTellsOfTheMesh) {
  ASSERT_EQ(mesh({"--tumours", at("one.vtp"), "--edge-length", "20"}).exitCode, 0);
  const Ran ran = falciform({"info", at("mesh.vtu"), "--report", at("info.json")});
  EXPECT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("quadratic tetrahedral mesh of "));
  EXPECT_THAT(ran.out, HasSubstr("region 1: "));
  const auto made = nlohmann::json::parse(readTextFile(at("mesh.vtu.json")))["figures"];
  const auto told = nlohmann::json::parse(readTextFile(at("info.json")))["figures"];
  for (const char* key : {"elements", "nodes", "volume_mm3", "min_dihedral_deg", "min_scaled_jacobian"})
    EXPECT_EQ(told[key], made[key]) << key;
}

TEST_F(MeshCommand, RefusesBadSurfacesInOneLineAndWritesNothing) {
  Surface open = sphere(60, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 2, 3);
  writeSurface(at("open.vtp"), open, Overwrite::Refuse);
  expectRefusal(words("open.vtp"), folder_.path(), "is open");
  expectRefusal(words("missing.vtp"), folder_.path(), "missing.vtp");
  auto elsewhere = words("liver.vtp");
  writeSurface(at("far.vtp"), sphere(10, 2, {300, 0, 0}), Overwrite::Refuse);
  elsewhere.insert(elsewhere.end(), {"--tumours", at("far.vtp")});
  expectRefusal(elsewhere, folder_.path(), "outside the liver");
  expectRefusal({"mesh", "--preop", at("liver.vtp"), "--out", at("mesh.vtk")}, folder_.path(), ".vtu");
  expectRefusal({"mesh", "--preop", at("liver.vtp"), "--out", at("m.vtu"), "--edge-length", "1"},
                folder_.path(), "[2, 30] mm");
}

TEST_F(MeshCommand, GivesTheSameBitsForAnyNumberOfThreads) {
  ASSERT_EQ(mesh({"--edge-length", "12", "--threads", "1"}).exitCode, 0);
  const std::string one = readTextFile(at("mesh.vtu"));
  ASSERT_EQ(mesh({"--edge-length", "12", "--threads", "3", "--force"}).exitCode, 0);
  EXPECT_EQ(readTextFile(at("mesh.vtu")), one);
}

#endif

}  // namespace
}  // namespace falciform::test
