#include "Testing/Benchmarks/Disturbances.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Draws.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::bench {

namespace {

constexpr double kPatchOffMm = 40, kAroundMm = 20, kSheetLongMm = 80, kSheetHighMm = 30;

std::size_t part(std::size_t count, double share) {
  return static_cast<std::size_t>(std::lround(share * static_cast<double>(count)));
}

/// The `count` of `ids` nearest to `place`, nearest first.
std::vector<int> nearestOf(const Points& points, std::vector<int> ids, const Vector3d& place,
                           std::size_t count) {
  count = std::min(count, ids.size());
  const auto nearer = [&](int a, int b) {
    return squaredDistance(points.row(a).transpose(), place) <
           squaredDistance(points.row(b).transpose(), place);
  };
  std::sort(ids.begin(), ids.end(), nearer);
  ids.resize(count);
  return ids;
}

int drawOf(const std::vector<int>& ids, Draws& draws) {
  return ids[static_cast<std::size_t>(draws.uniform() * static_cast<double>(ids.size()))];
}

/// Points of no patch that lie at least kPatchOffMm from every point of `patchIds`; all of no patch if there
/// is none.
std::vector<int> farFrom(const Surface& scan, const std::vector<int>& patchIds) {
  const KdTree tree(scan.points, patchIds);
  std::vector<int> far, bare = pointsOfPatch(scan, patch::kNone);
  for (const int i : bare)
    if (tree.nearest(scan.points.row(i).transpose(), kPatchOffMm * kPatchOffMm).index < 0) far.push_back(i);
  return far.empty() ? bare : far;
}

}  // namespace

Surface withWrongLabels(const Surface& scan, double share, std::uint64_t seed) {
  Surface wrong = scan;
  Draws draws(seed, 21);
  const std::vector<int> labels = patchLabels(scan);
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const std::vector<int> ids = pointsOfPatch(scan, labels[k]);
    const std::size_t moved = part(ids.size(), share / 2), strewn = part(ids.size(), share) - moved;
    const auto label = [&](int i) -> int& { return wrong.patch[static_cast<std::size_t>(i)]; };
    const std::vector<int> elsewhere = farFrom(scan, ids);
    for (const int i :
         nearestOf(scan.points, elsewhere, scan.points.row(drawOf(elsewhere, draws)).transpose(), moved))
      label(i) = labels[k];
    const std::vector<int> byEnd =
        nearestOf(scan.points, ids, scan.points.row(drawOf(ids, draws)).transpose(), ids.size());
    for (std::size_t i = 0; i < moved; ++i) label(byEnd[i]) = patch::kNone;
    std::vector<int> rest(byEnd.begin() + static_cast<std::ptrdiff_t>(moved), byEnd.end());
    for (std::size_t i = 0; i < std::min(strewn, rest.size()); ++i) {
      const auto other = i + static_cast<std::size_t>(draws.uniform() * static_cast<double>(rest.size() - i));
      std::swap(rest[i], rest[other]);
      label(rest[i]) = labels[(k + 1) % labels.size()];
    }
  }
  return wrong;
}

Surface withOutliers(const Surface& scan, double share, std::uint64_t seed) {
  Draws draws(seed, 22);
  const auto n = static_cast<double>(scan.size());
  const auto added = static_cast<Index>(std::lround(n * share / (1 - share)));
  Surface cluttered;
  cluttered.frame = scan.frame;
  cluttered.patchNames = scan.patchNames;
  cluttered.patch = scan.patch;
  cluttered.patch.resize(static_cast<std::size_t>(scan.size() + added), patch::kNone);
  cluttered.points.resize(scan.size() + added, 3);
  cluttered.points.topRows(scan.size()) = scan.points;
  const auto box = boundingBox(scan.points);
  const auto at = static_cast<Index>(draws.uniform() * n);
  const Vector3d foot = scan.points.row(at).transpose(), along = draws.direction();
  const Vector3d up = (scan.normals.row(at).transpose() + 0.5 * draws.direction()).normalized();
  for (Index i = 0; i < added; ++i) {
    Vector3d p;
    if (i % 2 == 0)
      for (Index axis = 0; axis < 3; ++axis)
        p[axis] = draws.uniform(box(0, axis) - kAroundMm, box(1, axis) + kAroundMm);
    else
      p = foot + draws.uniform(-0.5, 0.5) * kSheetLongMm * along.cross(up).normalized() +
          draws.uniform() * kSheetHighMm * up;
    cluttered.points.row(scan.size() + i) = p.transpose();
  }
  return cluttered;
}

}  // namespace falciform::bench
