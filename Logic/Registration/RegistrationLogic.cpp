#include "Logic/Registration/RegistrationLogic.h"

#include <memory>

namespace falciform {

std::string RegistrationLogic::missingInput() const {
  if (!case_.preop()) return "Import or open the pre-operative surface first.";
  if (!case_.scan()) return "Open an intra-operative scan first.";
  if (startFromLandmarks &&
      (case_.preopLandmarks().points.size() < 3 || case_.scanLandmarks().points.size() < 3))
    return "A landmark start needs at least 3 landmarks on both sides.";
  if (looksAtPatches(settings) && (patchLabels(*case_.preop()).empty() || patchLabels(*case_.scan()).empty()))
    return "Paint at least one patch on both the surface and the scan, or choose the method icp.";
  return {};
}

std::function<RegistrationResult(const Progress&)> RegistrationLogic::prepare() const {
  return
      [preop = case_.preop(), scan = case_.scan(), from = case_.preopLandmarks(), to = case_.scanLandmarks(),
       chosen = settings, landmarks = startFromLandmarks, watch = observer](const Progress& progress) {
        RegistrationSettings used = chosen;
        Isometry3d start = Isometry3d::Identity();
        std::vector<std::string> warnings;
        if (landmarks) {
          const PointRegistrationResult fit = registerPoints(from, to);
          start = fit.targetFromSource;
          used.start = RegistrationStart::Given;
          warnings = fit.warnings;
        }
        RegistrationResult result = registerSurfaces(*preop, *scan, used, start, progress, watch);
        result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
        return result;
      };
}

void RegistrationLogic::accept(RegistrationResult result) {
  case_.setRegistration(std::make_shared<const RegistrationResult>(std::move(result)));
}

const RegistrationResult& RegistrationLogic::run(const Progress& progress) {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  accept(prepare()(progress));
  return *case_.registration();
}

}  // namespace falciform
