#include <gmock/gmock.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Logic/Registration/Trials/Proportion.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class TrialsCommand : public testing::Test {
 protected:
  TrialsCommand() : truth_(writeSmallCase(folder_.path())) {
    Landmarks targets, places;
    for (int i = 0; i < 4; ++i) {
      const Vector3d target(10.0 * i, 20.0 - 7 * i, 5.0 * i * i);
      targets.points.push_back({"t" + std::to_string(i), target});
      places.points.push_back({"t" + std::to_string(i), truth_.scanFromPreop * target});
    }
    writeLandmarks(at("targets.mrk.json"), targets, Overwrite::Refuse);
    writeLandmarks(at("places.mrk.json"), places, Overwrite::Refuse);
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string text(const std::string& name) const { return readTextFile(folder_ / name); }
  [[nodiscard]] std::vector<std::string> call(const std::string& out, std::vector<std::string> more) const {
    std::vector<std::string> words{"trials",       "--preop", at("preop.vtp"), "--scan",
                                   at("scan.vtp"), "--out",   at(out)};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  [[nodiscard]] std::vector<std::string> withTargets(std::vector<std::string> more) const {
    more.insert(more.end(), {"--targets", at("targets.mrk.json"), "--truth-targets", at("places.mrk.json")});
    return more;
  }
  /// The rows of trials.csv without their last two columns, the times.
  [[nodiscard]] std::vector<std::string> rows(const std::string& out) const {
    std::vector<std::string> lines = linesOf(text(out + "/trials.csv"));
    for (std::string& line : lines) line = line.substr(0, line.rfind(',', line.rfind(',') - 1));
    return lines;
  }
  /// A run of 30 trials, stopped when some of them are done.
  [[nodiscard]] Ran interrupted(const std::string& out) const {
    RunOptions options;
    options.interruptWhen = [&] {
      return std::filesystem::exists(folder_ / out / "trials.partial.csv") &&
             linesOf(text(out + "/trials.partial.csv")).size() > 5;
    };
    return falciform(call(out, kLong), options);
  }

  const std::vector<std::string> kLong{"--methods", "thesis-phantom/icp", "--count", "30"};
  TemporaryFolder folder_;
  SmallCase truth_;
};

TEST_F(TrialsCommand, WritesRowsSummaryHistogramsAndAReportThatHoldsAllItNeeds) {
  const Ran ran = falciform(call("out", withTargets({"--count", "3", "--methods", "icp,picp:1+2"})));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  std::vector<std::string> names;
  for (const auto& [name, bytes] : contentsOf(folder_ / "out")) names.push_back(name);
  EXPECT_THAT(names, ElementsAre("histogram_rms.svg", "histogram_target_error.svg", "report.html",
                                 "summary.json", "trials.csv"));
  EXPECT_THAT(ran.out, HasSubstr("picp:1+2: 3 of 3 succeed"));

  const nlohmann::json summary = nlohmann::json::parse(text("out/summary.json"));
  const nlohmann::json& picp = summary["figures"]["methods"][1];
  EXPECT_EQ(picp["method"], "picp:1+2");
  EXPECT_EQ(picp["successes"], 3);
  EXPECT_EQ(picp["basins"], 1);
  EXPECT_EQ(picp["near_gold"], 3);
  EXPECT_DOUBLE_EQ(picp["success_interval_95"][0].get<double>(), proportionInterval(3, 3).low);
  EXPECT_LT(picp["target_error_mm"]["max"].get<double>(), 0.1);  // exact scan; 1e-3 mm of motion left
  EXPECT_EQ(summary["settings"]["methods"]["picp:1+2"]["patches"], nlohmann::json({1, 2}));
  EXPECT_THAT(summary["figures"]["gold_standard"]["source"].get<std::string>(), HasSubstr("4 targets"));
  EXPECT_EQ(summary["inputs"].size(), 4u);

  const std::vector<std::string> lines = rows("out");
  ASSERT_EQ(lines.size(), 1u + 2 * 3);
  EXPECT_THAT(lines[1], testing::StartsWith("icp,1,"));
  EXPECT_THAT(lines[6], testing::StartsWith("picp:1+2,3,"));

  const std::string report = text("out/report.html");
  EXPECT_THAT(report, HasSubstr("Tables III.1 and III.2"));
  EXPECT_THAT(report, HasSubstr("3 (100.0 %)"));
  EXPECT_THAT(report, HasSubstr("Research use only"));
  for (const char* link : {"src=", "href=", "@import", "url("}) EXPECT_THAT(report, Not(HasSubstr(link)));
  for (const char* name : {"out/histogram_rms.svg", "out/histogram_target_error.svg"}) {
    const std::string svg = text(name);
    const auto root =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(svg.c_str()));
    ASSERT_NE(root, nullptr) << name;
    EXPECT_STREQ(root->GetName(), "svg");
    EXPECT_THAT(report, HasSubstr(svg)) << name;
  }
}

TEST_F(TrialsCommand, WithoutTargetsSuccessIsByResidualAndTheGoldStandardIsTheDefaultRegistration) {
  ASSERT_EQ(falciform(call("out", {"--count", "2", "--methods", "picp"})).exitCode, 0);
  const nlohmann::json figures = nlohmann::json::parse(text("out/summary.json"))["figures"];
  EXPECT_EQ(figures["success_is_by"], "RMS residual");
  EXPECT_THAT(figures["gold_standard"]["source"].get<std::string>(), HasSubstr("default registration"));
  EXPECT_TRUE(figures["methods"][0]["target_error_mm"]["mean"].is_null());
  EXPECT_THAT(text("out/report.html"), HasSubstr("Tables III.5 and III.6"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/histogram_target_error.svg"));
}

TEST_F(TrialsCommand, RowsAreTheSameForAnyThreadsAndAnyNumberAtOnce) {
  const std::vector<std::string> basic{"--count", "2", "--methods", "icp,thesis-phantom/picp:1"};
  const auto run = [&](const std::string& out, std::vector<std::string> more) {
    more.insert(more.end(), basic.begin(), basic.end());
    EXPECT_EQ(falciform(call(out, withTargets(more))).exitCode, 0) << out;
    return rows(out);
  };
  const std::vector<std::string> one = run("one", {"--threads", "1"});
  EXPECT_EQ(run("two", {"--threads", "2"}), one);
  EXPECT_EQ(run("apart", {"--threads", "2", "--at-once", "1"}), one);
  EXPECT_NE(run("seed", {"--seed", "2"}), one);
}

TEST_F(TrialsCommand, GivenGoldStandardAndScaleFileAreUsed) {
  writeTransform(at("gold.txt"), truth_.scanFromPreop, "maps pre-op to scan", Overwrite::Refuse);
  std::ofstream(at("still.json")) << R"({"rotationDeg": 0, "translationMm": 0})";
  ASSERT_EQ(falciform(call("out", withTargets({"--count", "1", "--methods", "icp", "--scale",
                                               at("still.json"), "--gold", at("gold.txt")})))
                .exitCode,
            0);
  const nlohmann::json summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_EQ(summary["settings"]["scale"]["rotationDeg"], 0.0);
  EXPECT_THAT(summary["figures"]["gold_standard"]["source"].get<std::string>(), HasSubstr("given"));
  // ICP from where the scan belongs stays there; files hold single precision at 300 mm.
  EXPECT_LT(summary["figures"]["methods"][0]["target_error_mm"]["max"].get<double>(), 0.01);
}

TEST_F(TrialsCommand, TheCommandIsRecordedWithItsMethodsAndWithoutFolders) {
  ASSERT_EQ(falciform(call("out", {"--methods", "thesis-phantom/icp,icp", "--count", "2"})).exitCode, 0);
  EXPECT_EQ(nlohmann::json::parse(text("out/summary.json"))["command"],
            "falciform trials --preop preop.vtp --scan scan.vtp --out out --methods thesis-phantom/icp,icp "
            "--count 2");
}

TEST_F(TrialsCommand, TruthMayBeOneFile) {
  nlohmann::json truth;
  for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(30, 0, 5), Vector3d(0, 25, -8)}) {
    const Vector3d q = truth_.scanFromPreop * p;
    truth["targets_preop_mm"].push_back({p.x(), p.y(), p.z()});
    truth["targets_scanner_mm"].push_back({q.x(), q.y(), q.z()});
  }
  std::ofstream(at("truth.json")) << truth;
  ASSERT_EQ(
      falciform(call("out", {"--count", "1", "--methods", "picp", "--truth", at("truth.json")})).exitCode, 0);
  const nlohmann::json figures = nlohmann::json::parse(text("out/summary.json"))["figures"];
  EXPECT_EQ(figures["targets"], 3);
  EXPECT_EQ(figures["methods"][0]["successes"], 1);
}

TEST_F(TrialsCommand, StoppedRunKeepsItsTrialsAndTheSameCommandEndsAsIfNothingHadBeen) {
  const Ran stopped = interrupted("out");
  ASSERT_EQ(stopped.exitCode, 130) << stopped.err;
  EXPECT_EQ(lineCount(stopped.err), 1) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("the same command goes on"));
  ASSERT_EQ(contentsOf(folder_ / "out").size(), 1u);
  // A run that was killed in the middle of a line is no worse.
  std::ofstream(at("out/trials.partial.csv"), std::ios::app) << "thesis-phantom/icp,29,0.12";
  // Another seed is not the same command.
  std::vector<std::string> other = call("out", kLong);
  other.insert(other.end(), {"--seed", "2"});
  expectRefusal(other, folder_.path(), "another seed");

  const Ran ended = falciform(call("out", kLong));
  ASSERT_EQ(ended.exitCode, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("continued: "));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/trials.partial.csv"));
  ASSERT_EQ(falciform(call("whole", kLong)).exitCode, 0);
  EXPECT_EQ(rows("out"), rows("whole"));
}

TEST_F(TrialsCommand, ForceBeginsAnewWhereTheSettingsAreOthers) {
  ASSERT_EQ(interrupted("out").exitCode, 130);
  const Ran ran = falciform(call("out", {"--methods", "icp", "--count", "2", "--seed", "2", "--force"}));
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, Not(HasSubstr("continued")));
  EXPECT_EQ(rows("out").size(), 3u);
}

TEST_F(TrialsCommand, MistakesAreOneLineAndLeaveNothing) {
  const auto refused = [&](std::vector<std::string> more, const std::string& mention) {
    SCOPED_TRACE(mention);
    expectRefusal(call("out", std::move(more)), folder_.path(), mention);
  };
  refused({"--methods", "magic"}, "choose icp, ");
  refused({"--methods", "thesis/icp"}, "thesis-phantom");
  refused({"--methods", "picp:1+x"}, "'x'");
  refused({"--methods", "picp:9"}, "patch 9");
  refused({"--scale", "huge"}, "'huge'; choose small, large");
  refused({"--distribution", "gauss"}, "euler or uniform");
  refused({"--targets", at("targets.mrk.json")}, "--truth-targets");
  refused(withTargets({"--truth", "truth.json"}), "--truth holds");
  refused({"--count", "0"}, "[1, 1e+06]");
  std::ofstream(at("bad.json")) << R"({"rotationDeg": 200})";
  refused({"--scale", at("bad.json")}, "[0, 180] deg");
  std::ofstream(at("truth.json")) << R"({"targets_preop_mm": [[1, 2]], "targets_scanner_mm": []})";
  refused({"--truth", at("truth.json")}, "[x, y, z]");
  Surface bare = truth_.scan;
  bare.patch.clear();
  writeSurface(at("bare.vtp"), bare, Overwrite::Refuse);
  expectRefusal({"trials", "--preop", at("preop.vtp"), "--scan", at("bare.vtp"), "--out", at("out")},
                folder_.path(), "no gold standard");
}

}  // namespace
}  // namespace falciform::test
