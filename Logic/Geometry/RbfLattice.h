#pragma once
#include <array>
#include <vector>

#include "Logic/Core/Types.h"
#include "Logic/Geometry/RbfKernel.h"

namespace falciform {

/// Value, slope and second derivatives of a function of space at one place.
struct Jet {
  double value = 0;
  Vector3d gradient = Vector3d::Zero();
  Matrix3d hessian = Matrix3d::Zero();
};

/// Radial basis functions of one size on some nodes of a cubic lattice: sum of c_k phi(|x - x_k|), where phi
/// is the kernel, three lattice steps wide.
class RbfLattice {
 public:
  static constexpr int kReach = RbfKernel::kReach;

  RbfLattice() = default;
  /// A lattice of `stepMm` over the box from `low` to `high`, no node in use yet.
  RbfLattice(const Vector3d& low, const Vector3d& high, double stepMm, const RbfKernel& kernel = {});

  [[nodiscard]] const RbfKernel& kernel() const { return kernel_; }
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] const std::vector<int>& centres() const { return centres_; }  ///< nodes in use, ascending
  /// Takes the flagged nodes into use; one flag a node, see node(). Nodes too near the border are left out.
  void use(const std::vector<char>& flags);
  /// Coefficients of centres(), in their order.
  void setCoefficients(const VectorXd& coefficients);

  [[nodiscard]] std::size_t nodes() const { return coefficient_.size(); }
  [[nodiscard]] int node(int x, int y, int z) const { return x + counts_.x() * (y + counts_.y() * z); }
  [[nodiscard]] Vector3i counts() const { return counts_; }
  /// Lattice coordinates of a place, in steps.
  [[nodiscard]] Vector3d coordinates(const Vector3d& place) const { return (place - origin_) / step_; }
  [[nodiscard]] Vector3i coordinatesOf(int node) const {
    return {node % counts_.x(), node / counts_.x() % counts_.y(), node / (counts_.x() * counts_.y())};
  }
  /// Whether a place lies where every node that could reach it exists.
  [[nodiscard]] bool holds(const Vector3d& coordinates) const {
    return (coordinates.array() >= kReach).all() &&
           (coordinates.array() < (counts_.array() - 1 - kReach).cast<double>()).all();
  }

  void addValue(const Vector3d& place, double& value) const;
  void addSlope(const Vector3d& place, double& value, Vector3d& gradient) const;
  void addJet(const Vector3d& place, Jet& jet) const;

 private:
  template <class Visit>
  void visit(const Vector3d& place, Visit&& visit) const;

  RbfKernel kernel_;
  Vector3d origin_ = Vector3d::Zero();
  double step_ = 1;
  Vector3i counts_ = Vector3i::Zero();
  std::vector<int> centres_;
  std::vector<double> coefficient_;  // one a node, 0 where not in use
};

}  // namespace falciform
