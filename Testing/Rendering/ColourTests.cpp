#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "Logic/Acquisition/ScanPreparationLogic.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/PatchColours.h"
#include "Widgets/Rendering/ScalarMap.h"

namespace falciform {

namespace {

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

/// CIE L*a*b* under D65, of an sRGB colour as seen with full protanopia, deuteranopia or tritanopia (0, 1, 2;
/// matrices of Machado, Oliveira and Fernandes 2009, severity 1) or normally (3).
Vector3d labSeen(const Vector3d& srgb, int eye) {
  Matrix3d see[4];
  see[0] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  see[1] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  see[2] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  see[3] = Matrix3d::Identity();
  Matrix3d xyzFromRgb;
  xyzFromRgb << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Vector3d rgb = (see[eye] * srgb.unaryExpr(&linear)).cwiseMax(0).cwiseMin(1);
  const Vector3d xyz = (xyzFromRgb * rgb).cwiseQuotient(Vector3d(0.9505, 1, 1.089));
  const Vector3d f =
      xyz.unaryExpr([](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

double difference(const Vector3d& a, const Vector3d& b, int eye) {
  return (labSeen(a, eye) - labSeen(b, eye)).norm();
}

const ScalarMap kMap{"d", "Distance", "mm", -10, 10, OutOfRange::Grey};

}  // namespace

TEST(PatchColours, FalciformAndRidgeStandOutForEveryEye) {
  for (int eye = 0; eye < 4; ++eye) {
    // 20 in L*a*b* is about ten times the least difference one can see.
    EXPECT_GT(difference(patchColour(1), patchColour(2), eye), 20) << "eye " << eye;
    for (const int label : {1, 2}) {
      EXPECT_GT(difference(patchColour(label), kLiverColour, eye), 20)
          << "eye " << eye << ", label " << label;
      EXPECT_GT(difference(patchColour(label), kScanColour, eye), 20) << "eye " << eye << ", label " << label;
    }
  }
}

TEST(PatchColours, MarksOfAScanAreNotTakenForPatchesOrLiver) {
  for (const ScanMark mark : {ScanMark::Outlier, ScanMark::Grazing, ScanMark::SmallPiece,
                              ScanMark::OtherTissue, ScanMark::ByHand}) {
    const Vector3d colour = patchColour(scan_label::kFirst + static_cast<int>(mark));
    EXPECT_EQ(colour, scanMarkColour(mark));
    for (const int label : {1, 2})
      EXPECT_GT(difference(colour, patchColour(label), 0), 20) << enumToString(mark) << ", label " << label;
    EXPECT_GT(difference(colour, kLiverColour, 0), 20) << enumToString(mark);
  }
}

TEST(DivergingMap, TellsSignsApartForEveryEye) {
  for (int eye = 0; eye < 4; ++eye)
    for (const double value : {3.0, 5.0, 8.0, 10.0})
      EXPECT_GT(difference(colourOf(kMap, value), colourOf(kMap, -value), eye), 15)
          << "eye " << eye << ", " << value;
}

TEST(DivergingMap, IsLightestAtZeroAndDarkensEvenlyToBothEnds) {
  for (const double sign : {-1.0, 1.0}) {
    double last = labSeen(colourOf(kMap, 0), 3).x();
    for (double value = 1; value <= 10; ++value) {
      const double lightness = labSeen(colourOf(kMap, sign * value), 3).x();
      EXPECT_LT(lightness, last) << sign * value;
      last = lightness;
    }
  }
}

TEST(DivergingMap, NoColourOnTheScaleIsTakenForMissing) {
  for (double value = -10; value <= 10; value += 0.05) {
    EXPECT_GT(difference(colourOf(kMap, value), kNoValueColour, 3), 15) << value;
    EXPECT_GT(difference(colourOf(kMap, value), kOffScaleColour, 3), 15) << value;
  }
  EXPECT_GT(difference(kNoValueColour, kOffScaleColour, 3), 15);
}

TEST(DivergingMap, MissingAndOffScaleValuesAreGrey) {
  EXPECT_EQ(colourOf(kMap, std::numeric_limits<double>::quiet_NaN()), kNoValueColour);
  EXPECT_EQ(colourOf(kMap, 10.001), kOffScaleColour);
  EXPECT_EQ(colourOf(kMap, -std::numeric_limits<double>::infinity()), kOffScaleColour);
  EXPECT_NE(colourOf(kMap, 10), kOffScaleColour);
  ScalarMap ends = kMap;
  ends.outOfRange = OutOfRange::Ends;
  EXPECT_GT(colourOf(ends, 11).x(), colourOf(ends, 11).z()) << "beyond the red end stays red";
  EXPECT_LT(colourOf(ends, -11).x(), colourOf(ends, -11).z()) << "beyond the blue end stays blue";
}

TEST(SymmetricMap, HoldsAllSurfacesAndIgnoresMissingValues) {
  Surface a = test::sphere(10, 0), b = a;
  a.arrays["d"] = VectorXd::Constant(12, 1.2);
  b.arrays["d"] = VectorXd::Constant(12, std::numeric_limits<double>::quiet_NaN());
  b.arrays["d"][3] = -4.4;
  const ScalarMap map = symmetricMap("d", "Distance", "mm", {&a, &b});
  EXPECT_EQ(map.high, 5);
  EXPECT_EQ(map.low, -5);
  EXPECT_EQ(symmetricMap("other", "", "", {&a}).high, 1) << "no value at all";
  a.arrays["d"].setConstant(10);
  EXPECT_EQ(symmetricMap("d", "", "", {&a}).high, 10) << "a round end stays";
}

TEST(TickValues, AreRoundAndIncludeZero) {
  EXPECT_THAT(tickValues(-10, 10), testing::ElementsAre(-10, -7.5, -5, -2.5, 0, 2.5, 5, 7.5, 10));
  EXPECT_THAT(tickValues(0, 1, 6),
              testing::ElementsAre(0, testing::DoubleNear(0.2, 1e-12), testing::DoubleNear(0.4, 1e-12),
                                   testing::DoubleNear(0.6, 1e-12), testing::DoubleNear(0.8, 1e-12), 1));
  EXPECT_FALSE(std::signbit(tickValues(-1, 1)[4])) << "not -0";
  EXPECT_EQ(tickValues(3, 3).size(), 1u);
}

TEST(SupportColours, KindsStandOutFromTheLiverAndFromEachOtherForEveryEye) {
  using enum SupportRegionKind;
  for (int eye = 0; eye < 4; ++eye)
    for (const SupportRegionKind kind : {Fixed, Sliding, Pushed}) {
      EXPECT_GT(difference(supportColour(kind, 1), kLiverColour, eye), 20)
          << "eye " << eye << ", " << static_cast<int>(kind);
      for (const SupportRegionKind other : {Fixed, Sliding, Pushed})
        if (other != kind) {
          EXPECT_GT(difference(supportColour(kind, 1), supportColour(other, 2), eye), 20) << "eye " << eye;
        }
    }
}

TEST(MagnitudeMap, GrowsLighterFromNilToARoundEndForEveryEye) {
  const ScalarMap map = magnitudeMap("displacement_mm", "Displacement", "mm", 23.4);
  EXPECT_EQ(map.low, 0);
  EXPECT_EQ(map.high, 30);
  for (int eye = 0; eye < 4; ++eye) {
    double darker = -1;
    for (double value = 0; value <= map.high; value += 3) {
      const double lightness = labSeen(colourOf(map, value), eye)[0];
      EXPECT_GT(lightness, darker) << "eye " << eye << " at " << value;
      darker = lightness;
    }
  }
}

}  // namespace falciform
