#pragma once
#include <memory>
#include <vector>

#include "Logic/Geometry/RbfLattice.h"

namespace falciform {

/// A function of space whose zero is a surface, negative inside and about a distance in mm near it: a general
/// quadric and radial basis functions on ever finer lattices. Far from the data it means nothing. Immutable;
/// any number of threads may ask.
class RbfFunction {
 public:
  /// f(x) = a . (1, x, y, z, xx, yy, zz, xy, yz, zx) with x measured from `centre` in units of `scale`.
  struct Quadric {
    Vector3d centre = Vector3d::Zero();
    double scaleMm = 1;
    Eigen::Matrix<double, 10, 1> a = Eigen::Matrix<double, 10, 1>::Zero();
    [[nodiscard]] Jet jet(const Vector3d& place) const;
  };

  RbfFunction() = default;
  RbfFunction(Quadric quadric, std::vector<RbfLattice> levels)
      : quadric_(std::move(quadric)),
        levels_(std::make_shared<const std::vector<RbfLattice>>(std::move(levels))) {}

  [[nodiscard]] double value(const Vector3d& place) const;
  [[nodiscard]] Jet jet(const Vector3d& place) const;
  /// The place moved along the slope onto the zero by Newton's steps, none longer than `reachMm`.
  [[nodiscard]] Vector3d ontoZero(const Vector3d& place, double reachMm) const;
  /// Steps between the functions' centres, mm, coarsest first.
  [[nodiscard]] const std::vector<RbfLattice>& levels() const { return *levels_; }

 private:
  Quadric quadric_;
  std::shared_ptr<const std::vector<RbfLattice>> levels_ = std::make_shared<const std::vector<RbfLattice>>();
};

/// Unit, outward.
[[nodiscard]] Vector3d normalOf(const Jet& jet);
/// Of the level surface through the place, 1/mm, positive where it is convex: half the divergence of the
/// normal.
[[nodiscard]] double meanCurvatureOf(const Jet& jet);

}  // namespace falciform
