#include "Testing/Regression/SuggestedPatches.h"

#include <algorithm>
#include <random>

#include "Logic/Geometry/KdTree.h"
#include "Logic/Patches/FeatureSuggestions.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform::test {

namespace {

constexpr int kDabs = 5;
constexpr double kMissMm = 3, kDabMm = 8;

/// Points of the patch as far from each other as can be, one after the other.
std::vector<int> spread(const Points& points, const std::vector<int>& patch) {
  std::vector<int> chosen{patch.front()};
  while (static_cast<int>(chosen.size()) < kDabs) {
    const KdTree tree(points, chosen);
    int farthest = patch.front();
    double most = -1;
    for (const int v : patch) {
      const double away = tree.nearest(points.row(v)).squaredDistance;
      if (away > most) most = away, farthest = v;
    }
    chosen.push_back(farthest);
  }
  return chosen;
}

}  // namespace

Surface suggestedPreop(const UpdateCase& c) {
  Surface preop = c.preop;
  preop.patch.clear();
  const FeatureSuggestions all = suggestFeatures(preop);
  preop.patch = paintedLabels(preop, all.ridge.at(0));
  preop.patch = paintedLabels(preop, all.groove.at(0));
  return preop;
}

Surface dabbedScan(const UpdateCase& c, unsigned seed) {
  Surface scan = c.scan;
  std::fill(scan.patch.begin(), scan.patch.end(), patch::kNone);
  std::mt19937 random(seed);
  std::normal_distribution<double> miss(0, kMissMm / std::sqrt(3.0));
  const KdTree tree(scan.points);
  for (const int label : patchLabels(c.scan))
    for (const int v : spread(scan.points, pointsOfPatch(c.scan, label))) {
      const Vector3d hand(miss(random), miss(random), miss(random));
      const Vector3d hit = scan.points.row(tree.nearest(scan.points.row(v).transpose() + hand).index);
      for (const int p : tree.within(hit, kDabMm)) scan.patch[static_cast<std::size_t>(p)] = label;
    }
  return scan;
}

double targetErrorMm(const UpdateCase& c, const Surface& preop, const Surface& scan) {
  const RegistrationResult result = registerSurfaces(preop, scan, RegistrationSettings{});
  return targetErrors(c.targetsPreop, c.targetsScanner, result.scanFromPreop).mean();
}

}  // namespace falciform::test
