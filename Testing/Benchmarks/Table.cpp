#include "Testing/Benchmarks/Table.h"

#include <array>
#include <cstdio>

#include "Testing/Benchmarks/Stopwatch.h"

namespace falciform::bench {

namespace {

/// Three figures, without a power of ten.
std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), value < 1000 ? "%.3g" : "%.0f", value);
  return text.data();
}

}  // namespace

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
  for (const double value : {wall, quantile(t.wallMs, 0.99), quantile(t.cpuMs, 0.5), referenceMs_ / wall})
    std::printf(" %s |", figure(value).c_str());
  if (t.errorsMm.empty())
    std::puts(" | |");
  else
    std::printf(" %.2f | %.2f |\n", quantile(t.errorsMm, 0.5), quantile(t.errorsMm, 1));
  std::fflush(stdout);
}

}  // namespace falciform::bench
