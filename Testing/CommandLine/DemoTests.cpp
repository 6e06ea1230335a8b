#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "Logic/IO/OutputFile.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Coarser than the demo's own, which takes three times as long.
const std::vector<std::string> kCoarse{"--edge-length", "4", "--mesh-edge-length", "16"};

std::vector<std::string> coarse(std::vector<std::string> words) {
  words.insert(words.end(), kCoarse.begin(), kCoarse.end());
  return words;
}

/// One demo, looked at from several sides: it is a long run.
TEST(Demo, MakesCasePicturesAndReportWithoutADisplay) {
  const TemporaryFolder folder;
  const Ran ran = falciform(coarse({"demo", "--out", (folder / "demo").string()}));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  const std::filesystem::path results = folder / "demo" / "results";
  EXPECT_THAT(ran.out, HasSubstr((results / "pictures").string()));

  std::set<std::string> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(results / "pictures")) {
    const RenderedImage image = readPng(entry.path());
    std::set<std::array<int, 3>> colours;
    for (int y = 0; y < image.height; y += 2)
      for (int x = 0; x < image.width; x += 2) colours.insert(image.at(x, y));
    EXPECT_GT(colours.size(), 20u) << entry.path();  // an empty picture holds the background and the notice
    pictures.insert(entry.path().filename().string());
  }
  std::set<std::string> expected{"after.png",          "before.png",        "convergence.png",
                                 "distance_preop.png", "distance_scan.png", "histogram.png",
                                 "preop.png",          "scan.png"};
#ifdef FALCIFORM_WITH_UPDATE
  expected.insert({"update_ct_after.png", "update_ct_before.png", "update_expected.png", "update_inside.png",
                   "update_moved.png", "update_registered.png", "update_scan_after.png",
                   "update_scan_before.png"});
#endif
  EXPECT_EQ(pictures, expected);

  const std::string report = readTextFile(results / "report.html");
  for (const char* link : {"http:", "https:", "src=\"/", "href="}) EXPECT_THAT(report, Not(HasSubstr(link)));
  for (const char* words : {"data:image/png;base64,iVBORw0KGgo", "not a medical device",
                            "fit, not target error", "SHA-256", "Target error"})
    EXPECT_THAT(report, HasSubstr(words));
  EXPECT_THAT(report, Not(HasSubstr(folder.path().filename().string())));

  const auto json = nlohmann::json::parse(readTextFile(results / "run.json"));
  const auto error = json["figures"]["target_error"];
  // The built-in liver is packed by some 9 mm at most, rigid motion apart: the pose must come close to the
  // best that a rigid motion can do.
  EXPECT_LT(error["mean_mm"].get<double>(), 1.4 * error["optimal_rigid_mean_mm"].get<double>() + 1.0);
  EXPECT_TRUE(json["figures"]["import"]["closed_manifold"]);

  const Ran again = falciform(coarse(
      {"run", (folder / "demo" / "case").string(), "--out", (folder / "again").string(), "--threads", "1"}));
  ASSERT_EQ(again.exitCode, 0) << again.err;
  for (const char* name : {"scan_from_preop.txt", "preop_distance.vtp", "distance.csv"})
    EXPECT_TRUE(readTextFile(folder / "again" / name) == readTextFile(results / name))
        << name << ": run and demo differ";
#ifdef FALCIFORM_WITH_UPDATE
  // The same model update and the same bent CT, on one thread and on all.
  for (const char* name : {"updated.vtp", "targets_updated.csv", "ct_updated.nii.gz", "displacement.nrrd"})
    EXPECT_TRUE(readTextFile(folder / "again/update" / name) == readTextFile(results / "update" / name))
        << name << ": run and demo differ";
  const auto update = json["figures"]["update"];
  EXPECT_EQ(update["targets"].size(), error["targets"].size() + 4);  // and four structures
  // A first impression that helps: settled, a fifth nearer than the pose alone, nearer than any rigid motion.
  EXPECT_TRUE(update["converged"].get<bool>()) << update["stop_reason"];
  const double updated = update["target_error"]["mean_mm"];
  EXPECT_LT(updated, 0.8 * error["mean_mm"].get<double>());
  EXPECT_LT(updated, error["optimal_rigid_mean_mm"].get<double>());
#endif
}

}  // namespace
}  // namespace falciform::test
