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

std::string cell(const test::UpdateCase& c, const RegistrationSettings& settings) {
  const RegistrationResult result = registerSurfaces(c.preop, c.scan, settings);
  char text[64];
  std::snprintf(text, sizeof text, "%.1f (%.1f s)",
                targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean(), result.seconds);
  return text;
}

void printRow(const test::UpdateCase& c) {
  const RegistrationResult both = registerSurfaces(c.preop, c.scan, {});
  const double second = both.basins.size() > 1 ? both.basins[1].score : 1;
  std::printf("| %s | %.0f %% | %.1f | %s | %s | %s | %s | %.1f | %.2f, %.2f | %zu |\n", c.name.c_str(),
              100 * c.coverage, c.optimalRigidMm, cell(c, icpFromTheStoredPose()).c_str(),
              cell(c, registrationPreset("thesis-clinical")).c_str(),
              cell(c, withPatches({patch::kFalciform})).c_str(), cell(c, {}).c_str(), both.rmsMm,
              both.basins.front().score, second, both.warnings.size());
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
      "| case | coverage | optimal rigid | ICP, stored pose | thesis-clinical, stored pose | falciform | "
      "both patches | RMS | "
      "scores of best and next basin | warnings |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|");
  for (const std::string& name : test::updateCaseNames()) printRow(test::readUpdateCase(name));
}
