#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Types.h"

namespace falciform {

struct PermutationSettings {
  int permutations = 100000;  ///< all arrangements of the labels if they are no more; else so many drawn
  int seed = 1;               ///< of the arrangements drawn
};

template <class Visitor>
void describe(PermutationSettings& s, Visitor&& field) {
  field(
      FieldInfo{"permutations", "Permutations", "", 100, 10000000,
                "All arrangements of the group labels are tried if they are no more than this; else so many "
                "are drawn at random."},
      s.permutations);
  field(FieldInfo{"seed", "Seed", "", 0, 2147483647, "Of the arrangements drawn at random."}, s.seed);
}

/// How often labels dealt out anew give at least what the true ones give. It asks nothing of the values but
/// that, if groups do not matter, any arrangement of the labels is as likely as the true one.
struct PermutationTest {
  double arrangements = 0;  ///< different arrangements of the labels
  Index tried = 0;          ///< the true one among them
  bool exact = false;       ///< all were tried; else they were drawn at random
  double pGreater = std::numeric_limits<double>::quiet_NaN();   ///< share with as large a statistic
  double pTwoSided = std::numeric_limits<double>::quiet_NaN();  ///< share with as large an absolute one
};

/// Number of different arrangements: n! / (n1! n2! ...).
[[nodiscard]] double labelArrangements(const std::vector<int>& labels);

/// `statistic` is called with every arrangement of `labels`, or with a random sample in which the true one
/// counts as one more (Phipson and Smyth 2010: p is never 0). Values within 1e-12 of each other are alike,
/// so that ties do not hang on rounding. `statistic` is called from several threads.
[[nodiscard]] PermutationTest permuteLabels(const std::vector<int>& labels,
                                            const std::function<double(const std::vector<int>&)>& statistic,
                                            const PermutationSettings& settings = {},
                                            const Progress& progress = {});

}  // namespace falciform
