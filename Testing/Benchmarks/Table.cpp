#include "Testing/Benchmarks/Table.h"

#include <algorithm>
#include <cstdio>

#include "Testing/Benchmarks/Stopwatch.h"

namespace falciform::bench {

void printHead() {
  std::puts(
      "| what | who | runs | right | wall, median, ms | wall, P99, ms | processor, median, ms | times as "
      "fast as the "
      "reference | error, median, mm | error, largest, mm |\n|---|---|---|---|---|---|---|---|---|---|");
}

void printRows(const std::string& what, const std::vector<Row>& rows, const std::string& reference) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.who == reference; });
  for (const Row& row : rows) {
    const Tally& t = row.tally;
    const double wall = quantile(t.wallMs, 0.5);
    std::printf("| %s | %s%s | %d |", what.c_str(), row.who.c_str(),
                row.who == reference ? " (reference)" : "", t.cases);
    if (row.judged)
      std::printf(" %d |", t.right);
    else
      std::printf(" |");
    std::printf(" %.3g | %.3g | %.3g |", wall, quantile(t.wallMs, 0.99), quantile(t.cpuMs, 0.5));
    if (found != rows.end())
      std::printf(" %.3g |", quantile(found->tally.wallMs, 0.5) / wall);
    else
      std::printf(" |");
    if (t.errorsMm.empty())
      std::puts(" | |");
    else
      std::printf(" %.2f | %.2f |\n", quantile(t.errorsMm, 0.5), quantile(t.errorsMm, 1));
  }
  std::fflush(stdout);
}

}  // namespace falciform::bench
