#include "Logic/Acquisition/ScanPreparation.h"

#include <gmock/gmock.h>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Logic/Acquisition/OperatingScene.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

std::vector<char> keptOf(const MarkedScan& marked) {
  std::vector<char> kept;
  for (const ScanMark mark : marked.marks) kept.push_back(mark == ScanMark::Kept);
  return kept;
}

Points rowOf(const Vector3d& place) { return Points(place.transpose()); }

class OperatingScenes : public testing::Test {
 protected:
  static const OperatingScene& scene() {
    static const OperatingScene made = makeOperatingScene({.outlierShare = 0.02});
    return made;
  }
};

TEST_F(OperatingScenes, TheLiverIsFoundByItselfAndFromAClick) {
  for (const Points& seeds : {Points(0, 3), rowOf(scene().onLiver)}) {
    const MarkedScan marked = markScan(scene().scan, seeds, std::nullopt, {});
    EXPECT_TRUE(marked.byColour);
    EXPECT_GT(diceOf(keptOf(marked), scene().liver), 0.97) << seeds.rows();
  }
}

TEST_F(OperatingScenes, FalseReturnsGoAndGoodOnesStay) {
  ScanPreparationSettings settings;
  settings.extract = false;
  const MarkedScan marked = markScan(scene().scan, Points(0, 3), std::nullopt, settings);
  double outliers = 0, removed = 0, good = 0, kept = 0;
  for (std::size_t i = 0; i < marked.marks.size(); ++i) {
    const bool stays = marked.marks[i] == ScanMark::Kept;
    if (scene().outlier[i]) {
      ++outliers;
      removed += !stays;
    } else if (scene().liver[i]) {
      ++good;
      kept += stays;
    }
  }
  EXPECT_GT(removed / outliers, 0.97);
  EXPECT_GT(kept / good, 0.97);  // what is lost is the rim that turns away
}

TEST_F(OperatingScenes, MarksDoNotDependOnTheNumberOfThreads) {
  setThreads(1);
  const MarkedScan one = markScan(scene().scan, Points(0, 3), std::nullopt, {});
  setThreads(3);
  const MarkedScan three = markScan(scene().scan, Points(0, 3), std::nullopt, {});
  setThreads(0);
  EXPECT_EQ(one.marks, three.marks);
}

TEST_F(OperatingScenes, TheFinishedScanIsOneSheetTowardsTheScanner) {
  ScanPreparationSettings settings;
  settings.spacingMm = 3;
  settings.smooth = true;
  const MarkedScan marked = markScan(scene().scan, Points(0, 3), std::nullopt, settings);
  const Surface scan = finishScan(marked, settings);
  EXPECT_LT(scan.size(), marked.count(ScanMark::Kept) / 2);
  EXPECT_EQ(scan.normals.rows(), scan.size());
  EXPECT_EQ(scan.colours.rows(), scan.size());
  EXPECT_EQ(inspectTopology(scan).unusedPoints, 0);
  EXPECT_GT(scan.normals.rowwise().norm().minCoeff(), 0.99);
  EXPECT_GT((scan.normals * marked.towardsScanner).mean(), 0.5);
}

TEST(ScanUnits, AreGuessedFromTheSizeOfAnOpenedAbdomen) {
  const auto guessed = [](double extent) {
    return guessUnit((Points(2, 3) << 0, 0, 0, extent, 1e-6, 0).finished());
  };
  EXPECT_EQ(guessed(300).unit, LengthUnit::Millimetres);
  EXPECT_EQ(guessed(0.3).unit, LengthUnit::Metres);
  EXPECT_TRUE(guessed(0.3).certain);
  EXPECT_EQ(guessed(3e5).unit, LengthUnit::Micrometres);
  EXPECT_TRUE(guessed(3e5).certain);
  EXPECT_EQ(guessed(30).unit, LengthUnit::Centimetres);
  EXPECT_FALSE(guessed(30).certain) << "30 mm is small, but possible";
}

TEST_F(OperatingScenes, ScansInMetresAreScaledAndItIsSaid) {
  Surface metres = scene().scan;
  metres.points *= 1e-3;
  const MarkedScan marked = markScan(metres, Points(0, 3), std::nullopt, {});
  EXPECT_EQ(marked.factor, 1000);
  EXPECT_THAT(marked.warnings, testing::Contains(HasSubstr("taken for m ")));
  EXPECT_GT(diceOf(keptOf(marked), scene().liver), 0.97);
  ScanPreparationSettings asIs;
  asIs.unit = LengthUnit::Millimetres;
  asIs.extract = false;
  const MarkedScan tiny = markScan(metres, Points(0, 3), std::nullopt, asIs);
  EXPECT_EQ(tiny.factor, 1);
  EXPECT_THAT(tiny.warnings, testing::Contains(HasSubstr("check its unit")));
}

TEST(FinishedScans, RefuseToBeEmpty) {
  MarkedScan marked;
  marked.scan = grid(10, 3);
  marked.marks.assign(16, ScanMark::OtherTissue);
  EXPECT_THAT([&] { (void)finishScan(marked, {}); },
              testing::ThrowsMessage<InputError>(HasSubstr("are left")));
}

}  // namespace
}  // namespace falciform
