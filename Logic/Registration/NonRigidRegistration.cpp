#include "Logic/Registration/NonRigidRegistration.h"

#include "Logic/Geometry/Sampling.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {

namespace {

constexpr Index kKnots = 80;

}  // namespace

Points knotsFor(const Points& points) { return rowsOf(points, spreadSample(points, kKnots)); }

NonRigidResult nonRigidFromPairs(const PreparedPreop& preop, const Points& onPreop, const Points& onScan,
                                 const VectorXd& weights, double stiffness, PatchIcpResult run) {
  // The search moves the scan, which is small, onto the pre-op surface, which stands ready; the pairs that it
  // ends with then carry the pre-op surface onto the scan.
  const ThinPlateSpline warp = ThinPlateFit(onPreop, knotsFor(onPreop)).fit(onScan, weights, stiffness);
  NonRigidResult result;
  result.scanFromPreopWarp = warp;
  result.warpedPreop = warp(preop.surface().points);
  result.rigid = std::move(run);
  result.rigid.preopFromScan = fitRigid(result.warpedPreop, preop.surface().points, preop.areas());
  return result;
}

}  // namespace falciform
