#include "Logic/Patches/SwabPatch.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Patches/FeatureSuggestions.h"

namespace falciform {

namespace {

constexpr double kStepMm = 1;
constexpr int kAside = 2;          ///< points before and after that an outlier is seen by
constexpr int kFewPoints = 5;      ///< a warning below
constexpr double kMostLost = 0.5;  ///< share of points left out that brings a warning

/// The closest place of a mesh, or the closest point of a cloud.
class Ground {
 public:
  explicit Ground(const Surface& surface) : surface_(surface), points_(surface.points) {
    if (surface.triangles.rows() > 0) triangles_ = std::make_unique<TriangleTree>(surface);
  }
  [[nodiscard]] Vector3d closest(const Vector3d& place) const {
    if (triangles_) return triangles_->closest(place).point;
    return surface_.points.row(points_.nearest(place).index);
  }

 private:
  const Surface& surface_;
  KdTree points_;
  std::unique_ptr<TriangleTree> triangles_;
};

/// By coordinate the median of the points of the same stroke just before and after; the point itself left
/// out.
Vector3d middleAround(const TrackedPoints& swab, const std::vector<Index>& stroke, std::size_t at) {
  std::vector<Index> around;
  for (std::size_t i = at > kAside ? at - kAside : 0; i < std::min(stroke.size(), at + kAside + 1); ++i)
    if (i != at) around.push_back(stroke[i]);
  Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Index i : around) values.push_back(swab.points(i, axis));
    std::sort(values.begin(), values.end());
    middle[axis] = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
  }
  return middle;
}

/// Points of each stroke, in their order.
std::vector<std::vector<Index>> strokesOf(const TrackedPoints& swab) {
  std::vector<std::vector<Index>> strokes;
  for (Index i = 0; i < swab.size(); ++i) {
    const bool sameStroke =
        i > 0 && (swab.stroke.empty() ||
                  swab.stroke[static_cast<std::size_t>(i)] == swab.stroke[static_cast<std::size_t>(i - 1)]);
    if (!sameStroke) strokes.emplace_back();
    strokes.back().push_back(i);
  }
  return strokes;
}

}  // namespace

SwabPatch patchOfSwab(const Surface& surface, const TrackedPoints& swab, const SwabSettings& settings) {
  checkSettings(settings);
  if (surface.size() == 0) throw InputError("there is no surface to paint the swab on");
  const Ground ground(surface);
  SwabPatch patch;
  std::vector<Vector3d> way;
  for (const std::vector<Index>& taken : strokesOf(swab)) {
    // What was lifted off goes first, so that it does not make its neighbours look astray.
    std::vector<Index> stroke;
    std::vector<Vector3d> on;
    for (const Index i : taken) {
      const Vector3d place = swab.points.row(i), below = ground.closest(place);
      if ((below - place).norm() > settings.liftOffMm) continue;
      stroke.push_back(i);
      on.push_back(below);
    }
    patch.liftedOff += static_cast<int>(taken.size() - stroke.size());
    bool joined = false;  // to the last point of the way
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      const Vector3d place = swab.points.row(stroke[i]);
      if (stroke.size() > 2 && (middleAround(swab, stroke, i) - place).norm() > settings.outlierMm) {
        ++patch.outliers;
        continue;
      }
      ++patch.used;
      const Vector3d before = joined ? way.back() : on[i];
      const double length = (on[i] - before).norm();
      if (joined && length <= settings.gapMm) {
        const int steps = static_cast<int>(std::ceil(length / kStepMm));
        for (int s = 1; s < steps; ++s) way.push_back(ground.closest(before + (on[i] - before) * s / steps));
        patch.lengthMm += length;
      }
      way.push_back(on[i]);
      joined = true;
    }
  }
  if (patch.used == 0)
    throw InputError("none of the swab's " + std::to_string(swab.size()) + " points lies within " +
                     std::to_string(settings.liftOffMm).substr(0, 4) +
                     " mm of the surface; are both in one frame and in mm?");
  Points line(static_cast<Index>(way.size()), 3);
  for (std::size_t i = 0; i < way.size(); ++i) line.row(static_cast<Index>(i)) = way[i].transpose();
  patch.vertices = verticesAlong(surface, line, settings.widthMm / 2);
  const int lost = patch.liftedOff + patch.outliers;
  if (patch.used < kFewPoints)
    patch.warnings.push_back("the patch rests on " + std::to_string(patch.used) + " points of the swab");
  if (lost > kMostLost * static_cast<double>(swab.size()))
    patch.warnings.push_back(std::to_string(lost) + " of the swab's " + std::to_string(swab.size()) +
                             " points lie off the surface or astray; check the tip's calibration");
  if (patch.vertices.empty())
    patch.warnings.emplace_back("no vertex lies within half the swab's width; take a wider one");
  return patch;
}

}  // namespace falciform
