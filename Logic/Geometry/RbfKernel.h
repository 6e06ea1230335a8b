#pragma once
namespace falciform {

/// Wendland's compactly supported radial basis function w(s) = (1 - s)^6 (35 s^2 + 18 s + 3) / 3 for s < 1,
/// 0 beyond: four times continuously differentiable in space (Wendland 1995), so that curvature, of second
/// derivatives, is smooth. Derivatives are by t = s^2, where they have no singularity.
struct WendlandFunction {
  [[nodiscard]] static double value(double s) {
    const double u = 1 - s, u2 = u * u;
    return u2 * u2 * u2 * (35 * s * s + 18 * s + 3) / 3;
  }
  [[nodiscard]] static double first(double s) {
    const double u = 1 - s, u2 = u * u;
    return -28.0 / 3 * u2 * u2 * u * (5 * s + 1);
  }
  [[nodiscard]] static double second(double s) {
    const double u = 1 - s, u2 = u * u;
    return 140 * u2 * u2;
  }
  [[nodiscard]] static double thirdTimesS(double s) {
    const double u = 1 - s;
    return -280 * u * u * u;
  }
};

/// The radial basis function of a lattice: phi(r) = w(r / 3) - share * w(r / 1.75), r in lattice steps, 0
/// from three steps on. One Wendland function at every node does not add up to a constant: it ripples by
/// 4e-4, and the second derivatives of a surface by several percent. With kEvenShare the sum's Fourier
/// transform vanishes at the lattice's frequency, and with it, since the function is radial, at all six of
/// that length; what is left of the ripple is 1e-6. The price is a system that takes four times the
/// iterations.
struct RbfKernel {
  static constexpr int kReach = 3;  ///< steps
  static constexpr double kEvenShare = 0.07014969029986;
  double share = 0;

  [[nodiscard]] double value(double r) const {
    return WendlandFunction::value(r * kOuter) -
           (r < kInnerReach ? share * WendlandFunction::value(r * kInner) : 0);
  }
  /// d/dt, t = r^2
  [[nodiscard]] double first(double r) const {
    return kOuter * kOuter * WendlandFunction::first(r * kOuter) -
           (r < kInnerReach ? share * kInner * kInner * WendlandFunction::first(r * kInner) : 0);
  }
  /// d^2/dt^2
  [[nodiscard]] double second(double r) const {
    constexpr double outer = kOuter * kOuter * kOuter * kOuter, inner = kInner * kInner * kInner * kInner;
    return outer * WendlandFunction::second(r * kOuter) -
           (r < kInnerReach ? share * inner * WendlandFunction::second(r * kInner) : 0);
  }
  /// r d^3/dt^3, finite at the centre
  [[nodiscard]] double thirdTimesR(double r) const {
    constexpr double outer = kOuter * kOuter * kOuter * kOuter * kOuter,
                     inner = kInner * kInner * kInner * kInner * kInner;
    return outer * WendlandFunction::thirdTimesS(r * kOuter) -
           (r < kInnerReach ? share * inner * WendlandFunction::thirdTimesS(r * kInner) : 0);
  }

 private:
  static constexpr double kInnerReach = 1.75, kOuter = 1.0 / kReach, kInner = 1 / kInnerReach;
};

}  // namespace falciform
