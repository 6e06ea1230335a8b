// `falciform run` to the end: from label map, CT and scan to the liver, its CT and its report as they are
// now.

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;
using testing::Not;

nlohmann::json jsonOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return nlohmann::json::parse(stream);
}

/// Trilinear.
double valueAt(const Image& volume, const Vector3d& place) {
  const Vector3d index = (volume.worldFromIndex.inverse() * place.homogeneous()).head<3>();
  const Vector3i low = index.array().floor().cast<int>();
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3i at = low + Vector3i(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= 1 - std::abs(index[a] - at[a]);
    sum += weight * static_cast<double>(volume.at(at[0], at[1], at[2]));
  }
  return sum;
}

class RunCase : public testing::Test {
 protected:
  /// The built-in liver, coarse, packed under its left lobe on a mesh finer than the update's or, which is
  /// made sooner, bent by a smooth field.
  void make(const char* packingMm) const {
    const Ran ran = falciform({"synthesise", "--out", (folder_ / "case").string(), "--packing", packingMm,
                               "--packed-edge-length", "13", "--edge-length", "4", "--voxel", "4"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
  }
  /// A CT whose values are the places' own x, y or z, so that a look into the bent one says where a place
  /// came from.
  void addCt(int axis) {
    const LabelMap labels = readLabelMap(folder_ / "case/labelmap.nii.gz").value;
    Image ct;
    ct.size = labels.size;
    ct.worldFromIndex = labels.worldFromIndex;
    ct.voxels.resize(labels.voxels.size());
    for (int k = 0; k < ct.size[2]; ++k)
      for (int j = 0; j < ct.size[1]; ++j)
        for (int i = 0; i < ct.size[0]; ++i)
          ct.at(i, j, k) = static_cast<float>((ct.worldFromIndex * Vector3d(i, j, k).homogeneous())[axis]);
    writeImage(folder_ / "case/ct.nrrd", ct, Overwrite::Replace);
    change([](nlohmann::json& json) { json["ct"] = "ct.nrrd"; });
  }
  template <class Change>
  void change(const Change& edit) {
    nlohmann::json json = jsonOf(folder_ / "case/case.json");
    edit(json);
    std::ofstream(folder_ / "case/case.json") << json.dump(2);
  }
  Ran runIt(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{
        "run", (folder_ / "case").string(), "--out", (folder_ / "out").string(), "--edge-length",
        "4",   "--mesh-edge-length",        "16"};
    words.insert(words.end(), more.begin(), more.end());
    return falciform(words);
  }

  TemporaryFolder folder_;
};

TEST_F(RunCase, CarriesALabelMapAndAScanToTheBentCtAndItsReport) {
  ASSERT_NO_FATAL_FAILURE(make("15"));
  ASSERT_NO_FATAL_FAILURE(addCt(0));
  const Ran ran = runIt({"--images-in", "both"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const std::filesystem::path update = folder_ / "out/update";
  for (const char* name :
       {"updated.vtp", "updated_mesh.vtu", "portal_vein_updated.vtp", "tumour_1_updated.vtp",
        "ct_updated.nrrd", "ct_bent_preop.nrrd", "labels_updated.nii.gz", "labels_bent_preop.nii.gz",
        "displacement.nrrd", "scan_from_preop.tfm", "targets_updated.mrk.json", "targets_updated.csv",
        "update.json"})
    EXPECT_TRUE(std::filesystem::exists(update / name)) << name;

  const nlohmann::json figures = jsonOf(update / "update.json").at("figures");
  EXPECT_EQ(figures, jsonOf(folder_ / "out/run.json").at("figures").at("update"));
  // How near it comes is the update's own tests' business; here targets must land where the table says.
  EXPECT_EQ(figures.at("target_error").at("targets").size(),
            readLandmarks(folder_ / "case/targets.mrk.json").value.points.size());

  const Landmarks before = readLandmarks(folder_ / "case/targets.mrk.json").value,
                  after = readLandmarks(update / "targets_updated.mrk.json").value;
  const Image ct = readImage(update / "ct_updated.nrrd").value,
              bent = readImage(update / "ct_bent_preop.nrrd").value;
  const Isometry3d scanFromPreop = readTransform(update / "scan_from_preop.tfm");
  ASSERT_EQ(before.points.size(), after.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const Vector3d was = before.points[i].position, now = after.points[i].position;
    // mm: a linear field bent once and read between voxels of 4 mm, where strain is a few per cent.
    EXPECT_NEAR(valueAt(ct, now), was.x(), 0.3) << before.points[i].name;
    EXPECT_NEAR(valueAt(bent, scanFromPreop.inverse() * now), was.x(), 0.3) << before.points[i].name;
    EXPECT_GT(figures.at("targets")[i].at("expected_error_mm").get<double>(), 0);
  }
  const std::string report = readTextFile(folder_ / "out/report.html");
  for (const char* words : {"Model update", "error to be expected", "Nowhere is tissue squeezed",
                            "portal vein (middle)", "Expected error (mm)", "Axial cut through the CT"})
    EXPECT_THAT(report, HasSubstr(words));
}

TEST_F(RunCase, WithoutAnUpdateNoneOfAnOlderOneStays) {
  ASSERT_NO_FATAL_FAILURE(make("0"));
  ASSERT_EQ(runIt({"--update-max-iterations", "2"}).exitCode, 0);
  ASSERT_TRUE(std::filesystem::exists(folder_ / "out/update/updated.vtp"));
  const Ran ran = runIt({"--no-update", "--force"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/preop_on_scan.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/update/updated.vtp"));
  EXPECT_FALSE(jsonOf(folder_ / "out/run.json").at("figures").contains("update"));
  EXPECT_THAT(readTextFile(folder_ / "out/report.html"), Not(HasSubstr("Model update")));
}

TEST_F(RunCase, AnOpenSurfaceIsRegisteredAndTheUpdateLeftOutInWords) {
  ASSERT_NO_FATAL_FAILURE(make("0"));
  Surface open = readSurface(folder_ / "case/preop_painted.vtp").value;
  open.triangles.conservativeResize(open.triangles.rows() - 40, 3);
  writeSurface(folder_ / "case/open.vtp", open, Overwrite::Refuse);
  change([](nlohmann::json& json) { json["preop"] = "open.vtp"; });
  const Ran ran = runIt();
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.err, HasSubstr("the model was not updated: the pre-op surface must be closed"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/scan_from_preop.tfm"));
}

TEST_F(RunCase, SettingsOfTheUpdateComeFromTheCaseAndArgumentsWin) {
  ASSERT_NO_FATAL_FAILURE(make("0"));
  change([](nlohmann::json& json) {
    json["settings"]["update"] = {{"maxIterations", 3}, {"samplePoints", 300}};
    json["settings"]["mesh"] = {{"edgeLengthMm", 25}};
  });
  const Ran ran = runIt({"--update-sample-points", "400"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const nlohmann::json settings = jsonOf(folder_ / "out/run.json").at("settings");
  EXPECT_EQ(settings.at("update").at("maxIterations"), 3);
  EXPECT_EQ(settings.at("update").at("samplePoints"), 400);
  EXPECT_EQ(settings.at("mesh").at("edgeLengthMm"), 16);
}

}  // namespace
}  // namespace falciform::test
