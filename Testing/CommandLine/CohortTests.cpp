#include <gmock/gmock.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/Core/Draws.h"
#include "Logic/IO/OutputFile.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string thesisFile(const std::string& name) {
  return std::string(FALCIFORM_SOURCE_DIR) + "/Testing/Data/Thesis/" + name;
}

class CohortCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string text(const std::string& name) const { return readTextFile(folder_ / name); }
  [[nodiscard]] json figures(const std::string& out) const {
    return json::parse(text(out + "/cohort.json"))["figures"];
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
  }
  [[nodiscard]] Ran thesisTable(const std::string& table, const std::string& out,
                                std::vector<std::string> more = {}) const {
    std::vector<std::string> words{
        "cohort", "--matrix", thesisFile(table), "--groups", thesisFile("TableIV2Groups.csv"),
        "--out",  at(out)};
    words.insert(words.end(), more.begin(), more.end());
    return falciform(words);
  }

  TemporaryFolder folder_;
};

/// A group's half row of thesis Table IV.7; NaN: not printed.
struct Printed {
  double in, inSd, out, outSd, p;
};

void expectPrinted(const json& group, const Printed& printed) {
  SCOPED_TRACE(group.dump());
  // Half of the last printed place, and 0.001 for the rounding of the 3 to 21 printed correlations that each
  // figure is made of.
  constexpr double tolerance = 0.005 + 0.001;
  const auto near = [&](const json& value, double expected) {
    if (std::isnan(expected))
      EXPECT_TRUE(value.is_null());
    else
      EXPECT_NEAR(value.get<double>(), expected, tolerance);
  };
  near(group["in_group"]["mean"], printed.in);
  near(group["in_group"]["sd"], printed.inSd);
  near(group["out_group"]["mean"], printed.out);
  near(group["out_group"]["sd"], printed.outSd);
  near(group["t_test_pooled"]["p_two_sided"], printed.p);
}

TEST_F(CohortCommand, ThePrintedTablesIv5AndIv6GiveTableIv7) {
  const double none = std::nan("");
  ASSERT_EQ(thesisTable("TableIV5.csv", "distance").exitCode, 0);
  const json distance = figures("distance")["groups"];
  ASSERT_EQ(distance.size(), 3u);
  expectPrinted(distance[0], {0.23, 0.24, -0.09, 0.32, 0.11});
  expectPrinted(distance[1], {0.35, none, -0.11, 0.27, none});
  expectPrinted(distance[2], {0.40, 0.08, 0.00, 0.37, 0.08});
  ASSERT_EQ(thesisTable("TableIV6.csv", "curvature").exitCode, 0);
  const json curvature = figures("curvature")["groups"];
  expectPrinted(curvature[0], {0.27, 0.13, 0.13, 0.14, 0.12});
  expectPrinted(curvature[1], {0.07, none, 0.13, 0.16, none});
  expectPrinted(curvature[2], {0.04, 0.05, 0.10, 0.11, 0.37});
}

TEST_F(CohortCommand, WelchsAndTheExactTestSayOtherThanTheThesis) {
  ASSERT_EQ(thesisTable("TableIV5.csv", "out").exitCode, 0);
  const json groups = figures("out")["groups"];
  // Worked out apart from this program, with unequal variances and by listing all choices of 3 of 10 cases.
  EXPECT_NEAR(groups[0]["t_test_welch"]["p_two_sided"].get<double>(), 0.126800, 1e-6);
  EXPECT_NEAR(groups[2]["t_test_welch"]["p_two_sided"].get<double>(), 0.000479, 1e-6);
  EXPECT_NEAR(groups[0]["permutation_test"]["p_greater"].get<double>(), 12.0 / 120, 1e-12);
  EXPECT_NEAR(groups[0]["permutation_test"]["p_two_sided"].get<double>(), 16.0 / 120, 1e-12);
  EXPECT_NEAR(groups[2]["permutation_test"]["p_greater"].get<double>(), 6.0 / 120, 1e-12);
  EXPECT_TRUE(groups[2]["permutation_test"]["exact"].get<bool>());
  EXPECT_EQ(figures("out")["all_groups"]["permutation_test"]["tried"], 25200);
}

TEST_F(CohortCommand, WritesTablesPictureSidecarAndAReportThatHoldsAllItNeeds) {
  const Ran ran = thesisTable("TableIV5.csv", "out");
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_EQ(ran.err, "");
  EXPECT_THAT(ran.out, HasSubstr("group C: in-group 0.40 ± 0.08 (3 pairs), out-group 0.00 ± 0.37 (21)"));
  std::vector<std::string> names;
  for (const auto& [name, bytes] : contentsOf(folder_ / "out")) names.push_back(name);
  EXPECT_THAT(names, ElementsAre("cohort.json", "correlation.csv", "correlation.svg", "groups.csv",
                                 "leave_one_out.csv", "likeness.csv", "report.html"));
  EXPECT_EQ(lineCount(text("out/groups.csv")), 1 + 4);
  EXPECT_EQ(lineCount(text("out/leave_one_out.csv")), 1 + 10 * 4);
  EXPECT_EQ(json::parse(text("out/cohort.json"))["inputs"].size(), 2u);

  const std::string report = text("out/report.html"), svg = text("out/correlation.svg");
  for (const char* words : {"Table IV.7", "0.23 ± 0.24", "all 120 arrangements", "Research use only"})
    EXPECT_THAT(report, HasSubstr(words));
  for (const char* link : {"src=", "href=", "@import", "url("}) EXPECT_THAT(report, Not(HasSubstr(link)));
  EXPECT_THAT(report, HasSubstr(svg));
  const auto root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(svg.c_str()));
  ASSERT_NE(root, nullptr);
  EXPECT_STREQ(root->GetName(), "svg");
}

TEST_F(CohortCommand, TheMatrixThatIsWrittenGivesTheSameResultAgain) {
  ASSERT_EQ(thesisTable("TableIV6.csv", "first").exitCode, 0);
  ASSERT_EQ(falciform({"cohort", "--matrix", at("first/correlation.csv"), "--groups",
                       thesisFile("TableIV2Groups.csv"), "--out", at("second")})
                .exitCode,
            0);
  EXPECT_EQ(text("first/groups.csv"), text("second/groups.csv"));
  EXPECT_EQ(text("first/leave_one_out.csv"), text("second/leave_one_out.csv"));
}

TEST_F(CohortCommand, MapsAreCorrelatedWhereAllCasesCoverThem) {
  // Two patterns over 40 vertices; each case is one of them, scaled, with some noise, and uncovered
  // somewhere.
  Draws draws(5);
  std::string maps = "vertex,a1,b1,a2,b2,b3\n";
  for (int v = 0; v < 40; ++v) {
    maps += std::to_string(v);
    for (int c = 0; c < 5; ++c) {
      const bool first = c == 0 || c == 2;
      const double value = (c + 1) * (std::sin((first ? 0.2 : 0.5) * v) + 0.1 * draws.normal());
      maps += v % 10 == c ? (c % 2 == 0 ? "," : ",nan") : "," + std::to_string(value);
    }
    maps += "\n";
  }
  write("maps.csv", maps);
  write("groups.csv", "group,case\nB,b1\nB,b2\nB,b3\nA,a1\nA,a2\n");
  const Ran ran =
      falciform({"cohort", "--maps", at("maps.csv"), "--groups", at("groups.csv"), "--out", at("out")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("all cases cover 20 of 40 vertices"));
  EXPECT_THAT(ran.err, HasSubstr("no result of the permutation test could be below 0.05"));
  const json found = figures("out");
  EXPECT_EQ(found["overlap_vertices"], 20);
  for (const json& entry : found["cases"]) EXPECT_EQ(entry["group"], entry["most_alike"]);
  EXPECT_GT(found["in_group_mean"].get<double>(), 0.9);
  EXPECT_LT(found["out_group_mean"].get<double>(), 0.5);
  EXPECT_EQ(found["groups"][1]["permutation_test"]["p_greater"].get<double>(), 0.1);  // 1 of 5 choose 3
}

TEST_F(CohortCommand, DrawnArrangementsAreSaidWithTheirSeedAndDoNotDependOnThreads) {
  const auto run = [&](const std::string& out, const std::string& threads, const std::string& seed) {
    const Ran ran =
        thesisTable("TableIV5.csv", out, {"--permutations", "5000", "--threads", threads, "--seed", seed});
    EXPECT_THAT(ran.out, HasSubstr("5001 of 25200 arrangements, drawn with seed " + seed));
    return text(out + "/groups.csv");
  };
  const std::string one = run("one", "1", "3");
  EXPECT_EQ(run("two", "2", "3"), one);
  EXPECT_NE(run("other", "1", "4"), one);
}

TEST_F(CohortCommand, MistakesAreOneLineAndLeaveNothing) {
  const std::string good = "case,a,b,c\na,1,0.5,0.2\nb,,1,-0.1\nc,,,1\n",
                    groups = "case,group\na,X\nb,X\nc,\n";
  const auto refused = [&](const std::string& matrix, const std::string& groupText,
                           const std::string& mention) {
    SCOPED_TRACE(mention);
    write("m.csv", matrix);
    write("g.csv", groupText);
    expectRefusal({"cohort", "--matrix", at("m.csv"), "--groups", at("g.csv"), "--out", at("out")},
                  folder_.path(), mention);
  };
  refused("case,a,b,c\na,1,half,0.2\nb,,1,-0.1\nc,,,1\n", groups, "line 2: 'half' in column 'b'");
  refused("case,a,b,c\na,1,,0.2\nb,,1,-0.1\nc,,,1\n", groups, "'a' and 'b' have no correlation");
  refused("case,a,b,c\na,1,0.5,0.2\nb,0.4,1,-0.1\nc,,,1\n", groups, "0.5 above the diagonal and 0.4 below");
  refused("case,a,b,c\na,1,0.5,0.2\nb,,1,-7\nc,,,1\n", groups, "-7; give a number from -1 to 1");
  refused("case,a,b,c\na,1,0.5,0.2\nb,,1,-0.1\nd,,,1\n", groups, "line 4: case 'd' is not in the head");
  refused("case,a,b,c\na,1,0.5,0.2\nb,,1,-0.1\n", groups, "case 'c' has no row");
  refused("case,a,b,b\na,1,0.5,0.2\n", groups, "'b' stands twice");
  refused("case,a,b,c\na,1,0.5\n", groups, "has 3 cells where the head has 4");
  refused("", groups, "holds no table");
  std::string wide = "case";
  for (int i = 0; i < 100000; ++i) wide += "," + std::to_string(i);
  refused(wide + "\n", groups, "names 100000 cases; 500 are the most");
  refused(good, "case,group\na,X\nb,X\n", "case 'c' has no line");
  refused(good, "name,kind\na,X\n", "no columns 'case' and 'group'");
  refused(good, "case,group\na,X\na,Y\n", "line 3: case 'a' has a group already");
  refused(good, "case,group\na,X\nb,Y\nc,\n", "no group has two cases");
  refused(good, "case,group\na,X\nb,X\nc,X\n", "all cases are of one group");
  write("maps.csv", "a,b,c\n1,2,3\n2,,4\n3,5,nan\n");
  expectRefusal({"cohort", "--maps", at("maps.csv"), "--groups", at("g.csv"), "--out", at("out")},
                folder_.path(), "cover 1 of 3 vertices");
  expectRefusal({"cohort", "--groups", at("g.csv"), "--out", at("out")}, folder_.path(),
                "neither --matrix nor --maps");
  expectRefusal({"cohort", "--matrix", at("m.csv"), "--maps", at("maps.csv"), "--groups", at("g.csv"),
                 "--out", at("out")},
                folder_.path(), "both given");
  expectRefusal({"cohort", "--matrix", at("none.csv"), "--groups", at("g.csv"), "--out", at("out")},
                folder_.path(), "none.csv");
}

TEST_F(CohortCommand, SpeaksWith3DSlicer) {
  const Ran ran =
      thesisTable("TableIV5.csv", "out",
                  {"--permutations", "100000", "--slicer-progress", "--returnparameterfile", at("figures")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, testing::StartsWith("<filter-progress>"));
  EXPECT_THAT(text("figures"), HasSubstr("in_group_mean = 0.322857142857142"));  // 2.26 / 7
}

TEST_F(CohortCommand, InterruptedItLeavesNothing) {
  // Sixty cases in five groups take minutes.
  Draws draws(2);
  std::string matrix = "case", groups = "case,group\n";
  for (int i = 0; i < 60; ++i) {
    matrix += "," + std::to_string(i);
    groups += std::to_string(i) + "," + static_cast<char>('A' + i % 5) + "\n";
  }
  for (int i = 0; i < 60; ++i) {
    matrix += "\n" + std::to_string(i);
    for (int j = 0; j < 60; ++j) matrix += j <= i ? "," : "," + std::to_string(draws.uniform(-1, 1));
  }
  write("m.csv", matrix + "\n");
  write("g.csv", groups);
  const auto before = contentsOf(folder_.path());
  RunOptions options;
  options.interruptWhen = [&] { return contentsOf(folder_.path()).size() > before.size(); };
  const Ran ran = falciform({"cohort", "--matrix", at("m.csv"), "--groups", at("g.csv"), "--out", at("out"),
                             "--permutations", "10000000"},
                            options);
  EXPECT_EQ(ran.exitCode, 130) << ran.err;
  EXPECT_EQ(contentsOf(folder_.path()), before);
}

TEST_F(CohortCommand, GroupsOfCasesThatAreNotThereAreWarnedOf) {
  write("g.csv", readTextFile(thesisFile("TableIV2Groups.csv")) + "3,\n");
  const Ran ran = falciform(
      {"cohort", "--matrix", thesisFile("TableIV5.csv"), "--groups", at("g.csv"), "--out", at("out")});
  ASSERT_EQ(ran.exitCode, 0);
  EXPECT_THAT(ran.err, HasSubstr("case '3' has a group but no correlations"));
}

}  // namespace
}  // namespace falciform::test
