#include "Logic/Deformation/Normalisation/LiverRegistration.h"

#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/Normalisation/SurfaceErrors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

/// Another body than the lumpy one: stretched, moved a little and bent by a centimetre.
Surface otherBody() {
  Surface body = lumpyBody(4);
  for (Index i = 0; i < body.points.rows(); ++i) {
    const Vector3d p = body.points.row(i).transpose();
    body.points.row(i) << 1.15 * p.x() + 10 * std::sin(p.y() / 30) + 20, 0.9 * p.y() + 0.1 * p.x() - 15,
        1.05 * p.z() + 8 * std::cos(p.x() / 40);
  }
  return body;
}

NormalisationSettings quick() {
  NormalisationSettings settings;
  settings.levels = 9;
  settings.finestMm = 10;
  return settings;
}

TEST(LiverRegistration, LaysOneSurfaceOnTheOtherWithoutAFold) {
  const Surface target = lumpyBody(4), source = otherBody();
  const LiverMap map = registerLivers(target, source, quick());
  const SurfaceErrors errors = surfaceErrors(target, source, map);
  // The facets of the two, 4 mm long, bulge by some 0.1 mm; levels of 10 mm leave about as much.
  EXPECT_LT(errors.sourceToTarget.mean(), 0.25);
  EXPECT_LT(errors.targetToSource.mean(), 0.25);
  EXPECT_LT(errors.sourceToTarget.maxCoeff(), 3);
  EXPECT_GT(map.determinants(target.points).minCoeff(), 0);
}

TEST(LiverRegistration, OfALiverOnItselfMovedIsThatMotion) {
  const Surface target = lumpyBody(4);
  Isometry3d motion = Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(0.2, Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  motion.translation() = Vector3d(30, -20, 10);
  const Surface source = transformed(target, motion, "LPS");
  const LiverMap map = registerLivers(target, source, quick());
  // Along the surface nothing holds it but the whole body's shape: a millimetre, where the surface is at 0.1.
  EXPECT_LT((map.toSource(target.points) - source.points).rowwise().norm().mean(), 1);
  EXPECT_LT(surfaceErrors(target, source, map).targetToSource.mean(), 0.1);
}

TEST(LiverRegistration, DoesNotDependOnTheNumberOfThreads) {
  const Surface target = lumpyBody(3), source = otherBody();
  NormalisationSettings settings = quick();
  settings.levels = 4;
  settings.finestMm = 25;
  setThreads(1);
  const Points one = registerLivers(target, source, settings).toSource(target.points);
  setThreads(3);
  const Points three = registerLivers(target, source, settings).toSource(target.points);
  setThreads(0);
  EXPECT_EQ(one, three);
}

TEST(LiverRegistration, RefusesASurfaceThatIsNotClosedOrFacesInwards) {
  Surface inwards = lumpyBody(3);
  inwards.triangles.col(0).swap(inwards.triangles.col(1));
  EXPECT_THROW((void)registerLivers(grid(50, 5), lumpyBody(3)), InputError);
  EXPECT_THROW((void)registerLivers(lumpyBody(3), inwards), InputError);
}

TEST(LiverRegistration, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)registerLivers(lumpyBody(3), lumpyBody(3), {}, Progress({}, stop.get_token())),
               Cancelled);
}

}  // namespace
}  // namespace falciform::test
