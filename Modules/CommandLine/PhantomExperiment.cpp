#include "Modules/CommandLine/PhantomExperiment.h"

#include "Logic/Core/LandmarkPairs.h"
#include "Logic/Patches/PatchTransfer.h"

namespace falciform::commandline {

namespace {

constexpr double kPatchRadiusMm = 3;  // thesis ch. III

VectorXd between(const Landmarks& a, const Landmarks& b) {
  return (positionsOf(a) - positionsOf(b)).rowwise().norm();
}

nlohmann::json counts(const Surface& surface) {
  return {{"points", surface.size()},
          {"falciform", pointsOfPatch(surface, patch::kFalciform).size()},
          {"inferior_ridge", pointsOfPatch(surface, patch::kInferiorRidge).size()}};
}

nlohmann::json errors(const VectorXd& mm) { return {{"mean_mm", mm.mean()}, {"largest_mm", mm.maxCoeff()}}; }

}  // namespace

PhantomExperiment makePhantomExperiment(const PhantomPlan& plan, const Progress& progress) {
  PhantomExperiment done;
  done.plan = plan;
  done.made = makePhantomCase(plan, progress.part(0, 0.95));
  progress.report(0.95, "Registering the spheres");
  const PhantomCase& made = done.made;
  done.gold = registerPoints(made.spheresCt, made.spheresScan);
  const Isometry3d preopFromScan = done.gold.targetFromSource.inverse();
  done.preop = made.ctSurface;
  done.preop.patch =
      transferPatches(transformed(made.scan, preopFromScan, done.preop.frame), done.preop, kPatchRadiusMm);
  done.sphereErrorCtMm = between(made.spheresCt, made.trueSpheresCt);
  done.sphereErrorScanMm = between(made.spheresScan, made.trueSpheresScan);
  if (!made.beadsCt.points.empty()) {
    const Points found = positionsOf(made.beadsCt), beads = positionsOf(made.targets);
    done.beadErrorMm.resize(beads.rows());
    for (Index b = 0; b < beads.rows(); ++b)
      done.beadErrorMm[b] = (found.rowwise() - beads.row(b)).rowwise().norm().minCoeff();
  }
  done.goldTargetErrorMm = phantomTargetErrors(made, done.gold.targetFromSource);
  const Points spheres = positionsOf(made.spheresCt), targets = positionsOf(made.targets);
  done.predictedTargetErrorMm.resize(targets.rows());
  for (Index i = 0; i < targets.rows(); ++i)
    done.predictedTargetErrorMm[i] =
        predictedTre(spheres, done.gold.fleEstimateMm, targets.row(i).transpose());
  progress.report(1);
  return done;
}

VectorXd phantomTargetErrors(const PhantomCase& made, const Isometry3d& scanFromPreop) {
  return targetErrors(positionsOf(made.targets), positionsOf(made.trueTargets), scanFromPreop);
}

nlohmann::json phantomFigures(const PhantomExperiment& experiment) {
  const PhantomCase& made = experiment.made;
  nlohmann::json spheres = nlohmann::json::array();
  for (std::size_t s = 0; s < made.spheresCt.points.size(); ++s) {
    const auto i = static_cast<Index>(s);
    spheres.push_back({{"name", made.spheresCt.points[s].name},
                       {"ct_error_mm", experiment.sphereErrorCtMm[i]},
                       {"scan_error_mm", experiment.sphereErrorScanMm[i]},
                       {"fre_mm", experiment.gold.freByPointMm[i]}});
  }
  nlohmann::json figures{{"preop", counts(experiment.preop)},
                         {"scan", counts(made.scan)},
                         {"scan_subregion", counts(made.subRegion)},
                         {"spheres", spheres},
                         {"fre_mm", experiment.gold.freMm},
                         {"fle_estimate_mm", experiment.gold.fleEstimateMm},
                         {"ct_localisation_error", errors(experiment.sphereErrorCtMm)},
                         {"scan_localisation_error", errors(experiment.sphereErrorScanMm)},
                         {"gold_target_error", errors(experiment.goldTargetErrorMm)},
                         {"predicted_target_error", errors(experiment.predictedTargetErrorMm)}};
  if (experiment.beadErrorMm.size() > 0) {
    figures["beads_found"] = made.beadsCt.points.size();
    figures["bead_localisation_error"] = errors(experiment.beadErrorMm);
  }
  return figures;
}

}  // namespace falciform::commandline
