#pragma once
#include "Logic/Core/Surface.h"

namespace falciform {

/// How a soft organ may bend, in 60 numbers: displacement fields of the pre-op organ that are polynomials of
/// degree <= 3 in the place, and the strain energy each of them costs. A rigid registration that leaves these
/// free, at their price, is not pulled away by what is merely bent (Docs/Decisions/ElasticFinish.md).
class ElasticModes {
 public:
  static constexpr int kMonomials = 20, kUnknowns = 3 * kMonomials, kNonRigid = kUnknowns - 6;
  using Monomials = Eigen::Matrix<double, kMonomials, 1>;
  /// u(x) = coefficients^T monomials(x), mm.
  using Coefficients = Eigen::Matrix<double, kMonomials, 3>;
  using Energy = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  /// Integrals run over the volume that `preop` (LPS mm, triangles outward) encloses; over its surface if it
  /// encloses none. Poisson's ratio in [0, 0.5): that of liver.
  explicit ElasticModes(const Surface& preop, double poissonRatio = 0.47);

  [[nodiscard]] Monomials monomials(const Vector3d& x) const;
  /// All 84 monomials of degree <= 6, the 20 of `monomials` first, a row for each of the N x 3 places.
  static constexpr int kProducts = 84;
  using Products = Eigen::Matrix<double, Eigen::Dynamic, kProducts>;
  [[nodiscard]] Products products(const Eigen::Matrix<double, Eigen::Dynamic, 3>& places) const;
  /// Which of the 84 the product of two of the 20 is.
  using ProductTable = Eigen::Matrix<int, kMonomials, kMonomials>;
  [[nodiscard]] static const ProductTable& productTable();
  [[nodiscard]] Vector3d displacement(const Coefficients& u, const Vector3d& x) const {
    return u.transpose() * monomials(x);
  }
  /// Column-wise stacked coefficients q: q^T energy q is the organ's mean of eps:eps + nu/(1 - 2 nu)
  /// tr(eps)^2 + kSmoothness L^2 |grad grad u|^2, the energy density over mu of an isotropic solid that
  /// resists gradients of strain as well (Mindlin 1964). L is the root mean square distance of the surface's
  /// points from their centroid. Zero for infinitesimal rigid motions.
  static constexpr double kSmoothness = 0.15;
  [[nodiscard]] const Energy& energy() const { return energy_; }
  /// The rigid motion nearest to x -> x + u(x) in the mean square over the organ.
  [[nodiscard]] Isometry3d rigidPart(const Coefficients& u) const;
  /// v with x + u(x) = rigid (x + v(x)).
  [[nodiscard]] Coefficients without(const Isometry3d& rigid, const Coefficients& u) const;
  /// Root of the mean over the organ of |u|^2, mm.
  [[nodiscard]] double rootMeanSquare(const Coefficients& u) const;
  /// Means over the organ of the products of the 20 monomials with one another.
  [[nodiscard]] const Eigen::Matrix<double, kMonomials, kMonomials>& meanProducts() const {
    return products_;
  }

 private:
  Vector3d centre_ = Vector3d::Zero();
  double scaleMm_ = 1;
  Eigen::Matrix<double, kMonomials, kMonomials> products_;
  Energy energy_;
};

}  // namespace falciform
