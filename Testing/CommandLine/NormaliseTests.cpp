#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "Logic/Deformation/Normalisation/SurfaceErrors.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class NormaliseCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] Ran normalise(const std::string& target, const std::string& source,
                              std::vector<std::string> more = {}) const {
    std::vector<std::string> words{"normalise", "--target", at(target), "--source", at(source), "--out",
                                   at("out"),   "--levels", "6",        "--finest", "20"};
    words.insert(words.end(), more.begin(), more.end());
    return falciform(words);
  }

  TemporaryFolder folder_;
};

/// An egg of label 3 in a box of 4 mm voxels, 60 mm along its long axis.
LabelMap egg(double stretch, const Vector3d& centre) {
  LabelMap map;
  map.size = {48, 48, 48};
  map.worldFromIndex.topLeftCorner<3, 3>() *= 4;
  map.voxels.assign(48 * 48 * 48, 0);
  for (int k = 0; k < 48; ++k)
    for (int j = 0; j < 48; ++j)
      for (int i = 0; i < 48; ++i) {
        const Vector3d p = map.world(Vector3d(i, j, k)) - centre;
        const double wide = 40 + 0.15 * p.x();
        if (std::pow(p.x() / (60 * stretch), 2) + (p.y() * p.y() + p.z() * p.z()) / (wide * wide) < 1)
          map.at(i, j, k) = 3;
      }
  return map;
}

TEST_F(NormaliseCommand, BringsALabelMapOntoAnotherPatients) {
  writeLabelMap(folder_ / "target.nii.gz", egg(1, {95, 95, 95}), Overwrite::Replace);
  writeLabelMap(folder_ / "source.nii.gz", egg(1.2, {100, 90, 90}), Overwrite::Replace);
  const Ran run = normalise("target.nii.gz", "source.nii.gz");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const LabelMap target = readLabelMap(folder_ / "target.nii.gz").value,
                 carried = readLabelMap(folder_ / "out/source_labels_on_target.nii.gz").value;
  ASSERT_EQ(carried.size, target.size);
  double both = 0, either = 0;
  for (std::size_t v = 0; v < target.voxels.size(); ++v) {
    both += 2.0 * (target.voxels[v] == 3 && carried.voxels[v] == 3);
    either += (target.voxels[v] == 3) + (carried.voxels[v] == 3);
  }
  EXPECT_GT(both / either, 0.97);  // Dice; a shell of half a voxel all around would leave 0.93
  const json figures = json::parse(readTextFile(folder_ / "out/normalise.json"))["figures"];
  EXPECT_LT(figures["source_to_target_mm"].get<double>(), 0.5);
  EXPECT_GT(figures["least_determinant"].get<double>(), 0);
  EXPECT_THAT(run.out, HasSubstr("say nothing about motion along them"));
}

TEST_F(NormaliseCommand, SurfacesCarryTheirDistancesAndTheTableSaysTheSame) {
  writeSurface(folder_ / "target.vtp", lumpyBody(3), Overwrite::Replace);
  Surface source = lumpyBody(3);
  source.points.col(0) *= 1.2;
  writeSurface(folder_ / "source.vtp", source, Overwrite::Replace);
  const Ran run = normalise("target.vtp", "source.vtp");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const Surface moved = readSurface(folder_ / "out/source_on_target.vtp").value;
  EXPECT_EQ(moved.size(), source.size());
  const double mean = moved.arrays.at("distance_to_target_mm").mean();
  const json figures = json::parse(readTextFile(folder_ / "out/normalise.json"))["figures"];
  EXPECT_NEAR(figures["source_to_target_mm"].get<double>(), mean, 1e-6);
  EXPECT_THAT(readTextFile(folder_ / "out/normalise.csv"), HasSubstr("source_to_target,642,"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/source_labels_on_target.nii.gz"));
}

TEST_F(NormaliseCommand, MutualInformationNeedsTwoImages) {
  writeSurface(folder_ / "liver.vtp", lumpyBody(3), Overwrite::Replace);
  const Ran run = normalise("liver.vtp", "liver.vtp", {"--measure", "mutual-information"});
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_EQ(lineCount(run.err), 1);
  EXPECT_THAT(run.err, HasSubstr("--target-image"));
}

TEST_F(NormaliseCommand, RefusesAnOpenSurfaceInOneLineAndWritesNothing) {
  writeSurface(folder_ / "target.vtp", lumpyBody(3), Overwrite::Replace);
  writeSurface(folder_ / "source.vtp", grid(50, 5), Overwrite::Replace);
  const Ran run = normalise("target.vtp", "source.vtp");
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_EQ(lineCount(run.err), 1);
  EXPECT_THAT(run.err, HasSubstr("the source liver is no closed surface"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace falciform::test
