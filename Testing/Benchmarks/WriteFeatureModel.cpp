// Prints Logic/Patches/FeatureModelWeights.cpp, trained on all livers of surfaces/.
//   ./run bench feature-model > Logic/Patches/FeatureModelWeights.cpp
#include <cstdio>

#include "Testing/Benchmarks/MarkedLivers.h"
#include "Testing/Benchmarks/ModelFile.h"
#include "Testing/Support/RealData.h"

int main() {
  using namespace falciform;
  if (!std::filesystem::exists(test::realData() / "surfaces")) {
    std::fputs("the real cases are not here; set FALCIFORM_DATA\n", stderr);
    return 2;
  }
  const std::vector<bench::AnnotatedLiver> livers = bench::readAnnotatedLivers(test::realData() / "surfaces");
  std::vector<const MarkedLiver*> all;
  for (const bench::AnnotatedLiver& liver : livers) all.push_back(&liver.marked);
  std::fputs(bench::modelAsSource(trainFeatureModel(all)).c_str(), stdout);
}
