#include "Logic/Geometry/RbfStiffness.h"

#include <array>
#include <cmath>

namespace falciform {

namespace {

/// The ten different third derivatives, each times the root of how often it occurs among the 27.
Eigen::Matrix<double, 10, 1> thirdDerivatives(const RbfKernel& kernel, const Vector3d& x) {
  Eigen::Matrix<double, 10, 1> d = Eigen::Matrix<double, 10, 1>::Zero();
  const double r = x.norm();
  if (r >= RbfKernel::kReach) return d;
  // Of phi(t), t = |x|^2: 8 x_i x_j x_k phi''' + 4 (d_ij x_k + d_jk x_i + d_ki x_j) phi''.
  const double third = r > 1e-9 ? 8 * kernel.thirdTimesR(r) / r : 0;
  const double second = 4 * kernel.second(r);
  constexpr std::array<std::array<int, 3>, 10> kinds{{{0, 0, 0},
                                                      {1, 1, 1},
                                                      {2, 2, 2},
                                                      {0, 0, 1},
                                                      {0, 0, 2},
                                                      {1, 1, 0},
                                                      {1, 1, 2},
                                                      {2, 2, 0},
                                                      {2, 2, 1},
                                                      {0, 1, 2}}};
  for (std::size_t n = 0; n < kinds.size(); ++n) {
    const auto [i, j, k] = kinds[n];
    double value = third * x[i] * x[j] * x[k];
    value += second * ((i == j ? x[k] : 0) + (j == k ? x[i] : 0) + (k == i ? x[j] : 0));
    const double times = n < 3 ? 1 : n < 9 ? 3 : 6;
    d[static_cast<Index>(n)] = std::sqrt(times) * value;
  }
  return d;
}

}  // namespace

RbfCellStiffness rbfCellStiffness(const RbfKernel& kernel) {
  RbfCellStiffness cell;
  constexpr int reach = RbfKernel::kReach;
  const double gauss = 0.5 / std::sqrt(3.0);
  std::vector<Vector3d> places;
  for (int corner = 0; corner < 8; ++corner)
    places.emplace_back(0.5 + ((corner & 1) != 0 ? gauss : -gauss),
                        0.5 + ((corner & 2) != 0 ? gauss : -gauss),
                        0.5 + ((corner & 4) != 0 ? gauss : -gauss));
  for (int z = 1 - reach; z <= reach; ++z)
    for (int y = 1 - reach; y <= reach; ++y)
      for (int x = 1 - reach; x <= reach; ++x) {
        bool reaches = false;
        for (const Vector3d& p : places) reaches = reaches || (p - Vector3d(x, y, z)).norm() < reach;
        if (reaches) cell.nodes.emplace_back(x, y, z);
      }
  const Index n = std::ssize(cell.nodes);
  Eigen::MatrixXd rows(10 * std::ssize(places), n);
  for (std::size_t p = 0; p < places.size(); ++p)
    for (Index a = 0; a < n; ++a)
      rows.block<10, 1>(10 * static_cast<Index>(p), a) =
          thirdDerivatives(kernel, places[p] - cell.nodes[static_cast<std::size_t>(a)].cast<double>());
  cell.matrix = rows.transpose() * rows / static_cast<double>(places.size());
  return cell;
}

}  // namespace falciform
