#pragma once
#include <array>
#include <cmath>
#include <limits>

#include "Logic/Core/Types.h"

namespace falciform {

// One quadric against the points around one place: the innermost loop of Curvature, inline for speed.

/// Height h over the tangent plane near (0, 0): first and second derivatives there.
struct QuadricSlopes {
  double hu = 0, hv = 0, huu = 0, huv = 0, hvv = 0;
};

/// Sums of u^i v^j up to the fourth degree and of h times those up to the second, over the points around a
/// place; u, v and h are lengths over the neighbourhood's size, so that all are near 1. Two points at a time,
/// for the processor's two lanes.
class QuadricMoments {
 public:
  using Two = Eigen::Array2d;

  /// A lane of zeros (u = v = h = 0) adds nothing.
  void add(const Two& u, const Two& v, const Two& h) {
    const Two uu = u * u, uv = u * v, vv = v * v;
    sum_[U] += u, sum_[V] += v, sum_[UU] += uu, sum_[UV] += uv, sum_[VV] += vv;
    sum_[UUU] += uu * u, sum_[UUV] += uu * v, sum_[UVV] += vv * u, sum_[VVV] += vv * v;
    sum_[UUUU] += uu * uu, sum_[UUUV] += uu * uv, sum_[UUVV] += uu * vv;
    sum_[UVVV] += uv * vv, sum_[VVVV] += vv * vv;
    sum_[H] += h, sum_[HU] += h * u, sum_[HV] += h * v;
    sum_[HUU] += h * uu, sum_[HUV] += h * uv, sum_[HVV] += h * vv;
  }

  /// Least squares of h = f + hu u + hv v + huu/2 u^2 + huv uv + hvv/2 v^2 over `count` points. NaN where the
  /// points do not tell a quadric: too few of them, in line, or on one conic.
  [[nodiscard]] QuadricSlopes fitWithLinearTerms(double count) const {
    // The constant is taken out first: what is left are covariances.
    const double u = at(U), v = at(V), uu = at(UU), uv = at(UV), vv = at(VV), h = at(H), n = 1 / count;
    const double second = uu + vv, fourth = at(UUUU) + 2 * at(UUVV) + at(VVVV);
    System<5> s;
    s.row(0, {uu - u * u * n}, at(HU) - h * u * n, second);
    s.row(1, {uv - u * v * n, vv - v * v * n}, at(HV) - h * v * n, second);
    s.row(2, {at(UUU) - uu * u * n, at(UUV) - uu * v * n, at(UUUU) - uu * uu * n}, at(HUU) - h * uu * n,
          fourth);
    s.row(3, {at(UUV) - uv * u * n, at(UVV) - uv * v * n, at(UUUV) - uv * uu * n, at(UUVV) - uv * uv * n},
          at(HUV) - h * uv * n, fourth);
    s.row(4,
          {at(UVV) - vv * u * n, at(VVV) - vv * v * n, at(UUVV) - vv * uu * n, at(UVVV) - vv * uv * n,
           at(VVVV) - vv * vv * n},
          at(HVV) - h * vv * n, fourth);
    const std::array<double, 5> x = s.solve();
    return {x[0], x[1], 2 * x[2], x[3], 2 * x[4]};
  }

  /// Thesis Eq. (IV.2), (IV.3): h = a u^2 + 2 b uv + c v^2, through the place and level there.
  [[nodiscard]] QuadricSlopes fitWithoutLinearTerms() const {
    const double fourth = at(UUUU) + 2 * at(UUVV) + at(VVVV);
    System<3> s;
    s.row(0, {at(UUUU)}, at(HUU), fourth);
    s.row(1, {at(UUUV), at(UUVV)}, at(HUV), fourth);
    s.row(2, {at(UUVV), at(UVVV), at(VVVV)}, at(HVV), fourth);
    const std::array<double, 3> x = s.solve();
    return {0, 0, 2 * x[0], x[1], 2 * x[2]};
  }

 private:
  enum Sum { U, V, UU, UV, VV, UUU, UUV, UVV, VVV, UUUU, UUUV, UUVV, UVVV, VVVV, H, HU, HV, HUU, HUV, HVV };

  /// Normal equations, by L D L^T; no square roots.
  template <std::size_t N>
  struct System {
    std::array<std::array<double, N>, N> a{};
    std::array<double, N> b{}, scale{};

    void row(std::size_t i, const std::array<double, N>& lower, double right, double size) {
      a[i] = lower;
      b[i] = right;
      scale[i] = size;
    }
    [[nodiscard]] std::array<double, N> solve() {
      bool sound = true;
      std::array<double, N> inverse;
      for (std::size_t j = 0; j < N; ++j) {
        // 1e-8 of all of that degree: rounding leaves 1e-14 of it where the points tell nothing of term j.
        sound = sound && a[j][j] > 1e-8 * scale[j];
        inverse[j] = 1 / a[j][j];
        for (std::size_t i = j + 1; i < N; ++i) {
          const double factor = a[i][j] * inverse[j];
          for (std::size_t k = j + 1; k <= i; ++k) a[i][k] -= factor * a[k][j];
          b[i] -= factor * b[j];
        }
      }
      for (std::size_t i = N; i-- > 0;) {
        for (std::size_t k = i + 1; k < N; ++k) b[i] -= a[k][i] * b[k];
        b[i] *= inverse[i];
      }
      if (!sound) b.fill(std::numeric_limits<double>::quiet_NaN());
      return b;
    }
  };

  [[nodiscard]] double at(Sum which) const { return sum_[which][0] + sum_[which][1]; }

  std::array<Two, 20> sum_ = [] {
    std::array<Two, 20> zero;
    zero.fill(Two::Zero());
    return zero;
  }();
};

}  // namespace falciform
