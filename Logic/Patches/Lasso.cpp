#include "Logic/Patches/Lasso.h"

#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

using Outline = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Even-odd rule: how often a ray to the right crosses the line.
bool isInside(const Outline& outline, double x, double y) {
  bool inside = false;
  for (Index i = 0, j = outline.rows() - 1; i < outline.rows(); j = i++) {
    const bool spans = (outline(i, 1) > y) != (outline(j, 1) > y);
    if (!spans) continue;
    const double share = (y - outline(i, 1)) / (outline(j, 1) - outline(i, 1));
    if (x < outline(i, 0) + share * (outline(j, 0) - outline(i, 0))) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<int> pointsInLasso(const Surface& surface, const Points& normals, const TriangleTree* tree,
                               const LassoView& view, const Outline& outline) {
  if (outline.rows() < 3) return {};
  const Eigen::RowVector2d low = outline.colwise().minCoeff(), high = outline.colwise().maxCoeff();
  const bool faces = normals.rows() == surface.size();
  const double reach =
      surface.size() > 0 ? (surface.points.colwise().maxCoeff() - surface.points.colwise().minCoeff()).norm()
                         : 0;
  std::vector<char> chosen(static_cast<std::size_t>(surface.size()), 0);
  forEachChunk(chosen.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3d point = surface.points.row(static_cast<Index>(i)).transpose();
      const Eigen::Vector4d screen = view.screenFromSurface * point.homogeneous();
      if (!(screen.w() > 0)) continue;
      const double x = screen.x() / screen.w(), y = screen.y() / screen.w();
      if (x < low.x() || x > high.x() || y < low.y() || y > high.y() || !isInside(outline, x, y)) continue;
      const Vector3d towards = (view.parallel ? view.eye : Vector3d(view.eye - point)).normalized();
      if (faces && !(normals.row(static_cast<Index>(i)).dot(towards) > 0)) continue;
      if (tree) {
        // From a little above the point, so that its own triangles are not in the way.
        const double lift = 1e-5 * reach;
        const auto hit = tree->cast(point + lift * towards, towards);
        if (hit && (view.parallel || hit->distance < (view.eye - point).norm() - lift)) continue;
      }
      chosen[i] = 1;
    }
  });
  std::vector<int> ids;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0) ids.push_back(static_cast<int>(i));
  return ids;
}

}  // namespace falciform
