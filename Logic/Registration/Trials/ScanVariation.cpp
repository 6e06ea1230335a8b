#include "Logic/Registration/Trials/ScanVariation.h"

#include <algorithm>
#include <utility>

#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

constexpr std::uint64_t kOtherNumbers = 0x5ca1ab1e0ddba11ULL;  // than those of the perturbation
constexpr double kNearestOutlierMm = 10, kFarthestOutlierMm = 50;

Surface thinned(const Surface& scan, double share, Draws& draws) {
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(scan.size()); ++i)
    if (draws.uniform() < share) kept.push_back(i);
  return subset(scan, kept);
}

void mislabel(std::vector<int>& labels, double share, Draws& draws) {
  const std::vector<int> before = labels;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (before[i] > 0 && draws.uniform() < share) {
      const auto other = static_cast<std::size_t>(draws.uniform() * static_cast<double>(labels.size()));
      std::swap(labels[i], labels[other]);
    }
}

}  // namespace

Surface variedScan(const Surface& scan, const ScanVariation& variation, std::uint64_t seed,
                   std::uint64_t trial) {
  Draws draws(seed ^ kOtherNumbers, trial);
  Surface varied = variation.keepShare < 1 ? thinned(scan, variation.keepShare, draws) : scan;
  if (variation.noiseMm > 0)
    for (Index i = 0; i < varied.size(); ++i)
      varied.points.row(i) += variation.noiseMm * draws.normal3().transpose();
  if (variation.outlierShare > 0)
    for (Index i = 0; i < varied.size(); ++i)
      if (draws.uniform() < variation.outlierShare)
        varied.points.row(i) +=
            draws.uniform(kNearestOutlierMm, kFarthestOutlierMm) * draws.direction().transpose();
  if (variation.mislabelShare > 0) mislabel(varied.patch, variation.mislabelShare, draws);
  return varied;
}

}  // namespace falciform
