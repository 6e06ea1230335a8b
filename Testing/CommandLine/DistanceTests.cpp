#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/Core/Results.h"
#include "Logic/IO/CsvTable.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/CommandLine/Program.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;

/// A sphere of radius 50 in LPS, a scan of one of 53 in the scanner's frame, and the pose between.
class Distance : public testing::Test {
 protected:
  Distance() {
    preop_ = sphere(50, 4);
    preop_.patch.assign(static_cast<std::size_t>(preop_.size()), 0);
    for (Index i = 0; i < preop_.size(); ++i)
      if (preop_.points(i, 2) > 40) preop_.patch[static_cast<std::size_t>(i)] = 1;
    const Isometry3d pose = randomMotion(5);
    writeSurface(at("preop.vtp"), preop_, Overwrite::Refuse);
    writeSurface(at("scan.vtp"), transformed(sphere(53, 4), pose, "scanner"), Overwrite::Refuse);
    writeTransform(at("pose.tfm"), pose, "scan from pre-op", Overwrite::Refuse);
    // Segment 3 at x < 0, segment 8 at x > 0, down to 1 mm under the surface; none below z = -25.
    labels_.size = {60, 60, 60};
    labels_.worldFromIndex.topLeftCorner<3, 3>().diagonal() << -2, -2, 2;  // RAS order, as exported
    labels_.worldFromIndex.topRightCorner<3, 1>() << 59, 59, -59;
    for (int k = 0; k < 60; ++k)
      for (int j = 0; j < 60; ++j)
        for (int i = 0; i < 60; ++i) {
          const Vector3d p = labels_.world(Vector3d(i, j, k));
          labels_.voxels.push_back(static_cast<std::uint16_t>(p.norm() > 49 || p.z() < -25 ? 0
                                                              : p.x() < 0                  ? 3
                                                                                           : 8));
        }
    writeLabelMap(at("segments.nii.gz"), labels_, Overwrite::Refuse);
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
  [[nodiscard]] Ran run(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"distance",    "--preop",      at("preop.vtp"), "--scan", at("scan.vtp"),
                                   "--transform", at("pose.tfm"), "--out",         at("map")};
    words.insert(words.end(), more.begin(), more.end());
    return falciform(words);
  }

  TemporaryFolder folder_;
  Surface preop_;
  LabelMap labels_;
};

TEST_F(Distance, OfASphereGrownBy3MmIsPlus3InEveryRowOfTheTable) {
  const Ran ran = run({"--segments", at("segments.nii.gz")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const CsvTable table = readCsvTable(at("map/distance.csv"));
  std::vector<std::string> regions;
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    const std::vector<std::string>& cells = table.rows[r].cells;
    regions.push_back(cells[0] + " " + cells[1]);
    EXPECT_NEAR(*table.number(cells[5]), 1, 1e-9);                     // covered
    EXPECT_NEAR(*table.number(cells[7]), 3, 0.01);                     // mean, mm: facets
    EXPECT_NEAR(*table.number(cells[11]), 3, 0.02);                    // least
    EXPECT_NEAR(*table.number(cells[12]), 3, 0.02);                    // greatest
    EXPECT_NEAR(*table.number(cells[16]), 1 / 53.0 - 1 / 50.0, 2e-4);  // mean curvature difference, 1/mm
  }
  EXPECT_THAT(regions,
              testing::ElementsAre("preop all", "preop falciform", "preop segment III", "preop segment VIII",
                                   "scan all", "scan segment III", "scan segment VIII"));
  EXPECT_THAT(ran.out, HasSubstr("+ where the scan lies outside the pre-op surface, - where inside it"));
  EXPECT_THAT(ran.out, HasSubstr("segment VIII"));
  EXPECT_THAT(ran.out, HasSubstr("1/mm"));
}

TEST_F(Distance, SegmentsAreThoseOfTheMapWithinReachAndStandInTheSurfaces) {
  ASSERT_EQ(run({"--segments", at("segments.nii.gz"), "--segment-reach", "4"}).exitCode, 0);
  const Surface written = readSurface(at("map/preop_distance.vtp")).value;
  const VectorXd& segment = written.arrays.at(kCouinaudSegment);
  for (Index i = 0; i < preop_.size(); ++i) {
    const Vector3d p = preop_.points.row(i);  // the file's are in the scanner's frame
    if (p.z() < -30) {
      EXPECT_EQ(segment[i], 0) << p.transpose();
    } else if (p.z() > -20 && std::abs(p.x()) > 2) {
      EXPECT_EQ(segment[i], p.x() < 0 ? 3 : 8) << p.transpose();
    }
  }
  EXPECT_EQ(written.arrays.count(kCurvatureDifference), 1U);
  EXPECT_EQ(readSurface(at("map/scan_distance.vtp")).value.arrays.count(kCouinaudSegment), 1U);
  // What was written is taken again without the map.
  std::filesystem::rename(at("map"), at("first"));
  Surface labelled = preop_;
  labelled.arrays[kCouinaudSegment] = segment;
  writeSurface(at("preop.vtp"), labelled, Overwrite::Replace);
  ASSERT_EQ(run().exitCode, 0);
  const auto regions = [&](const std::string& folder) {
    return nlohmann::json::parse(std::ifstream(at(folder + "/distance.json")))["figures"]["preop"]["regions"];
  };
  EXPECT_EQ(regions("map").size(), 4U);
  EXPECT_EQ(regions("map")[3]["region"], "segment VIII");
  EXPECT_EQ(regions("map")[3]["signed_distance"]["count"], regions("first")[3]["signed_distance"]["count"]);
}

TEST_F(Distance, WithoutCurvatureHasNoneOfIt) {
  const Ran ran = run({"--curvature-radius", "0"});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_EQ(readSurface(at("map/preop_distance.vtp")).value.arrays.count(kCurvatureDifference), 0U);
  EXPECT_THAT(ran.out, Not(HasSubstr("1/mm")));
}

TEST_F(Distance, RefusesASegmentMapOfAnotherPlace) {
  labels_.worldFromIndex(0, 3) += 500;
  writeLabelMap(at("segments.nii.gz"), labels_, Overwrite::Replace);
  const Ran ran = run({"--segments", at("segments.nii.gz")});
  EXPECT_EQ(ran.exitCode, 2);
  EXPECT_THAT(ran.err, HasSubstr("give the segment map of the same CT"));
  EXPECT_FALSE(std::filesystem::exists(at("map/distance.csv")));
}

}  // namespace
}  // namespace falciform::test
