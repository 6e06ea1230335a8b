#include "Logic/Registration/Trials/Trials.h"

#include <gmock/gmock.h>

#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Logic/Registration/Trials/TrialBasins.h"
#include "Logic/Registration/Trials/TrialSummary.h"
#include "Testing/Logic/Registration/Trials/SmallTrial.h"

namespace falciform {
namespace {

using test::SmallTrial;

class Trials : public ::testing::Test {
 protected:
  ~Trials() override { setThreads(0); }
  [[nodiscard]] std::vector<TrialRecord> run(const std::vector<TrialRecord>& done = {},
                                             const std::function<void(const TrialRecord&)>& keep = {},
                                             const Progress& progress = {}) const {
    return runTrials(small_.atGold(), methods_, kLargeScale, settings_, done, keep, progress);
  }

  SmallTrial small_;
  std::vector<TrialMethod> methods_ = parseTrialMethods("thesis-phantom/icp,picp:1+2");
  TrialSettings settings_{.count = 6, .distribution = TrialDistribution::Uniform, .seed = 3, .variation = {}};
};

void expectSame(const std::vector<TrialRecord>& a, const std::vector<TrialRecord>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(a[i].method, b[i].method);
    EXPECT_EQ(a[i].trial, b[i].trial);
    EXPECT_EQ(a[i].error.matrix(), b[i].error.matrix());
    EXPECT_EQ(a[i].startRotationDeg, b[i].startRotationDeg);
    EXPECT_EQ(a[i].rmsMm, b[i].rmsMm);
    EXPECT_EQ(a[i].targetErrorMm, b[i].targetErrorMm);
    EXPECT_EQ(a[i].iterations, b[i].iterations);
    EXPECT_EQ(a[i].stopReason, b[i].stopReason);
    EXPECT_EQ(a[i].success, b[i].success);
  }
}

TEST_F(Trials, ARecordIsTheRegistrationOfTheScanThatWasMoved) {
  const TrialCase data = small_.atGold();
  const TrialRecord record = runTrial(data, methods_[0], kSmallScale, settings_, 4);
  const Isometry3d moved =
      perturbation(kSmallScale, settings_.distribution, 3, 4, data.scan.points.colwise().mean().transpose());
  // By hand, from the scan as it was measured.
  const Isometry3d movedFromScan = moved * small_.scanFromPreop.inverse();
  const RegistrationResult result =
      registerSurfaces(small_.preop, transformed(small_.scan, movedFromScan, "moved"), methods_[0].settings);
  const double error = targetErrors(small_.targets.preop, transformed(small_.targets.scan, movedFromScan),
                                    result.scanFromPreop)
                           .mean();
  // Rounding of two ways to one pose, grown over the iterations.
  EXPECT_NEAR(record.rmsMm, result.rmsMm, 1e-6);
  EXPECT_NEAR(record.targetErrorMm, error, 1e-5);
  EXPECT_EQ(record.iterations, result.iterations);
  EXPECT_EQ(record.stopReason, result.stopReason);
  EXPECT_EQ(record.warnings, static_cast<int>(result.warnings.size()));
  EXPECT_EQ(record.success, error < 5);
  EXPECT_NEAR(record.goldDistanceMm, test::placedApart(small_.body.points, result.scanFromPreop, moved),
              1e-5);
  EXPECT_NEAR(record.startTranslationMm, (moved * data.scanCentre - data.scanCentre).norm(), 1e-12);
}

TEST_F(Trials, WithoutPerturbationTheGoldStandardIsKept) {
  const TrialRecord record = runTrial(small_.atGold(), methods_[0], {0, 0}, settings_, 0);
  EXPECT_EQ(record.startRotationDeg, 0);
  EXPECT_LT(record.goldDistanceMm, 1e-6);  // an exact part of the surface stays where it is
  EXPECT_TRUE(record.success);
}

TEST_F(Trials, TwoPatchesFindEveryPoseOfTheLargeScaleAndIcpAFew) {
  settings_.count = 12;
  const std::vector<TrialRecord> records = run();
  const auto basins = trialBasins(records, outermostPoints(small_.body.points), settings_.basinMm);
  const TrialSummary icp = summarise(records, basins, 0, settings_),
                     picp = summarise(records, basins, 1, settings_);
  EXPECT_EQ(picp.successes, 12);
  EXPECT_EQ(picp.nearGold, 12);
  EXPECT_EQ(picp.inLargestBasin, 12);
  EXPECT_LT(icp.successes, 6);  // from anywhere ICP finds a few per cent (thesis Table III.2)
  EXPECT_GT(icp.basins, 1);
}

TEST_F(Trials, SuccessIsByResidualWhereThereAreNoTargets) {
  const TrialCase data = small_.atGold(false);
  for (int trial = 0; trial < 4; ++trial) {
    const TrialRecord record = runTrial(data, methods_[0], kLargeScale, settings_, trial);
    EXPECT_TRUE(std::isnan(record.targetErrorMm));
    EXPECT_EQ(record.success, record.rmsMm < settings_.successRmsMm);
  }
}

TEST_F(Trials, AreTheSameForAnyThreadsAndAnyNumberAtOnce) {
  setThreads(1);
  const std::vector<TrialRecord> expected = run();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(expected[i].method, static_cast<int>(i) / settings_.count);
    EXPECT_EQ(expected[i].trial, static_cast<int>(i) % settings_.count);
  }
  setThreads(2);
  for (const int atOnce : {0, 1, 2}) {
    settings_.atOnce = atOnce;
    expectSame(run(), expected);
  }
}

TEST_F(Trials, ATrialIsTheSameWhateverTheCount) {
  const std::vector<TrialRecord> six = run();
  settings_.count = 2;
  const std::vector<TrialRecord> two = run();
  expectSame(two, {six[0], six[1], six[6], six[7]});
}

TEST_F(Trials, EachTrialHasItsOwnScanWhereVariationIsAskedFor) {
  settings_.variation = {.keepShare = 0.8, .noiseMm = 0.5};
  const std::vector<TrialRecord> varied = run();
  for (std::size_t i = 6; i < 12; ++i) {  // two patches, whose result else may depend on nothing but rounding
    EXPECT_TRUE(varied[i].success);
    for (std::size_t k = 6; k < i; ++k) EXPECT_GT(std::abs(varied[i].rmsMm - varied[k].rmsMm), 1e-6);
  }
  setThreads(1);
  expectSame(run(), varied);
}

TEST_F(Trials, AnInterruptedRunContinuesToTheSameEnd) {
  const std::vector<TrialRecord> whole = run();
  for (const int threadCount : {1, 2}) {
    setThreads(threadCount);
    std::stop_source stop;
    std::vector<TrialRecord> kept;
    const auto keep = [&](const TrialRecord& record) {
      kept.push_back(record);
      if (kept.size() == 5) stop.request_stop();
    };
    EXPECT_THROW(run({}, keep, Progress({}, stop.get_token())), Cancelled);
    EXPECT_GE(kept.size(), 5u);
    EXPECT_LT(kept.size(), whole.size());
    std::size_t further = 0;
    const std::vector<TrialRecord> resumed = run(kept, [&](const TrialRecord&) { ++further; });
    EXPECT_EQ(kept.size() + further, whole.size());
    expectSame(resumed, whole);
  }
}

TEST_F(Trials, AStopReachesTheRegistrationThatRuns) {
  std::stop_source stop;
  settings_.count = 1;
  int kept = 0;
  stop.request_stop();
  EXPECT_THROW(run(
                   {}, [&](const TrialRecord&) { ++kept; }, Progress({}, stop.get_token())),
               Cancelled);
  EXPECT_EQ(kept, 0);
}

TEST_F(Trials, ProgressCountsTrialsUpToTheWhole) {
  std::vector<double> fractions;
  (void)run({}, {}, Progress([&](double f, std::string_view) { fractions.push_back(f); }, {}));
  ASSERT_EQ(fractions.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_DOUBLE_EQ(fractions[i], static_cast<double>(i + 1) / 12);
}

}  // namespace
}  // namespace falciform
