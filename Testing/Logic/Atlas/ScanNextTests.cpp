#include <gtest/gtest.h>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/ScanNext.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/BeanLiver.h"

namespace falciform::test {
namespace {

const UpdateModel& model() {
  static const UpdateModel made(beanSurface(),
                                solveSurfaceLoads(beanMesh(), {Material{}}, {.centres = 30, .radiusMm = 18}));
  return made;
}

UpdateResult updated() {
  const BeanTruth truth = beanTruth({3, -2, 0, 2, 0, 1}, 0.3);
  return updateModel(model(), truth.scan, truth.scanFromPreop);
}

/// The load centre that is farthest down, where the scanner above does not look, and a place beside it.
Index lowestCentre() {
  Index lowest = 0;
  model().responses().centres.col(2).minCoeff(&lowest);
  return lowest;
}

TEST(ScanNext, NothingIsLostByScanning) {
  const VectorXd gains = scanGainMm(model(), updated(), model().responses().centres);
  ASSERT_EQ(gains.size(), model().responses().centres.rows());
  EXPECT_GE(gains.minCoeff(), 0);
  EXPECT_GT(gains.maxCoeff(), 0.01);  // mm
}

TEST(ScanNext, MostIsGainedBesideThePlaceThatIsAskedAbout) {
  const UpdateResult update = updated();
  const Index centre = lowestCentre();
  const VectorXd gains = scanGainMm(model(), update, model().responses().centres.row(centre));
  Index best = 0;
  gains.maxCoeff(&best);
  const Points& centres = model().responses().centres;
  EXPECT_LT((centres.row(best) - centres.row(centre)).norm(), 30)  // mm; centres are 20 to 25 mm apart
      << "best at " << centres.row(best);
}

TEST(ScanNext, AGainIsNoMoreThanThereIsToGain) {
  const UpdateResult update = updated();
  const Points place = model().responses().centres.row(lowestCentre());
  const double expected = expectedErrorMm(model(), update, place)[0];
  EXPECT_LT(scanGainMm(model(), update, place).maxCoeff(), expected - modelErrorMm(update) + 1e-9);
}

TEST(ScanNext, TheMapIsSmoothAndLiesBetweenTheGains) {
  const UpdateResult update = updated();
  const Points& centres = model().responses().centres;
  const VectorXd gains = scanGainMm(model(), update, centres);
  const VectorXd map = scanGainOnSurface(model(), update, centres, beanSurface().points);
  ASSERT_EQ(map.size(), beanSurface().size());
  EXPECT_GE(map.minCoeff(), gains.minCoeff() - 1e-12);
  EXPECT_LE(map.maxCoeff(), gains.maxCoeff() + 1e-12);
  // A mean over centres 20 mm apart, weighted over 10 mm: no step of more than a quarter over a millimetre.
  Points beside = beanSurface().points;
  beside.col(0).array() += 1;
  const VectorXd moved = scanGainOnSurface(model(), update, centres, beside);
  EXPECT_LT((moved - map).cwiseAbs().maxCoeff(), 0.25 * (gains.maxCoeff() - gains.minCoeff()));
}

TEST(ScanNext, WithoutPlacesThereIsNothingToGain) {
  EXPECT_THROW(scanGainMm(model(), updated(), Points(0, 3)), InputError);
}

}  // namespace
}  // namespace falciform::test
