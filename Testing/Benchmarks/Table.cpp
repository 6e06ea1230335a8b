#include "Testing/Benchmarks/Table.h"

#include <cstdio>

#include "Testing/Benchmarks/Stopwatch.h"

namespace falciform::bench {

void printHead() {
  std::puts(
      "| what | who | runs | right | wall, median, ms | wall, P99, ms | processor, median, ms | times as "
      "fast as "
      "the first | error, median, mm | error, largest, mm |\n|---|---|---|---|---|---|---|---|---|---|");
}

void Comparison::print(const Row& row) {
  const Tally& t = row.tally;
  const double wall = quantile(t.wallMs, 0.5);
  if (referenceMs_ == 0) referenceMs_ = wall;
  std::printf("| %s | %s | %d |", what_.c_str(), row.who.c_str(), t.cases);
  if (row.judged)
    std::printf(" %d |", t.right);
  else
    std::printf(" |");
  std::printf(" %.3g | %.3g | %.3g | %.3g |", wall, quantile(t.wallMs, 0.99), quantile(t.cpuMs, 0.5),
              referenceMs_ / wall);
  if (t.errorsMm.empty())
    std::puts(" | |");
  else
    std::printf(" %.2f | %.2f |\n", quantile(t.errorsMm, 0.5), quantile(t.errorsMm, 1));
  std::fflush(stdout);
}

}  // namespace falciform::bench
