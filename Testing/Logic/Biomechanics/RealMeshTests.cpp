#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

namespace fs = std::filesystem;
using test::realData;
using testing::HasSubstr;

std::vector<fs::path> filesIn(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().string().ends_with(ending)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Filled, near the surface, without inverted elements.
void expectSound(const Surface& liver, double edgeLengthMm, const std::string& name) {
  SCOPED_TRACE(name + " at " + std::to_string(edgeLengthMm) + " mm");
  MeshSettings settings;
  settings.edgeLengthMm = edgeLengthMm;
  LiverMesh made;
  ASSERT_NO_THROW(made = meshLiver(liver, {}, settings));
  EXPECT_NO_THROW(checkMesh(made.mesh, name));
  const MeshReport& report = made.report;
  // Chords cut off a thin lobe's rim: measured 1 % at 10 mm, 5 % at 20 mm.
  EXPECT_NEAR(report.volumeMm3, signedVolume(liver), (edgeLengthMm < 15 ? 0.02 : 0.08) * signedVolume(liver));
  EXPECT_LT(report.meanDistanceMm, 0.08 * edgeLengthMm);
  EXPECT_LT(report.maxDistanceMm, edgeLengthMm / 2);
  EXPECT_GT(report.medianDihedralDeg, 40);
  EXPECT_GT(report.minDihedralDeg, 0);
}

TEST(RealMesh, EveryClosedCohortSurfaceIsFilledAndOpenOnesAreNamed) {
  FALCIFORM_NEEDS_DATA("surfaces");
  int filled = 0, open = 0;
  for (const fs::path& file : filesIn(realData() / "surfaces", ".obj")) {
    const Surface liver = readSurface(file).value;
    if (inspectTopology(liver).closedManifold()) {
      for (const double edge : {10.0, 20.0}) expectSound(liver, edge, file.filename().string());
      ++filled;
      continue;
    }
    ++open;
    try {
      (void)meshLiver(liver, {}, {});
      ADD_FAILURE() << file << " is open and was filled";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(),
                  testing::ContainsRegex("open: [0-9]+ edges have one triangle only, the first at"));
    }
  }
  EXPECT_EQ(filled + open, 19);
  EXPECT_EQ(filled, 11);
}

TEST(RealMesh, EveryPreopOfTheUpdateCasesIsFilled) {
  FALCIFORM_NEEDS_DATA("update");
  int filled = 0;
  for (const auto& entry : fs::directory_iterator(realData() / "update")) {
    if (!fs::exists(entry.path() / "preop.vtp")) continue;
    expectSound(readSurface(entry.path() / "preop.vtp").value, 10, entry.path().filename().string());
    ++filled;
  }
  EXPECT_EQ(filled, 7);
}

class RealLabelMap : public testing::TestWithParam<const char*> {};

TEST_P(RealLabelMap, IsImportedAndFilled) {
  const fs::path file = fs::path("cohort/couinaud") / (std::string("3Dircadb-") + GetParam() + ".nii.gz");
  FALCIFORM_NEEDS_DATA(file);
  const Surface liver = importSurface(readLabelMap(realData() / file).value, {}).surface;
  expectSound(liver, 10, file.filename().string());
}

INSTANTIATE_TEST_SUITE_P(Couinaud, RealLabelMap,
                         testing::Values("2", "3", "4", "5", "6", "7", "8", "9", "10", "17"));

TEST(RealMesh, LoosePiecesAreCountedAndTheLargestIsFilledWithItsTumours) {
  FALCIFORM_NEEDS_DATA("models/patient/liver.vtk");
  const auto read = [](const char* name) { return readSurface(realData() / "models/patient" / name).value; };
  const Surface liver = read("liver.vtk");
  try {
    (void)meshLiver(liver, {}, {});
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("in 6 pieces"));
    EXPECT_THAT(error.what(), HasSubstr("--largest-piece"));
  }
  MeshSettings settings;
  settings.largestPiece = true;
  const Surface tumour = read("liver_tumours.vtk");
  const LiverMesh made = meshLiver(liver, {tumour}, settings);
  // The tumour reaches the surface, so elements are taken by their centres: a twentieth of its volume.
  EXPECT_NEAR(made.report.regions[1].volumeMm3, signedVolume(tumour), 0.05 * signedVolume(tumour));
}

}  // namespace
}  // namespace falciform
