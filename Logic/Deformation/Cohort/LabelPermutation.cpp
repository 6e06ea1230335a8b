#include "Logic/Deformation/Cohort/LabelPermutation.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr double kTie = 1e-12;

/// Counts arrangements whose statistic is as extreme as the true one.
struct Extremes {
  double truth = 0;
  Index greater = 0, twoSided = 0;

  void count(double value) {
    if (value >= truth - kTie) ++greater;
    if (std::abs(value) >= std::abs(truth) - kTie) ++twoSided;
  }
};

/// Fisher and Yates; the numbers of draw i are its own, whatever thread makes it.
std::vector<int> shuffled(std::vector<int> labels, int seed, std::size_t draw) {
  Draws draws(static_cast<std::uint64_t>(seed), draw);
  for (std::size_t k = labels.size(); k > 1; --k) {
    const auto other = static_cast<std::size_t>(draws.uniform() * static_cast<double>(k));
    std::swap(labels[k - 1], labels[std::min(other, k - 1)]);
  }
  return labels;
}

}  // namespace

double labelArrangements(const std::vector<int>& labels) {
  // A product of binomial coefficients, each a whole number: exact to 2^53.
  std::map<int, int> counts;
  double product = 1;
  int placed = 0;
  for (const int label : labels) {
    ++placed;
    product = std::round(product * placed / ++counts[label]);
  }
  return product;
}

PermutationTest permuteLabels(const std::vector<int>& labels,
                              const std::function<double(const std::vector<int>&)>& statistic,
                              const PermutationSettings& settings, const Progress& progress) {
  PermutationTest test;
  test.arrangements = labelArrangements(labels);
  test.exact = test.arrangements <= settings.permutations;
  const Extremes start{statistic(labels)};
  if (!std::isfinite(start.truth)) return test;
  if (test.exact) {
    Extremes all = start;
    std::vector<int> arranged = labels;
    std::sort(arranged.begin(), arranged.end());
    do {
      all.count(statistic(arranged));
      if (++test.tried % 4096 == 0 && progress.stopRequested()) throw Cancelled();
    } while (std::next_permutation(arranged.begin(), arranged.end()));
    test.pGreater = static_cast<double>(all.greater) / static_cast<double>(test.tried);
    test.pTwoSided = static_cast<double>(all.twoSided) / static_cast<double>(test.tried);
    return test;
  }
  std::atomic<Index> greater = 1, twoSided = 1;  // the true arrangement
  forEachChunk(static_cast<std::size_t>(settings.permutations), 1000,
               [&](std::size_t begin, std::size_t end) {
                 if (progress.stopRequested()) throw Cancelled();
                 Extremes chunk = start;
                 for (std::size_t i = begin; i < end; ++i)
                   chunk.count(statistic(shuffled(labels, settings.seed, i)));
                 greater += chunk.greater;
                 twoSided += chunk.twoSided;
               });
  test.tried = settings.permutations + 1;
  test.pGreater = static_cast<double>(greater) / static_cast<double>(test.tried);
  test.pTwoSided = static_cast<double>(twoSided) / static_cast<double>(test.tried);
  return test;
}

}  // namespace falciform
