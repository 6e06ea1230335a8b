#pragma once
#include <vector>

#include "Logic/Geometry/RbfLattice.h"
#include "Logic/Geometry/RbfStiffness.h"

namespace falciform {

/// Where a function is to be 0, and along which directions its slope is to be 1. Or what is still missing of
/// that: then `value` and `slope` are what is wanted less what there is.
struct RbfWanted {
  VectorXd value;  ///< N, mm
  VectorXd slope;  ///< N
};

struct RbfLevelPlan {
  double slopeWeightMm = 1;  ///< a slope wrong by 1 counts as a distance of so much
  double penalty = 1;        ///< mm^3: weight of the integral of the squared third derivatives
};

/// The normal equations of one lattice's coefficients c for
///   sum_i (v_i - f(p_i))^2 + w^2 sum_i (s_i - n_i . grad f(p_i))^2 + penalty * integral |D^3 f|^2,
/// the energy whose free minimiser is the smoothing triharmonic spline (Duchon 1977; Carr et al. 2003), the
/// integral taken over the lattice's cells near the points. Sparse, symmetric and positive definite. Same
/// bits for any number of threads.
class RbfSystem {
 public:
  /// `points`, `normals`: N x 3, mm and unit vectors. All that is passed must outlive this but the plan.
  RbfSystem(const RbfLattice& lattice, const Points& points, const Points& normals, const RbfLevelPlan& plan);

  struct Solution {
    VectorXd coefficients;  ///< of lattice.centres()
    int iterations = 0;
    bool converged = false;
  };
  /// By conjugate gradients, until the residual has fallen by `tolerance`.
  [[nodiscard]] Solution solve(const RbfWanted& wanted, double tolerance, int mostIterations) const;

 private:
  struct Entry {
    int node;
    float value, slope;
  };
  void listEntries(const Points& points, const Points& normals);
  void listPlanes(const Points& points);
  void addSamples(int plane);
  template <class Body>
  void forPointsOf(int plane, Body&& body) const;
  void listStencils(double penalty);
  void addCells(int plane);
  void mirror();
  [[nodiscard]] VectorXd rightSide(const RbfWanted& wanted) const;
  [[nodiscard]] VectorXd times(const VectorXd& x, std::vector<double>& onNodes) const;

  const RbfLattice& lattice_;
  double slopeWeight2_;
  // The offsets between nodes that overlap, in runs along x, each symmetric about its middle.
  struct Run {
    int shift, length, begin;
  };
  std::vector<Run> runs_;
  int width_ = 0;            // entries a row
  std::vector<int> slotOf_;  // by difference of nodes + largest difference
  int largestShift_ = 0;
  std::vector<int> rowOf_;     // by node, -1 where not in use
  std::vector<int> planeRow_;  // first row of each plane
  std::vector<double> matrix_;

  std::vector<std::size_t> entryBegin_;  // by point
  std::vector<Entry> entries_;
  std::vector<std::vector<int>> pointsInPlane_;
  std::vector<char> charged_;  // by node: whether the cell above it is near a point
  // What a charged cell adds to the row of a node, by where the node stands from the cell's corner: entries
  // at and right of the diagonal.
  std::vector<int> cellShift_;
  std::vector<VectorXd> stencil_;
};

}  // namespace falciform
