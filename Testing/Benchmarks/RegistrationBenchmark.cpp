// Neighbours, preparation, one iteration and whole registrations against what a user has today (FLANN, VTK,
// PCL, Open3D, all from Debian), in one run and one table, accuracy beside time: Docs/Performance.md.
//   ./run bench registration

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "Testing/Benchmarks/Comparisons.h"
#include "Testing/Benchmarks/Table.h"

namespace falciform::bench {
namespace {

void compareAll(const BenchCase& c, int slowPeers) {
  comparePreparation(c);
  compareIterations(c);
  compareRegistrations(c, slowPeers);
}

void printMachine() {
  std::array<double, 3> load{};
  const int known = getloadavg(load.data(), static_cast<int>(load.size()));
  std::printf(
      "Cores: %u. Load at the start (1, 5, 15 min): %.2f %.2f %.2f%s\n\n",
      std::thread::hardware_concurrency(), load[0], load[1], load[2],
      known > 0 && load[0] > 0.5 ? ": others are at work here, wall times are not this program's alone" : "");
}

void printCase(const BenchCase& c) {
  std::printf("- %s: %ld pre-op points, %ld scan points; right below %.1f mm%s\n", c.name.c_str(),
              static_cast<long>(c.preop.size()), static_cast<long>(c.scan.size()), c.limitMm,
              c.optimalMm > 0 ? " (1.4 x best rigid motion + 0.5 mm)" : "");
}

}  // namespace
}  // namespace falciform::bench

int main(int argc, char** argv) {
  using namespace falciform::bench;
  const bool quick = argc == 2 && std::strcmp(argv[1], "--quick") == 0;
  if (argc > 1 && !quick) {
    std::fputs("bench-registration [--quick]; quick: from any pose only, without VTK and PCL\n", stderr);
    return 2;
  }
  printMachine();
  std::vector<BenchCase> cases{builtInCase(), phantomCase()};
  for (const char* name : {"ircad17_left", "ircad8_both"}) {
    if (auto real = realCase(name))
      cases.push_back(std::move(*real));
    else
      std::printf("%s is left out: the real cases are not here; set FALCIFORM_DATA\n", name);
  }
  for (const BenchCase& c : cases) printCase(c);
  std::puts("");
  printHead();
  if (quick) {
    for (const BenchCase& c : cases) compareRegistrations(c, 0);
    return 0;
  }
  compareNeighbours(cases.front());
  for (std::size_t k = 0; k < cases.size(); ++k) compareAll(cases[k], k == 0 ? 3 : 1);
}
