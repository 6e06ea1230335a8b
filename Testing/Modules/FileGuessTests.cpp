#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Jobs/FileGuess.h"

namespace falciform {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(FileGuess, TheExtensionTellsVolumesCloudsAndCases) {
  for (const char* name : {"liver.nii", "liver.nii.gz", "a/b.seg.nrrd", "l.mha", "L.MHD"})
    EXPECT_THAT(guessFileRoles(name), ElementsAre(FileRole::Labels)) << name;
  for (const char* name : {"ct.nii.gz", "portal_CT.nrrd", "patient-3 ct 1mm.mha"})
    EXPECT_THAT(guessFileRoles(name), ElementsAre(FileRole::Ct)) << name;
  EXPECT_THAT(guessFileRoles("structures.nii"), ElementsAre(FileRole::Labels)) << "no word 'ct' in it";
  EXPECT_THAT(guessFileRoles("points.xyz"), ElementsAre(FileRole::Scan));
  EXPECT_THAT(guessFileRoles("case.json"), ElementsAre(FileRole::Case));
}

TEST(FileGuess, TheNameTellsScansSurfacesAndStructuresApart) {
  EXPECT_THAT(guessFileRoles("Scan_03.vtp"), ElementsAre(FileRole::Scan));
  EXPECT_THAT(guessFileRoles("intraop.ply"), ElementsAre(FileRole::Scan));
  EXPECT_THAT(guessFileRoles("preop.vtp"), ElementsAre(FileRole::Preop));
  EXPECT_THAT(guessFileRoles("portal_vein.stl"), ElementsAre(FileRole::Structure));
  EXPECT_THAT(guessFileRoles("scan-landmarks.mrk.json"), ElementsAre(FileRole::ScanLandmarks));
  EXPECT_THAT(guessFileRoles("preop.fcsv"), ElementsAre(FileRole::PreopLandmarks));
  EXPECT_THAT(guessFileRoles("targets.mrk.json"), ElementsAre(FileRole::Targets));
  EXPECT_THAT(guessFileRoles("truth_targets.mrk.json"), ElementsAre(FileRole::TruthTargets));
}

TEST(FileGuess, WhereNothingTellsTheUserIsToBeAsked) {
  EXPECT_GT(guessFileRoles("surface_200.stl").size(), 1u);
  EXPECT_THAT(guessFileRoles("F.mrk.json"), ElementsAre(FileRole::PreopLandmarks, FileRole::ScanLandmarks));
}

TEST(FileGuess, AFolderIsACaseOnlyIfItSaysSo) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(guessFileRoles(folder.path()), IsEmpty());
  std::ofstream(folder / "case.json") << "{}";
  EXPECT_THAT(guessFileRoles(folder.path()), ElementsAre(FileRole::Case));
}

TEST(FileGuess, UnknownKindsAreRefused) {
  for (const char* name : {"notes.txt", "picture.png", "noextension"})
    EXPECT_THAT(guessFileRoles(name), IsEmpty()) << name;
}

}  // namespace
}  // namespace falciform
