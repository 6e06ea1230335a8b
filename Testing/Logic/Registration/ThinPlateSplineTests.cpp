#include "Logic/Registration/ThinPlateSpline.h"

#include <gtest/gtest.h>

#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Sampling.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using test::lumpyBody;
using test::randomMotion;

double meanError(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

/// A smooth bend of up to 10 mm.
Points bent(const Points& points) {
  Points moved = points;
  for (Index i = 0; i < points.rows(); ++i) {
    moved(i, 2) += 10 * std::sin(points(i, 0) / 50);
    moved(i, 0) += 4 * std::cos(points(i, 1) / 40);
  }
  return moved;
}

TEST(ThinPlateSpline, FindsARigidMotionAndNoBend) {
  const Points points = lumpyBody(2).points;
  const Isometry3d truth = randomMotion(3);
  const ThinPlateSpline spline = ThinPlateFit(points, points.topRows(60))
                                     .fit(transformed(points, truth), VectorXd::Ones(points.rows()), 1e-3);
  const Points far = 5 * points;
  EXPECT_LT((spline(far) - transformed(far, truth)).rowwise().norm().maxCoeff(), 1e-8);  // mm: rounding
}

TEST(ThinPlateSpline, GoesThroughItsKnotsAsTheStiffnessVanishes) {
  const Points points = lumpyBody(2).points, target = bent(points);
  const VectorXd ones = VectorXd::Ones(points.rows());
  const ThinPlateFit fitter(points, points);
  double last = INFINITY;
  for (const double stiffness : {1.0, 1e-2, 1e-4, 1e-8}) {
    const double error = meanError(fitter.fit(target, ones, stiffness)(points), target);
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_LT(last, 1e-3);  // mm of a bend of 10: as many free weights as points
  EXPECT_GT(meanError(fitter.fit(target, ones, INFINITY)(points), target), 2);  // mm: rigid alone
}

TEST(ThinPlateSpline, ABendOfOneSideStaysBoundedBeyondIt) {
  const Surface body = lumpyBody(3);
  std::vector<int> seen;
  for (Index i = 0; i < body.size(); ++i)
    if (body.points(i, 2) > 20) seen.push_back(static_cast<int>(i));
  const Points source = rowsOf(body.points, seen);
  const ThinPlateSpline spline = ThinPlateFit(source, rowsOf(source, spreadSample(source, 80)))
                                     .fit(bent(source), VectorXd::Ones(source.rows()), 1e-3);
  // Neither on the unseen side nor metres away does it bend more than the 10 mm and 4 mm of the seen side.
  const Points far = 100 * body.points;
  EXPECT_LT((spline(far) - transformed(far, spline.rigid())).rowwise().norm().maxCoeff(), 12);
  EXPECT_LT((spline(body.points) - transformed(body.points, spline.rigid())).rowwise().norm().maxCoeff(), 12);
  EXPECT_LT(meanError(spline(source), bent(source)), 0.5);
}

TEST(ThinPlateSpline, AWeightOfNothingIsNoPoint) {
  const Points points = lumpyBody(2).points;
  Points target = bent(points);
  VectorXd weights = VectorXd::Ones(points.rows());
  const ThinPlateFit fitter(points, points.bottomRows(60));
  target.row(7).setConstant(900);
  weights[7] = 0;
  const Points one = fitter.fit(target, weights, 1e-2)(points);
  target.row(7).setConstant(-300);
  EXPECT_LT((one - fitter.fit(target, weights, 1e-2)(points)).norm(), 1e-9);
}

TEST(ThinPlateSpline, FlatAndTinySetsOfKnotsStillGiveAMotion) {
  Points flat = test::grid(100, 6).points;
  const Isometry3d truth = randomMotion(5);
  const VectorXd ones = VectorXd::Ones(flat.rows());
  EXPECT_LT(meanError(ThinPlateFit(flat, flat).fit(transformed(flat, truth), ones, 1e-3)(flat),
                      transformed(flat, truth)),
            1e-8);
  EXPECT_LT(meanError(ThinPlateFit(flat, flat.topRows(3)).fit(transformed(flat, truth), ones, 1e-3)(flat),
                      transformed(flat, truth)),
            1e-8);
}

}  // namespace
}  // namespace falciform
