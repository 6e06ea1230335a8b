#include "Modules/DeformationAnalysis/RegionRows.h"

#include <cmath>
#include <limits>
#include <map>

#include "Logic/Core/NumberText.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/RegionStatistics.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/IO/CsvTable.h"

namespace falciform {
namespace {

/// Of the points with these indices; of a cloud each point counts the same.
RegionRow rowOf(const std::string& name, const VectorXd& values, const VectorXd& areas) {
  double covered = 0, whole = 0;
  for (Index i = 0; i < values.size(); ++i) {
    whole += areas[i];
    covered += std::isnan(values[i]) ? 0 : areas[i];
  }
  return {name, whole > 0 ? covered / whole : std::numeric_limits<double>::quiet_NaN(),
          distanceStatistics(values)};
}

VectorXd weightsOf(const Surface& side) {
  return side.triangles.rows() > 0 ? vertexAreas(side) : VectorXd::Ones(side.size());
}

}  // namespace

std::vector<RegionRow> regionRows(const DistanceMap& map, const MapMetric& metric) {
  const VectorXd values = valuesOf(map, metric.array, metric.onScan);
  if (values.size() == 0) return {};
  const Surface& side = sideOf(map, metric.onScan);
  const VectorXd areas = weightsOf(side);
  std::vector<RegionRow> rows{rowOf("all", values, areas)};
  for (const int label : patchLabels(side)) {
    const std::vector<int> ids = pointsOfPatch(side, label);
    rows.push_back(rowOf(patchName(side, label), values(ids), areas(ids)));
  }
  const VectorXd segments = valuesOf(map, kCouinaudSegment, metric.onScan);
  std::map<int, std::vector<int>> bySegment;
  for (Index i = 0; i < segments.size(); ++i)
    if (segments[i] > 0) bySegment[static_cast<int>(segments[i])].push_back(static_cast<int>(i));
  for (const auto& [segment, ids] : bySegment)
    rows.push_back(rowOf(segmentName(segment), values(ids), areas(ids)));
  return rows;
}

std::vector<RegionRow> caseRows(const std::vector<MappedCase>& cases, const MapMetric& metric) {
  std::vector<RegionRow> rows;
  for (const MappedCase& one : cases) {
    const VectorXd values = valuesOf(*one.map, metric.array, metric.onScan);
    const Surface& side = sideOf(*one.map, metric.onScan);
    rows.push_back(values.size() > 0 ? rowOf(one.name, values, weightsOf(side))
                                     : RegionRow{one.name, std::numeric_limits<double>::quiet_NaN(),
                                                 distanceStatistics({})});
  }
  return rows;
}

std::string regionsCsv(const std::vector<MappedCase>& cases) {
  std::string csv = "case,side,metric,unit,region,coverage,count,mean,sd,median,min,max,rms,p95_absolute\n";
  for (const MappedCase& one : cases)
    for (const MapMetric& metric : metricsOf(*one.map))
      for (const RegionRow& row : regionRows(*one.map, metric)) {
        const DistanceStatistics& s = row.statistics;
        csv += csvCell(one.name) + ',' + (metric.onScan ? "scan" : "preop") + ',' + csvCell(metric.array) +
               ',' + metric.unit + ',' + csvCell(row.name) + ',' +
               (std::isfinite(row.coverage) ? numberText(row.coverage) : "") + ',' + std::to_string(s.count);
        for (const double value : {s.mean, s.sd, s.median, s.min, s.max, s.rms, s.p95Absolute})
          csv += ',' + (std::isfinite(value) ? numberText(value) : std::string());
        csv += '\n';
      }
  return csv;
}

}  // namespace falciform
