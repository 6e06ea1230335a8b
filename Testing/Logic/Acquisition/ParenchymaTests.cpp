#include "Logic/Acquisition/Parenchyma.h"

#include <gmock/gmock.h>

#include "Logic/Acquisition/LabColour.h"
#include "Logic/Acquisition/TissueModel.h"
#include "Logic/Core/Errors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

Colours one(int r, int g, int b) { return (Colours(1, 3) << r, g, b).finished(); }

TEST(LabColours, AreThePublishedOnes) {
  // Bruce Lindbloom's calculator, sRGB under D65; two decimals.
  for (const auto& [rgb, lab] : {std::pair(one(255, 255, 255), Vector3d(100, 0, 0)),
                                 {one(255, 0, 0), Vector3d(53.24, 80.09, 67.20)},
                                 {one(0, 0, 255), Vector3d(32.30, 79.19, -107.86)},
                                 {one(0, 0, 0), Vector3d(0, 0, 0)}})
    EXPECT_LT((labOf(rgb).row(0).transpose() - lab).norm(), 0.02);
}

TEST(TissueColours, LiverLooksLikeLiverAndItsSurroundingsDoNot) {
  for (const Colours& liver : {one(146, 68, 56), one(90, 40, 32), one(120, 60, 45), one(160, 70, 60)})
    EXPECT_TRUE(looksLikeLiver(labOf(liver).row(0).transpose())) << liver.cast<int>();
  for (const Colours& other : {one(214, 190, 182), one(220, 184, 98), one(150, 154, 160), one(40, 110, 90),
                               one(30, 60, 130), one(235, 235, 230), one(225, 180, 160)})
    EXPECT_FALSE(looksLikeLiver(labOf(other).row(0).transpose())) << other.cast<int>();
}

/// A sheet of 100 x 100 mm: liver left of x = 60, gauze right of it.
Surface twoTissues() {
  Surface scan = grid(100, 100);
  scan.colours.resize(scan.size(), 3);
  for (Index i = 0; i < scan.size(); ++i)
    scan.colours.row(i) = scan.points(i, 0) < 60 ? one(146, 68, 56) : one(214, 190, 182);
  return scan;
}

Parenchyma found(const Surface& scan, const Points& seeds, const ParenchymaPlan& plan = {}) {
  return findParenchyma(scan, scanNeighbours(scan),
                        std::vector<char>(static_cast<std::size_t>(scan.size()), 1), seeds, plan);
}

Points at(double x, double y) { return (Points(1, 3) << x, y, 0).finished(); }

/// Share of the points that are liver exactly where x < `border`, but for those nearer to it than `mm`.
double rightShare(const Surface& scan, const Parenchyma& liver, double border, double mm) {
  double right = 0, all = 0;
  for (Index i = 0; i < scan.size(); ++i) {
    const double x = scan.points(i, 0);
    if (std::abs(x - border) < mm) continue;
    ++all;
    right += (x < border) == (liver.in[static_cast<std::size_t>(i)] != 0);
  }
  return right / all;
}

TEST(ParenchymaByColour, EndsWhereTheColourDoes) {
  const Surface scan = twoTissues();
  for (const Points& seeds : {Points(0, 3), at(20, 30)}) {
    const Parenchyma liver = found(scan, seeds);
    EXPECT_EQ(liver.automatic, seeds.rows() == 0);
    EXPECT_EQ(rightShare(scan, liver, 60, 4), 1);  // mm: four smoothings blur the border
    EXPECT_NEAR(liver.areaMm2, 6000, 300);
  }
}

TEST(ParenchymaByColour, ASeedInPaleTissueBringsThatIn) {
  const Surface scan = twoTissues();
  Points seeds(2, 3);
  seeds << at(20, 30), at(80, 30);
  EXPECT_NEAR(found(scan, seeds).areaMm2, 10000, 1);
}

TEST(ParenchymaByColour, HolesAndStripsAreTakenInAndBridgesCut) {
  Surface scan = twoTissues();
  for (Index i = 0; i < scan.size(); ++i) {
    const double x = scan.points(i, 0), y = scan.points(i, 1);
    const bool highlight = std::hypot(x - 20, y - 20) < 7;  // wider than a strip, but enclosed
    const bool ligament = x > 38 && x < 46;                 // from border to border
    const bool leak = x >= 60 && std::abs(y - 50) < 2;      // a red thread out into the gauze
    const bool blood = std::hypot(x - 85, y - 50) < 10;     // to a red pool
    if (highlight || ligament) scan.colours.row(i) = one(235, 225, 220);
    if (leak || blood) scan.colours.row(i) = one(146, 68, 56);
  }
  const Parenchyma liver = found(scan, at(20, 60), {.bridgeMm = 6});
  EXPECT_GT(rightShare(scan, liver, 60, 6), 0.995);
}

TEST(ParenchymaByFolds, EndsAtAValleyAndNotAtARidge) {
  Surface scan = grid(100, 100);
  for (const double bend : {-1.0, 1.0}) {  // of the part beyond x = 60: up, a valley; down, a ridge
    for (Index i = 0; i < scan.size(); ++i) {
      const double beyond = std::max(scan.points(i, 0) - 60, 0.0);
      scan.points(i, 2) = -bend * beyond;  // 45 degrees
    }
    const Parenchyma liver = found(scan, at(20, 50));
    if (bend < 0) {
      EXPECT_GT(rightShare(scan, liver, 60, 7), 0.99);  // mm: over which folds are told
    } else {
      EXPECT_NEAR(liver.areaMm2, 6000 + 4000 * std::sqrt(2), 10);
    }
    EXPECT_THAT(liver.warnings, testing::Contains(HasSubstr("no colours")));
  }
}

TEST(ParenchymaRefusals, SayWhatToDo) {
  Surface scan = twoTissues();
  EXPECT_THAT([&] { (void)found(scan, at(400, 0)); },
              testing::ThrowsMessage<InputError>(HasSubstr("give a place on it")));
  scan.colours.rowwise() = one(30, 60, 130).row(0);
  EXPECT_THAT([&] { (void)found(scan, Points(0, 3)); },
              testing::ThrowsMessage<InputError>(HasSubstr("--seed")));
}

}  // namespace
}  // namespace falciform
