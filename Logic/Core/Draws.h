#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace falciform {

/// Random numbers that are a pure function of (seed, stream, counter), by SplitMix64 (Steele, Lea, Flood
/// 2014): the same on every machine, compiler and thread, which the standard library's distributions do not
/// promise.
class Draws {
 public:
  explicit Draws(std::uint64_t seed, std::uint64_t stream = 0)
      : state_(mix(mix(seed) ^ (stream * 0xd1342543de82ef95ULL))) {}

  /// Uniform in [0, 1).
  [[nodiscard]] double uniform() { return static_cast<double>(mix(state_ += kStep) >> 11) * 0x1p-53; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal, by Box and Muller.
  [[nodiscard]] double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  [[nodiscard]] Eigen::Vector3d normal3() {
    const double x = normal(), y = normal(), z = normal();
    return {x, y, z};
  }
  /// Uniform on the unit sphere.
  [[nodiscard]] Eigen::Vector3d direction() { return normal3().normalized(); }
  /// Uniform on SO(3): a normalised vector of four normals is uniform on the unit quaternions.
  [[nodiscard]] Eigen::Quaterniond rotation() {
    const double w = normal(), x = normal(), y = normal(), z = normal();
    return Eigen::Quaterniond(w, x, y, z).normalized();
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace falciform
