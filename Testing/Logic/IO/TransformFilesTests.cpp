#include <gmock/gmock.h>

#include <numbers>

#include "Logic/IO/TransformFiles.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

// A quarter turn about z and a shift, as 3D Slicer writes it. ITK stores fixed -> moving, x_m = A x_f + t,
// with A = [0 -1 0; 1 0 0; 0 0 1], t = (10, 20, 30). The points move by the inverse: x = A^T (x' - t).
const std::string kGolden =
    "#Insight Transform File V1.0\n#Transform 0\nTransform: AffineTransform_double_3_3\n"
    "Parameters: 0 -1 0 1 0 0 0 0 1 10 20 30\nFixedParameters: 0 0 0\n";

TEST(TransformFiles, GoldenTfmMovesPointsByTheInverseOfWhatItStores) {
  const TemporaryFolder folder;
  put(folder / "t.tfm", kGolden);
  const Isometry3d targetFromSource = readTransform(folder / "t.tfm");
  // By hand: (11, 22, 33) - t = (1, 2, 3); A^T (1, 2, 3) = (2, -1, 3).
  EXPECT_LT((targetFromSource * Vector3d(11, 22, 33) - Vector3d(2, -1, 3)).norm(), 1e-14);
}

TEST(TransformFiles, GoldenTfmIsWrittenAsItk) {
  const TemporaryFolder folder;
  Matrix4d moving;
  moving << 0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1;
  writeTransform(folder / "t.tfm", Isometry3d(moving).inverse(), "maps pre-op LPS mm to scan mm",
                 Overwrite::Refuse);
  const std::string text = readTextFile(folder / "t.tfm");
  EXPECT_TRUE(text.starts_with("#Insight Transform File V1.0\n#Transform 0\n")) << text;
  EXPECT_THAT(text, HasSubstr("Transform: AffineTransform_double_3_3\n"));
  EXPECT_THAT(text, testing::ContainsRegex("Parameters: -?0 -1 -?0 1 -?0 -?0 -?0 -?0 1 10 20 30\n"));
  EXPECT_THAT(text, HasSubstr("\nFixedParameters: 0 0 0\n"));
  EXPECT_THAT(text, HasSubstr("maps pre-op LPS mm to scan mm"));
}

TEST(TransformFiles, TheCentreOfRotationOfTfmIsHonoured) {
  const TemporaryFolder folder;
  put(folder / "t.tfm",
      "#Insight Transform File V1.0\n#Transform 0\nTransform: MatrixOffsetTransformBase_double_3_3\n"
      "Parameters: 0 -1 0 1 0 0 0 0 1 0 0 0\nFixedParameters: 5 6 7\n");
  const Isometry3d t = readTransform(folder / "t.tfm");
  EXPECT_LT((t * Vector3d(5, 6, 7) - Vector3d(5, 6, 7)).norm(), 1e-14);  // the centre stays
}

class EveryFormat : public testing::TestWithParam<const char*> {};

TEST_P(EveryFormat, ComesBackAsItWas) {
  const TemporaryFolder folder;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Isometry3d pose = randomMotion(seed, 500);
    writeTransform(folder / GetParam(), pose, "maps a to b\nsecond line", Overwrite::Replace);
    // Inverting twice rounds: 1e-12 of 500 mm.
    EXPECT_LT((readTransform(folder / GetParam()).matrix() - pose.matrix()).cwiseAbs().maxCoeff(), 1e-12);
  }
  EXPECT_THAT(readTextFile(folder / GetParam()), HasSubstr("maps a to b second line"));
}

INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat, testing::Values("t.tfm", "t.txt", "t.json"));

TEST(TransformFiles, SixDigitTextsAreTakenAndMadeRigid) {
  const TemporaryFolder folder;
  put(folder / "t.txt",
      "   0.999925   0.0121483 -0.00177009    0.488882\n -0.0121523    0.999924 -0.00228657    0.121214\n"
      " 0.00174218  0.00230791    0.999996  -0.0253342\n 0 0 0 1");
  const Isometry3d t = readTransform(folder / "t.txt");
  EXPECT_LT((t.linear().transpose() * t.linear() - Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(t.linear()(0, 1), 0.0121483, 2e-6);  // within the digits given
}

TEST(TransformFiles, WhatIsNotRigidIsRefused) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& name, const std::string& text) {
    put(folder / name, text);
    return refusalOf([&] { (void)readTransform(folder / name); });
  };
  EXPECT_THAT(refusal("t.txt", "2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1\n"), HasSubstr("not rigid"));
  EXPECT_THAT(refusal("t.txt", "-1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"), HasSubstr("determinant is -1"));
  EXPECT_THAT(refusal("t.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n"), HasSubstr("last row"));
  EXPECT_THAT(refusal("t.txt", "1 0 0 nan\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"), HasSubstr("finite"));
  EXPECT_THAT(refusal("t.txt", "1 0 0 0\n0 1 0 0\n"), HasSubstr("16 numbers"));
  EXPECT_THAT(refusal("t.txt", "one two\n"), HasSubstr("'one'"));
  EXPECT_THAT(refusal("t.json", "{\"m\": 1}"), HasSubstr("matrix"));
  EXPECT_THAT(refusal("t.json", "{\"matrix\": [[1,0],[0,1]]}"), HasSubstr("4 rows of 4"));
  EXPECT_THAT(refusal("t.json", "{\"matrix\": "), HasSubstr("no sound JSON"));
  EXPECT_THAT(refusal("t.tfm", "hello"), HasSubstr("no ITK transform"));
  EXPECT_THAT(refusal("t.tfm", kGolden.substr(0, kGolden.find(" 20 30"))), HasSubstr("truncated"));
  EXPECT_THAT(refusal("t.tfm", kGolden + kGolden), HasSubstr("several"));
  EXPECT_THAT(
      refusal("t.tfm",
              "#Insight Transform File V1.0\nTransform: BSplineTransform_double_3_3\nParameters: 1\n"),
      HasSubstr("BSpline"));
  EXPECT_THAT(refusal("t.h5", "x"), HasSubstr(".tfm"));
  EXPECT_THROW(writeTransform(folder / "x.h5", Isometry3d::Identity(), "", Overwrite::Refuse), InputError);
}

}  // namespace
}  // namespace falciform
