#include "Logic/Deformation/RegionStatistics.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Figures of sets of points of one side.
class Side {
 public:
  explicit Side(const Surface& surface)
      : isMesh_(surface.triangles.rows() > 0),
        areas_(vertexAreas(surface)),
        distance_(surface.arrays.at(kSignedDistance)) {
    const auto curvature = surface.arrays.find(kCurvatureDifference);
    if (curvature != surface.arrays.end()) curvature_ = &curvature->second;
  }

  [[nodiscard]] RegionFigures of(RegionFigures::Kind kind, int label, std::string name,
                                 const std::vector<int>& ids) const {
    RegionFigures figures;
    figures.kind = kind;
    figures.label = label;
    figures.name = std::move(name);
    double covered = 0, whole = 0;
    for (const int i : ids) {
      whole += areas_[i];
      covered +=
          std::isnan(distance_[i]) ? 0 : areas_[i];  // in the same order, so that all of it is exactly 1
    }
    figures.areaMm2 = isMesh_ ? whole : kNoValue;
    figures.coverage = whole > 0 ? covered / whole : kNoValue;
    figures.distance = distanceStatistics(distance_(ids));
    figures.curvatureDifference =
        distanceStatistics(curvature_ == nullptr ? VectorXd() : VectorXd((*curvature_)(ids)));
    return figures;
  }

 private:
  bool isMesh_;
  VectorXd areas_;
  const VectorXd& distance_;
  const VectorXd* curvature_ = nullptr;
};

}  // namespace

std::vector<RegionFigures> regionStatistics(const Surface& side) {
  using enum RegionFigures::Kind;
  const Side figures(side);
  std::vector<int> ids(static_cast<std::size_t>(side.size()));
  std::iota(ids.begin(), ids.end(), 0);
  std::vector<RegionFigures> regions{figures.of(All, 0, "all", ids)};
  for (const int label : patchLabels(side))
    regions.push_back(figures.of(Patch, label, patchName(side, label), pointsOfPatch(side, label)));
  const auto segments = side.arrays.find(kCouinaudSegment);
  if (segments == side.arrays.end()) return regions;
  std::map<int, std::vector<int>> bySegment;
  for (Index i = 0; i < side.size(); ++i)
    if (segments->second[i] > 0)  // false for NaN
      bySegment[static_cast<int>(segments->second[i])].push_back(static_cast<int>(i));
  for (const auto& [segment, members] : bySegment)
    regions.push_back(figures.of(Segment, segment, segmentName(segment), members));
  return regions;
}

std::string segmentName(int segment) {
  constexpr const char* kRoman[] = {"I", "II", "III", "IV", "V", "VI", "VII", "VIII"};
  return "segment " + (segment >= 1 && segment <= 8 ? kRoman[segment - 1] : std::to_string(segment));
}

}  // namespace falciform
