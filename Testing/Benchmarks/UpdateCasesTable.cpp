// Prints the table of Docs/Registration.md: mean target error on the real livers of `update/` for the methods
// from the pose as stored and nothing else.   ./run bench update-cases

#include <cstdio>

#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

RegistrationSettings icpFromTheStoredPose() {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.start = RegistrationStart::Given;
  return settings;
}

RegistrationSettings withPatches(std::vector<int> patches) {
  RegistrationSettings settings;
  settings.patches = std::move(patches);
  return settings;
}

double meanTargetError(const test::UpdateCase& c, const RegistrationResult& result) {
  return targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean();
}

RegistrationSettings withoutFinish() {
  RegistrationSettings settings;
  settings.finish = RegistrationFinish::None;
  return settings;
}

RegistrationSettings automatic() {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Auto;
  return settings;
}

/// Mean of what the registration expects at the targets, mm.
double expectedAtTargets(const test::UpdateCase& c, const RegistrationResult& result) {
  double sum = 0;
  for (Index i = 0; i < c.targetsPreop.rows(); ++i)
    sum += result.expectedTargetErrorMm(c.targetsPreop.row(i).transpose());
  return sum / static_cast<double>(c.targetsPreop.rows());
}

void printRow(const test::UpdateCase& c) {
  const PreparedPreop preop(c.preop);
  const auto error = [&](const RegistrationSettings& settings) {
    return meanTargetError(c, registerSurfaces(preop, c.scan, settings));
  };
  const RegistrationResult both = registerSurfaces(preop, c.scan, {});
  std::printf("| %s | %.0f %% | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %zu |\n",
              c.name.c_str(), 100 * c.coverage, c.optimalRigidMm, error(icpFromTheStoredPose()),
              error(registrationPreset("thesis-clinical")), error(withoutFinish()), error(automatic()),
              error(withPatches({patch::kFalciform})), meanTargetError(c, both), expectedAtTargets(c, both),
              both.rmsMm, both.warnings.size());
  std::fflush(stdout);
}

}  // namespace
}  // namespace falciform

int main() {
  using namespace falciform;
  if (!std::filesystem::exists(test::realData() / "update")) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  std::puts(
      "| case | coverage | optimal rigid | ICP | thesis-clinical | both, no finish | auto | falciform | both "
      "| "
      "expected, both | RMS, both | warnings, both |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const std::string& name : test::updateCaseNames()) printRow(test::readUpdateCase(name));
}
