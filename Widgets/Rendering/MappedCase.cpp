#include "Widgets/Rendering/MappedCase.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace falciform {

namespace {

struct Suffix {
  const char *ending, *unit;
};

// The longer of two that fit comes first.
constexpr std::array<Suffix, 5> kSuffixes{
    {{"_per_mm2", "1/mm²"}, {"_per_mm", "1/mm"}, {"_mm2", "mm²"}, {"_mm", "mm"}, {"_deg", "deg"}}};

}  // namespace

MapMetric metricOf(const std::string& array, bool onScan) {
  MapMetric metric{array, onScan, array, "", ""};
  for (const Suffix& suffix : kSuffixes)
    if (array.ends_with(suffix.ending)) {
      metric.unit = suffix.unit;
      metric.title.resize(array.size() - std::string(suffix.ending).size());
      break;
    }
  std::replace(metric.title.begin(), metric.title.end(), '_', ' ');
  if (!metric.title.empty())
    metric.title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(metric.title[0])));
  if (array == kSignedDistance) metric.meaning = "Positive: the scan lies outside the pre-operative surface";
  if (array == kCurvatureDifference) {
    metric.title = "Mean-curvature difference";
    metric.meaning = "Positive: the scan is more convex than the pre-operative surface";
  }
  return metric;
}

std::vector<MapMetric> metricsOf(const DistanceMap& map) {
  std::vector<MapMetric> metrics;
  for (const bool onScan : {false, true}) {
    const auto begin = static_cast<std::ptrdiff_t>(metrics.size());
    for (const auto& [array, values] : sideOf(map, onScan).arrays)
      if (values.size() > 0 && array != kCouinaudSegment) metrics.push_back(metricOf(array, onScan));
    const auto rank = [](const MapMetric& metric) {
      return metric.array == kSignedDistance ? 0 : metric.array == kCurvatureDifference ? 1 : 2;
    };
    std::stable_sort(metrics.begin() + begin, metrics.end(),
                     [&](const MapMetric& a, const MapMetric& b) { return rank(a) < rank(b); });
  }
  return metrics;
}

const Surface& sideOf(const DistanceMap& map, bool onScan) { return onScan ? map.scan : map.preop; }

VectorXd valuesOf(const DistanceMap& map, const std::string& array, bool onScan) {
  const Surface& side = sideOf(map, onScan);
  const auto found = side.arrays.find(array);
  return found == side.arrays.end() ? VectorXd() : found->second;
}

}  // namespace falciform
