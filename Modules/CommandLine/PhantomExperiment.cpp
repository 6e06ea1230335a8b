#include "Modules/CommandLine/PhantomExperiment.h"

#include "Logic/Patches/PatchTransfer.h"

namespace falciform::commandline {

namespace {

constexpr double kPatchRadiusMm = 3;  // thesis ch. III

Points positions(const Landmarks& landmarks) {
  Points points(static_cast<Index>(landmarks.points.size()), 3);
  for (Index i = 0; i < points.rows(); ++i)
    points.row(i) = landmarks.points[static_cast<std::size_t>(i)].position.transpose();
  return points;
}

VectorXd between(const Landmarks& a, const Landmarks& b) {
  return (positions(a) - positions(b)).rowwise().norm();
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
  done.goldTargetErrorMm = phantomTargetErrors(made, done.gold.targetFromSource);
  const Points spheres = positions(made.spheresCt), targets = positions(made.targets);
  done.predictedTargetErrorMm.resize(targets.rows());
  for (Index i = 0; i < targets.rows(); ++i)
    done.predictedTargetErrorMm[i] =
        predictedTre(spheres, done.gold.fleEstimateMm, targets.row(i).transpose());
  progress.report(1);
  return done;
}

VectorXd phantomTargetErrors(const PhantomCase& made, const Isometry3d& scanFromPreop) {
  return targetErrors(positions(made.targets), positions(made.trueTargets), scanFromPreop);
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
  return {{"preop", counts(experiment.preop)},
          {"scan", counts(made.scan)},
          {"scan_subregion", counts(made.subRegion)},
          {"spheres", spheres},
          {"fre_mm", experiment.gold.freMm},
          {"fle_estimate_mm", experiment.gold.fleEstimateMm},
          {"ct_localisation_error", errors(experiment.sphereErrorCtMm)},
          {"scan_localisation_error", errors(experiment.sphereErrorScanMm)},
          {"gold_target_error", errors(experiment.goldTargetErrorMm)},
          {"predicted_target_error", errors(experiment.predictedTargetErrorMm)}};
}

}  // namespace falciform::commandline
