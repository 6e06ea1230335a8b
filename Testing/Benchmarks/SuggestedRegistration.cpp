// Prints the second table of Docs/Features.md: mean target error on the real livers of update/ registered by
// their annotated patches and by suggested ones.   ./run bench suggested-registration

#include <cstdio>

#include "Testing/Regression/SuggestedPatches.h"
#include "Testing/Support/RealData.h"

int main() {
  using namespace falciform;
  if (!std::filesystem::exists(test::realData() / "update")) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  std::puts(
      "| case | best rigid | annotated, annotated | suggested, annotated | suggested, ten dabs "
      "|\n|---|---|---|---|---|");
  for (const std::string& name : test::updateCaseNames()) {
    const test::UpdateCase c = test::readUpdateCase(name);
    const Surface preop = test::suggestedPreop(c);
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", name.c_str(), c.optimalRigidMm,
                test::targetErrorMm(c, c.preop, c.scan), test::targetErrorMm(c, preop, c.scan),
                test::targetErrorMm(c, preop, test::dabbedScan(c, 1)));
    std::fflush(stdout);
  }
}
