// The chain of thesis ch. IV on small bodies: cases to registration, maps, one target, groups.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/CommandLine/FolderContents.h"
#include "Testing/CommandLine/SmallCase.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Two groups of bodies, each larger than the one before: A is pressed in on one side, B on the other.
class CohortChain : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }

  /// A body of its own size and pose; `sign` says which side of it is pressed in.
  void writeCase(const std::string& name, int number, double sign, bool truth) const {
    const SmallCase small = smallCase();
    Surface preop = small.preop;
    preop.points *= 1 + 0.04 * number;
    Surface moved = preop;
    const Points normals = vertexNormals(preop);
    const Vector3d middle = centroid(preop.points);
    const double reach = (preop.points.rowwise() - middle.transpose()).rowwise().norm().maxCoeff();
    for (Index v = 0; v < preop.size(); ++v)
      moved.points.row(v) +=
          sign * 5 * std::sin(3 * (preop.points(v, 0) - middle.x()) / reach) * normals.row(v);
    Isometry3d pose = small.scanFromPreop;
    pose.pretranslate(Vector3d(10.0 * number, -5, 3));
    std::filesystem::create_directories(folder_ / name);
    const Surface scan = transformed(moved, pose, "scanner");
    writeSurface(folder_ / name / "preop.vtp", preop, Overwrite::Replace);
    writeSurface(folder_ / name / "scan.vtp", scan, Overwrite::Replace);
    std::ofstream(folder_ / name / "case.json")
        << json{{"name", name}, {"preop", "preop.vtp"}, {"scan", "scan.vtp"}};
    if (truth) writeSurface(folder_ / name / "truth_surface.vtp", scan, Overwrite::Replace);
  }

  [[nodiscard]] json cohort() const {
    json cases = json::array();
    for (int i = 0; i < 4; ++i) {
      const std::string name = "p" + std::to_string(i + 1);
      cases.push_back({{"case", name}, {"group", i % 2 == 0 ? "A" : "B"}});
    }
    return {{"name", "small"},
            {"target", "p2"},
            {"cases", cases},
            {"settings", {{"normalisation", {{"levels", 4}, {"finestMm", 25.0}}}}}};
  }
  void write(const json& file) const { std::ofstream(folder_ / "cohort.json") << file; }
  void writeCases(bool truth) const {
    for (int i = 0; i < 4; ++i) writeCase("p" + std::to_string(i + 1), i, i % 2 == 0 ? 1 : -1, truth);
  }

  TemporaryFolder folder_;
};

TEST_F(CohortChain, GroupsOfOnePatternAreFoundAndTheTruthStandsBeside) {
  writeCases(true);
  write(cohort());
  const Ran ran = falciform({"cohort", at("cohort.json"), "--out", at("out")});
  ASSERT_EQ(ran.exitCode, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("True normal displacement:"));
  const json figures = json::parse(readTextFile(folder_ / "out/cohort.json"))["figures"];
  for (const char* metric : {"signed_distance", "true_displacement"}) {
    EXPECT_GT(figures[metric]["in_group_mean"].get<double>(), 0.8) << metric;
    EXPECT_LT(figures[metric]["out_group_mean"].get<double>(), -0.5) << metric;
    EXPECT_GT(figures[metric]["overlap_vertices"].get<int>(), 100);
  }
  const std::string tables = readTextFile(folder_ / "out/tables.md"),
                    report = readTextFile(folder_ / "out/report.html");
  for (const char* title : {"Table IV.3", "Table IV.4", "Table IV.5", "Table IV.6", "Table IV.7"})
    EXPECT_THAT(tables, HasSubstr(title));
  EXPECT_THAT(report, HasSubstr("data:image/png;base64,"));
  EXPECT_EQ(lineCount(readTextFile(folder_ / "out/surface_errors.csv")), 1 + 3);
  EXPECT_EQ(lineCount(readTextFile(folder_ / "out/cases.csv")), 1 + 4);

  // The maps on the target give the same matrix by the other road.
  std::ofstream(folder_ / "groups.csv") << "case,group\np1,A\np2,B\np3,A\np4,B\n";
  ASSERT_EQ(falciform({"cohort", "--maps", at("out/true_displacement/maps.csv"), "--groups", at("groups.csv"),
                       "--out", at("again")})
                .exitCode,
            0);
}

TEST_F(CohortChain, MistakesAreOneLineAndLeaveNothing) {
  writeCases(false);
  const auto refused = [&](const json& file, const std::string& mention) {
    SCOPED_TRACE(mention);
    write(file);
    expectRefusal({"cohort", at("cohort.json"), "--out", at("out")}, folder_.path(), mention);
  };
  json file = cohort();
  file["target"] = "p9";
  refused(file, "the target 'p9' is none of the cases");
  file = cohort();
  file["cases"][1]["case"] = "p7";
  refused(file, "case 2: there is no");
  file = cohort();
  file["cases"][1]["case"] = "p1";
  refused(file, "two cases are called 'p1'");
  file = cohort();
  file["cases"][2]["grup"] = "A";
  refused(file, "case 3 has no key 'grup'");
  file = cohort();
  file["cases"][0] = {{"name", "p1"}, {"preop", "p1/preop.vtp"}, {"group", "A"}};
  refused(file, "case 1 has no 'scan'");
  file = cohort();
  file["cases"].erase(file["cases"].begin() + 2, file["cases"].end());
  refused(file, "'cases' must be a list of 3 to 500 cases");
  file = cohort();
  file["settings"]["normalisation"]["levels"] = 0;
  refused(file, "levels");
  write(cohort());
  expectRefusal({"cohort", at("cohort.json"), "--matrix", at("m.csv"), "--out", at("out")}, folder_.path(),
                "--matrix has no meaning beside a cohort");
}

}  // namespace
}  // namespace falciform::test
