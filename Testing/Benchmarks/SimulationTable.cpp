// ./run bench update-simulation: thesis Tables V.1 and V.2.
#include <cstdio>
#include <cstdlib>

#include "Logic/Biomechanics/BlasKernel.h"
#include "Testing/Benchmarks/GravityTrials.h"

namespace falciform::bench {
namespace {

LoadResponses modesAsLoads(const Atlas& atlas) {
  const Index rank = atlas.rank(), rows = 3 * ((rank + 2) / 3);
  LoadResponses r;
  r.mesh = atlas.mesh;
  r.centres = Points::Constant(rows / 3, 3, 0);
  r.centres.rowwise() = atlas.mesh.points.colwise().mean();
  r.responses = Eigen::MatrixXf::Zero(rows, 3 * atlas.mesh.nodes());
  r.rmsMm = VectorXd::Zero(rows);
  for (Index k = 0; k < rank; ++k) {
    r.responses.row(k) = Eigen::Map<const Eigen::RowVectorXd>(atlas.modes[k].data(), atlas.modes[k].size()).cast<float>();
    r.rmsMm[k] = 1;
  }
  return r;
}

int run() {
  GravityPlan plan;
  const GravityExperiment made = gravityExperiment(plan);
  const ReadyLiver liver(made.preop);
  const UpdateModel own(made.preop, modesAsLoads(made.atlas));
  std::printf("rank %ld\n", made.atlas.rank());
  for (const GravityTrial& t : made.inside) {
    std::printf("%.0f %.0f before %s detJ %.2f cov %.2f\n", t.yDeg, t.zDeg, withoutSpread(t.before).c_str(), t.minDetJ, t.coverage);
    for (const UpdateTrial* u : {&t.full, &t.partial}) {
      UpdateSettings s; s.noiseFloorMm = getenv("NF") ? atof(getenv("NF")) : 0.3;
      const TrialResult r = runTrial(liver, *u, {}, s);
      const UpdateResult a = updateModel(own, u->scan, r.rigid.scanFromPreop, s);
      const ErrorFigures e = figuresOf(scanFromPreop(own, a, u->before), u->after);
      std::printf("  optimal %s registered %s updated %s exp %.2f noise %.2f bend %.1f rms %.2f detJ %.2f steps %d %d | with atlas %s noise %.2f bend %.1f rms %.3f\n", withoutSpread(r.optimal,2).c_str(), withoutSpread(r.registered,2).c_str(), withoutSpread(r.updated,2).c_str(), r.expectedMm, r.update.noiseMm, r.update.bendMm, r.update.rmsMm, r.update.minDetJ, r.update.iterations, r.update.converged, withoutSpread(e,2).c_str(), a.noiseMm, a.bendMm, a.rmsMm);
      std::fflush(stdout);
    }
  }
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::bench::run();
}
