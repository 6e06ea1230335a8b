#include "Logic/Core/IncompleteBeta.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace falciform {
namespace {

TEST(IncompleteBeta, MeetsItsClosedForms) {
  for (const double x : {0.0, 0.01, 0.3, 0.5, 0.77, 0.999, 1.0}) {
    EXPECT_NEAR(incompleteBeta(1, 1, x), x, 1e-14);
    EXPECT_NEAR(incompleteBeta(3, 1, x), x * x * x, 1e-14);
    EXPECT_NEAR(incompleteBeta(1, 4, x), 1 - std::pow(1 - x, 4), 1e-14);
    EXPECT_NEAR(incompleteBeta(0.5, 0.5, x), 2 / std::numbers::pi * std::asin(std::sqrt(x)), 1e-13);
    EXPECT_NEAR(incompleteBeta(2.5, 7, x), 1 - incompleteBeta(7, 2.5, 1 - x), 1e-14);
  }
}

}  // namespace
}  // namespace falciform
