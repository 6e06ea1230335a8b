#include <gmock/gmock.h>

#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Markups : public testing::Test {
 protected:
  Loaded<Landmarks> read(const std::string& name, const std::string& text) {
    put(folder / name, text);
    return readLandmarks(folder / name);
  }
  std::string refusal(const std::string& name, const std::string& text) {
    return refusalOf([&] { (void)read(name, text); });
  }
  static std::string json(const std::string& system, const std::string& points) {
    return "{\"@schema\": \"x\", \"markups\": [{\"type\": \"Fiducial\", " + system + "\"controlPoints\": [" +
           points + "]}]}";
  }
  TemporaryFolder folder;
};

TEST_F(Markups, ComeBackWithNamesPositionsAndFrame) {
  const Landmarks written{{{"apex, \"left\"", {1.5, -2, 3}}, {"", {0.1, 0.2, 1e-9}}}, "scanner"};
  writeLandmarks(folder / "a.mrk.json", written, Overwrite::Refuse);
  const auto [points, warnings] = readLandmarks(folder / "a.mrk.json");
  EXPECT_THAT(warnings, IsEmpty());
  ASSERT_EQ(points.points.size(), 2u);
  EXPECT_EQ(points.points[0].name, "apex, \"left\"");
  EXPECT_EQ(points.points[0].position, Vector3d(1.5, -2, 3));
  EXPECT_EQ(points.points[1].position, Vector3d(0.1, 0.2, 1e-9));
  EXPECT_EQ(points.frame, "scanner");
}

TEST_F(Markups, AreWrittenAsSchema103InLps) {
  writeLandmarks(folder / "a.mrk.json", {{{"p", {1, 2, 3}}}, "LPS"}, Overwrite::Refuse);
  const nlohmann::json file = readJsonFile(folder / "a.mrk.json");
  EXPECT_THAT(file["@schema"].get<std::string>(), HasSubstr("markups-schema-v1.0.3.json#"));
  const nlohmann::json& markup = file["markups"][0];
  EXPECT_EQ(markup["type"], "Fiducial");
  EXPECT_EQ(markup["coordinateSystem"], "LPS");
  EXPECT_EQ(markup["controlPoints"][0]["position"], nlohmann::json({1.0, 2.0, 3.0}));
  EXPECT_EQ(markup["controlPoints"][0]["positionStatus"], "defined");
}

TEST_F(Markups, RasIsTurnedAndUnplacedPointsAreToldOf) {
  const auto [points, warnings] = read(
      "a.mrk.json",
      json(
          "\"coordinateSystem\": \"RAS\", \"coordinateUnits\": [\"mm\", \"UCUM\", \"millimeter\"], ",
          R"({"label": "a", "position": [1, 2, 3]}, {"label": "b", "position": [0, 0, 0], "positionStatus": "undefined"},
         {"label": "c", "position": null})"));
  ASSERT_EQ(points.points.size(), 1u);
  EXPECT_EQ(points.points[0].position, Vector3d(-1, -2, 3));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("'b'"), HasSubstr("'c'")));
  EXPECT_EQ(read("b.mrk.json", json("\"coordinateUnits\": \"um\", ", R"({"position": [1000, 0, 0]})"))
                .value.points[0]
                .position.x(),
            1);
}

TEST_F(Markups, FcsvIsReadInEitherFrame) {
  const std::string head = "# Markups fiducial file version = 4.11\n# CoordinateSystem = ";
  const std::string rest =
      "\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
      "1,1.5,2,3,0,0,0,1,1,1,0,\"F,1 \"\"x\"\"\",,\n2,-1,-2,-3,0,0,0,1,1,1,0,F-2,,,2,0\n";
  const auto lps = read("a.fcsv", head + "LPS" + rest).value.points;
  ASSERT_EQ(lps.size(), 2u);
  EXPECT_EQ(lps[0].position, Vector3d(1.5, 2, 3));
  EXPECT_EQ(lps[0].name, "F,1 \"x\"");
  EXPECT_EQ(read("b.fcsv", head + "RAS" + rest).value.points[1].position, Vector3d(1, 2, -3));
  EXPECT_EQ(read("c.fcsv", head + "0" + rest).value.points[1].position, Vector3d(1, 2, -3));
  EXPECT_THAT(read("d.fcsv", "1,1,2,3\n").warnings, ElementsAre(HasSubstr("RAS is assumed")));
}

TEST_F(Markups, DamageIsRefused) {
  EXPECT_THAT(refusal("a.mrk.json", "{"), HasSubstr("no sound JSON"));
  for (const char* text :
       {"[]", "{}", "{\"markups\": []}", "{\"markups\": [3]}", "{\"markups\": [{}]}", "null"})
    EXPECT_NE(refusal("a.mrk.json", text), "no error") << text;
  EXPECT_THAT(refusal("a.mrk.json", json("\"coordinateSystem\": \"IJK\", ", "")), HasSubstr("IJK"));
  EXPECT_THAT(refusal("a.mrk.json", json("\"coordinateUnits\": \"m\", ", "")), HasSubstr("coordinateUnits"));
  EXPECT_THAT(refusal("a.mrk.json", json("", R"({"label": "p", "position": [1, 2]})")), HasSubstr("'p'"));
  EXPECT_THAT(refusal("a.mrk.json", json("", R"({"label": "p", "position": [1, 2, "x"]})")),
              HasSubstr("'p'"));
  EXPECT_THAT(refusal("a.mrk.json", json("", R"({"label": "p", "position": [1, 2, 1e300]})")),
              HasSubstr("1e6 mm"));
  EXPECT_THAT(refusal("a.mrk.json", json("", "")), HasSubstr("no placed points"));
  EXPECT_THAT(refusal("a.fcsv", "1,x,2,3\n"), HasSubstr("line 1"));
  EXPECT_THAT(refusal("a.fcsv", "# CoordinateSystem = IJK\n1,1,2,3\n"), HasSubstr("IJK"));
  EXPECT_THAT(refusal("a.csv", "1"), HasSubstr(".mrk.json or .fcsv"));
  EXPECT_THROW(writeLandmarks(folder / "a.fcsv", {}, Overwrite::Refuse), InputError);
}

}  // namespace
}  // namespace falciform
