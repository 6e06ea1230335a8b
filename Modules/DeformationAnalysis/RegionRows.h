#pragma once
#include <string>
#include <vector>

#include "Widgets/Rendering/MappedCase.h"

namespace falciform {

/// One line of the table: the whole, a patch, a segment, or one case of several.
struct RegionRow {
  std::string name;
  double coverage =
      0;  ///< share of its area (of its points on a cloud) with a value, in [0, 1]; NaN: no area
  DistanceStatistics statistics;  ///< in the metric's unit
};

/// The whole side first, then its patches and segments. Empty if the map does not hold the metric.
[[nodiscard]] std::vector<RegionRow> regionRows(const DistanceMap& map, const MapMetric& metric);
/// A row a case, of its whole side; cases without the metric have no values.
[[nodiscard]] std::vector<RegionRow> caseRows(const std::vector<MappedCase>& cases, const MapMetric& metric);

/// Every region of every metric of every case: "case,side,metric,unit,region,coverage,count,mean,...", C
/// locale, no value an empty cell.
[[nodiscard]] std::string regionsCsv(const std::vector<MappedCase>& cases);

}  // namespace falciform
