#pragma once
#include <vector>

namespace falciform::bench {

/// How one registration went.
struct Outcome {
  double errorMm = 0;   ///< mean target error
  double apartMm = 0;   ///< from where the best rigid motion puts the targets
  bool right = false;   ///< by the criterion of the table
  bool warned = false;  ///< it carried at least one warning
  double wallMs = 0, cpuMs = 0;
};

/// Counts over the cases of one row.
struct Tally {
  int cases = 0, right = 0, silent = 0, falseAlarms = 0, within5 = 0;
  std::vector<double> errorsMm, wallMs, cpuMs;

  void add(const Outcome& o) {
    ++cases;
    right += o.right;
    silent += !o.right && !o.warned;
    falseAlarms += o.right && o.warned;
    within5 += o.apartMm < 5;
    errorsMm.push_back(o.errorMm);
    wallMs.push_back(o.wallMs);
    cpuMs.push_back(o.cpuMs);
  }
  /// A run that is timed alone.
  void addTime(double wall, double cpu) {
    ++cases;
    wallMs.push_back(wall);
    cpuMs.push_back(cpu);
  }
  [[nodiscard]] double rightShare() const { return static_cast<double>(right) / cases; }
  /// Right, or failed with a warning.
  [[nodiscard]] double saidShare() const { return 1 - static_cast<double>(silent) / cases; }
};

}  // namespace falciform::bench
