#include "Modules/CommandLine/Figures.h"

#include <charconv>
#include <cmath>

#include "Logic/Geometry/Measures.h"

namespace falciform::commandline {

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  char text[400];  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  const std::string shown(text, end);
  const bool zero = shown.find_first_of("123456789") == std::string::npos;
  return zero && shown[0] == '-' ? shown.substr(1) : shown;
}

nlohmann::json toJson(const SurfaceImportResult& result) {
  return {{"points", result.surface.size()},
          {"triangles", result.surface.triangles.rows()},
          {"topology", describeTopology(result.topology)},
          {"closed_manifold", result.topology.closedManifold()},
          {"surface_volume_mm3", result.surfaceVolumeMm3},
          {"voxel_volume_mm3", result.voxelVolumeMm3},
          {"area_mm2", area(result.surface)},
          {"mean_edge_mm", result.quality.meanEdgeMm},
          {"self_crossings", result.quality.crossings},
          {"mean_distance_to_mask_mm", result.quality.meanMm},
          {"p95_distance_to_mask_mm", result.quality.p95Mm},
          {"max_distance_to_mask_mm", result.quality.maxMm},
          {"selected_voxels", result.selectedVoxels},
          {"dropped_voxels", result.droppedVoxels},
          {"filled_voxels", result.filledVoxels}};
}

nlohmann::json toJson(const MeshReport& report) {
  nlohmann::json json{{"nodes", report.nodes},
                      {"elements", report.elements},
                      {"degrees_of_freedom", report.degreesOfFreedom},
                      {"volume_mm3", report.volumeMm3},
                      {"surface_volume_mm3", report.inputVolumeMm3},
                      {"mean_edge_mm", report.edgeLengthMm},
                      {"min_dihedral_deg", report.minDihedralDeg},
                      {"median_dihedral_deg", report.medianDihedralDeg},
                      {"min_radius_ratio", report.minRadiusRatio},
                      {"min_scaled_jacobian", report.minScaledJacobian},
                      {"mean_distance_mm", report.meanDistanceMm},
                      {"max_distance_mm", report.maxDistanceMm},
                      {"max_uncovered_mm", report.maxUncoveredMm},
                      {"crossing_pairs", report.crossingPairs},
                      {"repairs", report.repairs},
                      {"regions", nlohmann::json::array()}};
  for (const MeshRegion& region : report.regions)
    json["regions"].push_back({{"number", region.number},
                               {"elements", region.elements},
                               {"volume_mm3", region.volumeMm3},
                               {"surface_volume_mm3", region.wantedMm3},
                               {"conforming", region.conforming}});
  return json;
}

nlohmann::json toJson(const std::vector<PatchStatistics>& patches) {
  nlohmann::json json = nlohmann::json::array();
  for (const PatchStatistics& patch : patches)
    json.push_back({{"label", patch.label},
                    {"name", patch.name},
                    {"points", patch.points},
                    {"area_mm2", patch.areaMm2},
                    {"length_mm", patch.lengthMm},
                    {"width_mm", patch.widthMm},
                    {"pieces", patch.pieces},
                    {"centroid_mm", {patch.centroid.x(), patch.centroid.y(), patch.centroid.z()}}});
  return json;
}

}  // namespace falciform::commandline
