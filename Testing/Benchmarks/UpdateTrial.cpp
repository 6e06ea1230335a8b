#include "Testing/Benchmarks/UpdateTrial.h"

#include <cmath>
#include <cstdio>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Subdivision.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform::bench {
namespace {

constexpr double kRegistrationEdgeMm = 3;

LoadResponses loadsOf(const Surface& preop, double edgeMm) {
  MeshSettings settings;
  settings.edgeLengthMm = edgeMm;
  return solveSurfaceLoads(meshLiver(preop, {}, settings).mesh, {Material{}});
}

std::string text(const char* format, const ErrorFigures& f, int digits, bool spread) {
  char buffer[64];
  if (spread)
    std::snprintf(buffer, sizeof buffer, format, digits, f.mean, digits, f.sd, digits, f.largest);
  else
    std::snprintf(buffer, sizeof buffer, format, digits, f.mean, digits, f.largest);
  return buffer;
}

}  // namespace

ErrorFigures figuresOf(const VectorXd& errors) {
  ErrorFigures figures;
  if (errors.size() == 0) return figures;
  figures.mean = errors.mean();
  figures.largest = errors.maxCoeff();
  if (errors.size() > 1)
    figures.sd =
        std::sqrt((errors.array() - figures.mean).square().sum() / static_cast<double>(errors.size() - 1));
  return figures;
}

ErrorFigures figuresOf(const Points& said, const Points& truth) {
  return figuresOf(VectorXd((said - truth).rowwise().norm()));
}

std::string asInThesis(const ErrorFigures& figures, int digits) {
  return text("%.*f±%.*f(%.*f)", figures, digits, true);
}
std::string withoutSpread(const ErrorFigures& figures, int digits) {
  return text("%.*f(%.*f)", figures, digits, false);
}

ReadyLiver::ReadyLiver(const Surface& preop, double edgeMm)
    : rigid_(subdividedTo(preop, kRegistrationEdgeMm)), model_(preop, loadsOf(preop, edgeMm)) {}

TrialResult runTrialFrom(const ReadyLiver& liver, const UpdateTrial& trial, const Isometry3d& scanFromPreop,
                         const UpdateSettings& settings) {
  TrialResult done;
  done.optimal = figuresOf(targetErrors(trial.before, trial.after, fitRigid(trial.before, trial.after)));
  done.registered = figuresOf(targetErrors(trial.before, trial.after, scanFromPreop));
  done.rigid.scanFromPreop = scanFromPreop;
  done.update = updateModel(liver.model(), trial.scan, scanFromPreop, settings);
  done.updatedMm =
      (falciform::scanFromPreop(liver.model(), done.update, trial.before) - trial.after).rowwise().norm();
  done.updated = figuresOf(done.updatedMm);
  done.expectedMm = expectedErrorMm(liver.model(), done.update, trial.before).mean();
  return done;
}

TrialResult runTrial(const ReadyLiver& liver, const UpdateTrial& trial,
                     const RegistrationSettings& registration, const UpdateSettings& settings) {
  RegistrationResult rigid = registerSurfaces(liver.rigid(), trial.scan, registration);
  TrialResult done = runTrialFrom(liver, trial, rigid.scanFromPreop, settings);
  done.rigid = std::move(rigid);
  return done;
}

RegistrationSettings withoutPatches() {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Auto;
  return settings;
}

Isometry3d drawnPose(std::uint64_t seed, double reachMm) {
  Draws draws(seed);
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = draws.rotation().toRotationMatrix();
  for (int axis = 0; axis < 3; ++axis) pose.translation()[axis] = draws.uniform(-reachMm, reachMm);
  return pose;
}

}  // namespace falciform::bench
