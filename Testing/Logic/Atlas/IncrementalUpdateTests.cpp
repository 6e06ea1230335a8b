#include <gtest/gtest.h>

#include "Logic/Atlas/IncrementalUpdate.h"
#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Errors.h"
#include "Testing/Logic/Atlas/BeanLiver.h"

namespace falciform::test {
namespace {

/// The bean held at its thick end.
std::vector<Support> heldAtTheEnd(const TetrahedralMesh& mesh) {
  const Points centres = faceCentres(mesh, boundaryFaces(mesh));
  Support end{.name = "end", .kind = SupportKind::Fixed};
  for (Index f = 0; f < centres.rows(); ++f)
    if (centres(f, 0) < 30) end.faces.push_back(static_cast<int>(f));
  return {end};
}

const IncrementalModel& heldBean() {
  static const IncrementalModel made(beanSurface(), beanMesh(), heldAtTheEnd(beanMesh()));
  return made;
}

/// The elastic part alone, from a pose that is known.
constexpr IncrementalPlan kPosed{.identifyUndeformed = false};

/// Forces on the flat side of the free end, N each, that lift or sink it.
Points lifted(double newton) {
  const IncrementalModel& model = heldBean();
  std::vector<int> nodes;
  for (std::size_t n = 0; n < model.freeNodes().size(); ++n)
    if (model.mesh().points(model.freeNodes()[n], 0) > 70 &&
        model.freeNormals()(static_cast<Index>(n), 2) < -0.7)
      nodes.push_back(static_cast<int>(n));
  const VectorXd field = model.underForces(nodes).rowwise().sum() * newton;
  return Eigen::Map<const Points>(field.data(), field.size() / 3, 3);
}

TEST(IncrementalUpdate, BringsBackALiverThatIsHeldAsItBelieves) {
  const Points truth = lifted(-0.02);
  const BeanTruth bent = beanMoved(truth, 0.1);
  UpdateResult rigid;
  rigid.scanFromPreop = bent.scanFromPreop;
  rigid.displacements = Points::Zero(truth.rows(), 3);
  const double before = meanError(heldBean().mesh(), rigid, bent);
  ASSERT_GT(before, 2);  // mm: what there is to be mended, however well the rigid pose is known
  const UpdateResult update = updateIncrementally(heldBean(), bent.scan, bent.scanFromPreop, kPosed);
  EXPECT_LT(meanError(heldBean().mesh(), update, bent), 0.25 * before);
  EXPECT_TRUE(update.converged) << update.stopReason;
  EXPECT_GT(update.minDetJ, 0);
}

TEST(IncrementalUpdate, WhatIsHeldStaysWhereItIs) {
  const BeanTruth bent = beanMoved(lifted(-0.02), 0.1);
  const UpdateResult update = updateIncrementally(heldBean(), bent.scan, bent.scanFromPreop);
  for (Index n = 0; n < update.displacements.rows(); ++n)
    if (heldBean().mesh().points(n, 0) < 20 && heldBean().mesh().points(n, 2) < 1) {
      EXPECT_LT(update.displacements.row(n).norm(), 1e-9) << n;  // mm: rounding
    }
}

TEST(IncrementalUpdate, SmallerSharesTakeMoreIncrementsToTheSameEnd) {
  const BeanTruth bent = beanMoved(lifted(-0.02), 0);
  const UpdateResult bold = updateIncrementally(heldBean(), bent.scan, bent.scanFromPreop,
                                                {.identifyUndeformed = false, .share = 0.9}),
                     timid = updateIncrementally(heldBean(), bent.scan, bent.scanFromPreop,
                                                 {.identifyUndeformed = false, .share = 0.3});
  EXPECT_GT(timid.iterations, bold.iterations);
  // mm: what the last increments, of 0.01 mm each, had still to do.
  EXPECT_LT((timid.displacements - bold.displacements).rowwise().norm().mean(), 0.2);
}

TEST(IncrementalUpdate, SupportsThatDoNotHoldAreRefused) {
  std::vector<Support> sliding = heldAtTheEnd(beanMesh());
  sliding[0].kind = SupportKind::Sliding;
  sliding[0].faces.resize(1);
  EXPECT_THROW(IncrementalModel(beanSurface(), beanMesh(), sliding), InputError);
}

}  // namespace
}  // namespace falciform::test
