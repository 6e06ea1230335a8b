#include "Logic/IO/TrackedPointFiles.h"

#include <gmock/gmock.h>

#include "Logic/Core/Errors.h"
#include "Logic/IO/OutputFile.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Loaded<TrackedPoints> read(const std::string& text, const std::optional<Vector3d>& tip = {}) {
  const test::TemporaryFolder folder;
  writeTextFile(folder / "swab.csv", Overwrite::Refuse, text);
  return readTrackedPoints(folder / "swab.csv", tip);
}

std::string refusal(const std::string& text, const std::optional<Vector3d>& tip = {}) {
  try {
    (void)read(text, tip);
  } catch (const InputError& error) {
    return error.what();
  }
  return "it was taken";
}

TEST(TrackedPoints, ColumnsAreFoundByNameInAnyOrderAndUnit) {
  const auto loaded = read("Tool,Z_cm,y_cm,X_cm\nstylus,3,2,1\nstylus,-3,-2,-1.5\nstylus,3,9,10\n");
  const TrackedPoints& tracked = loaded.value;
  ASSERT_EQ(tracked.size(), 3);
  EXPECT_EQ(Vector3d(tracked.points.row(0)), Vector3d(10, 20, 30));
  EXPECT_EQ(Vector3d(tracked.points.row(1)), Vector3d(-15, -20, -30));
  EXPECT_EQ(tracked.frame, "tracker");
  EXPECT_EQ(tracked.seconds.size(), 0);
  EXPECT_THAT(loaded.warnings, IsEmpty());
}

TEST(TrackedPoints, ThreeNamelessColumnsAreAPlaceAndSemicolonsAllowDecimalCommas) {
  EXPECT_EQ(read("1,2,3\n4,5,60\n").value.size(), 2);
  EXPECT_EQ(Vector3d(read("x;y;z\n1,5;2;3\n70;8;9\n").value.points.row(0)), Vector3d(1.5, 2, 3));
}

TEST(TrackedPoints, AStrokeEndsWithItsNameOrWithAPause) {
  const TrackedPoints named = read("x,y,z,swab\n0,0,0,ridge\n50,0,0,ridge\n60,0,0,groove\n").value;
  EXPECT_THAT(named.stroke, ElementsAre(0, 0, 1));
  EXPECT_THAT(named.strokes, ElementsAre("ridge", "groove"));
  const TrackedPoints timed = read("x,y,z,time_ms\n0,0,0,0\n50,0,0,900\n60,0,0,1950\n").value;
  EXPECT_THAT(timed.stroke, ElementsAre(0, 0, 1));
  EXPECT_THAT(timed.strokes, ElementsAre("stroke 1", "stroke 2"));
  EXPECT_NEAR(timed.seconds[2], 1.95, 1e-12);
}

TEST(TrackedPoints, WhatTheTrackerCallsBadIsLeftOutAndCounted) {
  const auto loaded =
      read("tx,ty,tz,State\n0,0,0,OK\n999,999,999,Missing\n,,,OK\n80,0,0,ok\n1e9,0,0,disabled\n");
  EXPECT_EQ(loaded.value.size(), 2);
  EXPECT_EQ(loaded.value.lost, 3);
  EXPECT_THAT(loaded.warnings, ElementsAre(HasSubstr("3 samples")));
}

TEST(TrackedPoints, ATipOffsetTurnsWithTheTool) {
  // A stylus pivoted about its tip: whatever its turn, the tip stays. The tip is at (0, 0, 150) in the tool.
  const Vector3d tip(12, -40, 77), inTool(0, 0, 150);
  std::string text = "q0,qx,qy,qz,tx,ty,tz\n";
  for (int n = 0; n < 20; ++n) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.3 * n, Vector3d(1, 0.2 * n, -0.5).normalized()));
    const Vector3d origin = tip - turn * inTool;
    for (const double value : {turn.w(), turn.x(), turn.y(), turn.z(), origin.x(), origin.y(), origin.z()}) {
      text += std::to_string(value);
      text += ',';
    }
    text.back() = '\n';
  }
  const TrackedPoints tracked = read(text, inTool).value;
  ASSERT_EQ(tracked.size(), 20);
  for (Index i = 0; i < tracked.size(); ++i)  // six digits of a quaternion times 150 mm
    EXPECT_LT((Vector3d(tracked.points.row(i)) - tip).norm(), 1e-3);
  EXPECT_GT((Vector3d(read(text).value.points.row(0)) - tip).norm(), 100);  // without: the tool's origin
}

TEST(TrackedPoints, ASpaceRemarkNamesTheFrame) {
  EXPECT_EQ(read("# SPACE=LPS\nx,y,z\n1,2,3\n4,5,60\n").value.frame, "LPS");
  const TrackedPoints ras = read("# SPACE=RAS\nx,y,z\n1,2,3\n4,5,60\n").value;
  EXPECT_EQ(ras.frame, "LPS");
  EXPECT_EQ(Vector3d(ras.points.row(0)), Vector3d(-1, -2, 3));
}

TEST(TrackedPoints, MetresAreNoticed) {
  EXPECT_THAT(read("x,y,z\n0,0,0\n0.1,0.2,0.1\n").warnings, ElementsAre(HasSubstr("metres")));
}

TEST(TrackedPoints, WhatIsWrongIsSaidWithItsLine) {
  EXPECT_THAT(refusal("a,b,c\n1,2,3\n"), HasSubstr("name them"));
  EXPECT_THAT(refusal("x,y,z\n1,oops,3\n"), HasSubstr("line 2: 'oops' in column 'y'"));
  EXPECT_THAT(refusal("x,y,z,t\n1,2,3,5\n1,2,3,4\n"), HasSubstr("line 3: the time runs backwards"));
  EXPECT_THAT(refusal("x,y,z\n,,\n"), HasSubstr("no usable sample (1"));
  EXPECT_THAT(refusal("x,y,z\n"), HasSubstr("no usable sample"));
  EXPECT_THAT(refusal("x,y,z\n1,2,3\n", Vector3d(0, 0, 100)), HasSubstr("q0"));
  EXPECT_THAT(refusal("x,y,z,q0,qx,qy,qz\n1,2,3,0,0,0,0\n", Vector3d(0, 0, 100)), HasSubstr("length 0"));
  EXPECT_THAT(refusal("x,y,z\n1e300,0,0\n"), HasSubstr("swab.csv"));
}

}  // namespace
}  // namespace falciform
