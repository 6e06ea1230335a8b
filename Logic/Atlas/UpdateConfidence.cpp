#include "Logic/Atlas/UpdateConfidence.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr double kLeastArea = 0.03;
constexpr std::array<const char*, 6> kSides{"left side", "right side", "back", "front", "top", "underside"};

/// In LPS +x is left, +y back, +z up.
std::size_t sideOf(const Vector3d& normal) {
  Index axis = 0;
  (void)normal.cwiseAbs().maxCoeff(&axis);
  return static_cast<std::size_t>(2 * axis) + (normal[axis] >= 0 ? 0 : 1);
}

double middlePlane(const Surface& liver) {
  const std::vector<int> falciform = pointsOfPatch(liver, patch::kFalciform);
  double sum = 0;
  for (const int id : falciform) sum += liver.points(id, 0);
  if (!falciform.empty()) return sum / static_cast<double>(falciform.size());
  const double right = liver.points.col(0).minCoeff(), left = liver.points.col(0).maxCoeff();
  return left - (left - right) / 3;
}

}  // namespace

std::vector<RegionExpectation> expectationByRegion(const Surface& liver, const VectorXd& expectedMm) {
  if (expectedMm.size() != liver.size())
    throw InputError("there are " + std::to_string(expectedMm.size()) + " expected errors for " +
                     std::to_string(liver.size()) + " points; give one for each");
  if (liver.triangles.rows() == 0) return {};
  const double middle = middlePlane(liver);
  std::array<double, 12> areas{}, sums{};
  for (Index t = 0; t < liver.triangles.rows(); ++t) {
    std::array<Vector3d, 3> corner;
    double expected = 0;
    for (Index k = 0; k < 3; ++k) {
      corner[static_cast<std::size_t>(k)] = liver.points.row(liver.triangles(t, k)).transpose();
      expected += expectedMm[liver.triangles(t, k)] / 3;
    }
    const Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const bool left = (corner[0] + corner[1] + corner[2]).x() / 3 > middle;
    const std::size_t region = 2 * sideOf(normal) + (left ? 1 : 0);
    areas[region] += normal.norm() / 2;
    sums[region] += expected * normal.norm() / 2;
  }
  double total = 0;
  for (const double area : areas) total += area;
  std::vector<RegionExpectation> regions;
  for (std::size_t r = 0; r < areas.size(); ++r) {
    if (!(areas[r] > kLeastArea * total)) continue;
    regions.push_back(
        {std::string("the ") + kSides[r / 2] + (r % 2 ? " of the left lobe" : " of the right lobe"),
         areas[r] / total, sums[r] / areas[r]});
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const auto& a, const auto& b) { return a.meanMm > b.meanMm; });
  return regions;
}

}  // namespace falciform
