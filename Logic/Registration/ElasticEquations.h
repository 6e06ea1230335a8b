#pragma once
#include "Logic/Registration/ElasticModes.h"

namespace falciform {

/// Normal equations of the 60 coefficients of ElasticModes. A product of two of the monomials is a monomial
/// of degree <= 6, of which there are 84: sums of those, weighted with the six products of the observed
/// directions, hold every entry of the 60 x 60 matrix, at a seventh of the work of summing the entries.
class ElasticEquations {
 public:
  using Unknowns = Eigen::Matrix<double, ElasticModes::kUnknowns, 1>;

  /// What was seen of the displacement at some places, to be added at once.
  class Observations {
   public:
    explicit Observations(Index capacity)
        : places_(capacity, 3), squares_(capacity, 6), pulls_(capacity, 3) {}
    /// u(x) along the unit `normal` is `value` mm; x LPS mm of the preop frame, weight 1/mm^2.
    void addAlong(const Vector3d& x, const Vector3d& normal, double value, double weight);
    /// u(x) is `value`, mm.
    void addWhole(const Vector3d& x, const Vector3d& value, double weight);

   private:
    friend class ElasticEquations;
    Index count_ = 0;
    Eigen::Matrix<double, Eigen::Dynamic, 3> places_;
    Eigen::Matrix<double, Eigen::Dynamic, 6> squares_;  // weight times n n^T: xx, xy, xz, yy, yz, zz
    Eigen::Matrix<double, Eigen::Dynamic, 3> pulls_;    // weight times value times n
  };

  void add(const ElasticModes& modes, const Observations& seen);
  void add(const ElasticEquations& others);
  [[nodiscard]] ElasticModes::Energy matrix() const;
  /// Coefficients in the order of matrix(): column-wise stacked.
  [[nodiscard]] Unknowns right() const;

 private:
  Eigen::Matrix<double, ElasticModes::kProducts, 6> squares_ =
      Eigen::Matrix<double, ElasticModes::kProducts, 6>::Zero();
  ElasticModes::Coefficients pulls_ = ElasticModes::Coefficients::Zero();
};

}  // namespace falciform
