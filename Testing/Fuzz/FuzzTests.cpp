#include <gtest/gtest.h>

#include "Testing/Fuzz/FuzzRun.h"

// Damaged files are refused in one line or read as something sound: never a crash, a hang, another exception,
// or an allocation beyond what the file could hold. 10,000 mutants in all; `./run fuzz --count N` tries more.

namespace falciform::test {
namespace {

constexpr int kMutants = 10000;

class Fuzz : public testing::TestWithParam<std::size_t> {
 public:
  static const std::vector<FuzzTarget>& targets() {
    static const std::vector<FuzzTarget> all = allTargets();
    return all;
  }
};

TEST_P(Fuzz, MutantsAreRefusedOrSound) {
  const FuzzTarget& target = targets().at(GetParam());
  const int count = kMutants / static_cast<int>(targets().size()) + 1;
  const FuzzOutcome outcome = fuzz(target, count, 1000 + static_cast<unsigned>(GetParam()));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_EQ(outcome.read + outcome.refused, count);
  EXPECT_GT(outcome.refused, count / 20) << "the damage does not reach the reader";
}

INSTANTIATE_TEST_SUITE_P(Readers, Fuzz, testing::Range(std::size_t{0}, Fuzz::targets().size()),
                         [](const auto& index) { return Fuzz::targets().at(index.param).name; });

}  // namespace
}  // namespace falciform::test
