#include <cstdio>
#include <cstdlib>
#include <string>

#include "Testing/Fuzz/FuzzRun.h"

// fuzz [--count N] [--seed S] [--only NAME] [--keep FOLDER]: N mutants of each good file; prints a table, and
// exits with 1 if a reader did not stand it.

int main(int count, char** words) {
  int mutants = 10000;
  unsigned seed = 1;
  std::string only, keep;
  for (int w = 1; w + 1 < count; w += 2) {
    const std::string name = words[w], value = words[w + 1];
    if (name == "--count") mutants = std::atoi(value.c_str());
    if (name == "--seed") seed = static_cast<unsigned>(std::atoi(value.c_str()));
    if (name == "--only") only = value;
    if (name == "--keep") keep = value;
  }
  std::printf("%-22s %8s %8s %8s %10s %10s\n", "reader", "mutants", "read", "refused", "slowest ms",
              "largest MB");
  int bad = 0;
  for (const auto& target : falciform::test::allTargets()) {
    if (!only.empty() && target.name.find(only) == std::string::npos) continue;
    const auto outcome = falciform::test::fuzz(target, mutants, seed, keep);
    std::printf("%-22s %8d %8d %8d %10.1f %10.2f\n", target.name.c_str(), mutants, outcome.read,
                outcome.refused, outcome.slowestMs, outcome.largestMb);
    if (!outcome.failure.empty()) {
      std::printf("  BAD: %s\n", outcome.failure.c_str());
      ++bad;
    }
    std::fflush(stdout);
  }
  return bad > 0 ? 1 : 0;
}
