#pragma once
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace falciform::bench {

/// Wall time and the processor time of the whole process, all threads.
struct Spent {
  double wallMs = 0, cpuMs = 0;
};

template <class Body>
[[nodiscard]] Spent measured(Body&& body) {
  const auto cpuNow = [] {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
  };
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = cpuNow();
  body();
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall).count(),
          cpuNow() - cpu};
}

/// The smallest value that at least `share` of the values do not exceed; the values must not be empty.
[[nodiscard]] inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(values.size())) - 1;
  return values[static_cast<std::size_t>(std::max(0.0, rank))];
}

}  // namespace falciform::bench
