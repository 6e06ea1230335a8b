#pragma once
#include <memory>
#include <string>
#include <vector>

#include "Logic/Core/Results.h"

namespace falciform {

/// One case of several that are looked at together, as its distance map.
struct MappedCase {
  std::string name;
  std::shared_ptr<const DistanceMap> map;      ///< never nullptr; its scan may be empty
  Matrix4d lpsFromMap = Matrix4d::Identity();  ///< rigid; brings the map's surfaces upright

  bool operator==(const MappedCase&) const = default;
};

/// Something measured that can be shown as colours: an array on one side of a map.
struct MapMetric {
  std::string array;  ///< key of Surface::arrays
  bool onScan = false;
  std::string title;    ///< "Signed distance"
  std::string unit;     ///< "mm", "1/mm"; empty: none, or not known
  std::string meaning;  ///< of the sign, one sentence; empty where it is not known

  bool operator==(const MapMetric&) const = default;
};

/// What a map holds: all arrays of its liver, then of its scan; of each the signed distance and the curvature
/// difference first. Segments are places, and no metric.
[[nodiscard]] std::vector<MapMetric> metricsOf(const DistanceMap& map);

/// Of an array by its name: "mean_curvature_difference_per_mm" is "Mean curvature difference" in 1/mm.
[[nodiscard]] MapMetric metricOf(const std::string& array, bool onScan);

[[nodiscard]] const Surface& sideOf(const DistanceMap& map, bool onScan);

/// The array's values on that side, NaN where it is not covered; empty if it has no such array.
[[nodiscard]] VectorXd valuesOf(const DistanceMap& map, const std::string& array, bool onScan);

}  // namespace falciform
