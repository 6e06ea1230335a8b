#include "Logic/Core/SupportPainting.h"

#include <cmath>
#include <set>

#include "Logic/Core/Errors.h"

namespace falciform {

SupportPainting emptySupportPainting(Index points) {
  using namespace support_label;
  SupportPainting painting;
  painting.labels.assign(static_cast<std::size_t>(points), kFree);
  painting.regions = {{kVenaCava, {"vena cava", SupportRegionKind::Fixed}},
                      {kPosteriorBed, {"posterior bed", SupportRegionKind::Sliding}},
                      {kLeftPacking, {"packing under left lobe", SupportRegionKind::Pushed, 20}},
                      {kRightPacking, {"packing under right lobe", SupportRegionKind::Pushed, 20}}};
  return painting;
}

std::vector<int> paintedSupports(const SupportPainting& painting) {
  std::set<int> found(painting.labels.begin(), painting.labels.end());
  found.erase(support_label::kFree);
  return {found.begin(), found.end()};
}

void checkSupportPainting(const SupportPainting& painting, Index points, const std::string& what) {
  if (painting.labels.size() != static_cast<std::size_t>(points))
    throw InputError(what + " has " + std::to_string(painting.labels.size()) +
                     " labels, but the pre-operative surface " + std::to_string(points) +
                     " points; paint the supports of this surface");
  for (const int label : paintedSupports(painting))
    if (!painting.regions.contains(label))
      throw InputError(what + ": label " + std::to_string(label) + " is painted but no region has it");
  for (const auto& [label, region] : painting.regions) {
    if (label < 1 || label > support_label::kMax)
      throw InputError(what + ": region label " + std::to_string(label) + " is outside of 1 to 255");
    if (!(std::abs(region.pushMm) <= kMaxPushMm))
      throw InputError(what + ": '" + region.name + "' is pushed by " + std::to_string(region.pushMm) +
                       " mm; choose between -60 and 60");
  }
  if (!(std::abs(painting.turnDeg) <= 90))
    throw InputError(what + ": a turn of " + std::to_string(painting.turnDeg) +
                     " degrees is outside of -90 to 90");
}

}  // namespace falciform
