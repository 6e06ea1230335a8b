#pragma once
#include <Eigen/Core>
#include <cstdint>

namespace falciform {

inline constexpr double kGravityMPerS2 = 9.81;

/// `count` points in the unit cube of `dimensions`, one a row: along each axis exactly one in every of
/// `count` equal slices (McKay, Beckman, Conover 1979). The same on every machine for the same seed and
/// stream.
[[nodiscard]] Eigen::MatrixXd latinHypercube(int count, int dimensions, std::uint64_t seed,
                                             std::uint64_t stream);

}  // namespace falciform
