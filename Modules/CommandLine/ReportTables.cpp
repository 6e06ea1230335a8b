#include "Modules/CommandLine/ReportTables.h"

#include <cmath>

#include "Logic/Geometry/Measures.h"
#include "Modules/CommandLine/HtmlText.h"

namespace falciform::commandline {

namespace {

std::string count(Index value) { return std::to_string(value); }

void regionRows(HtmlTable& table, const std::string& side, const std::vector<RegionFigures>& regions,
                const DistanceStatistics RegionFigures::*metric, int decimals) {
  for (const RegionFigures& region : regions) {
    const DistanceStatistics& s = region.*metric;
    std::vector<std::string> cells{side, region.name, fixed(region.areaMm2 / 100, 1),
                                   fixed(100 * region.coverage, 1), count(s.count)};
    for (const double value : {s.mean, s.sd, s.median, s.rms, s.p95Absolute, s.min, s.max})
      cells.push_back(fixed(value, decimals));
    table.row(cells);
  }
}

/// Both sides, by region.
std::string regionTable(const DistanceMap& map, const DistanceStatistics RegionFigures::*metric,
                        int decimals) {
  HtmlTable table({"Side", "Region", "Area (cm²)", "Covered (%)", "Points", "Mean", "SD", "Median", "RMS",
                   "P95 of magnitude", "Least", "Greatest"},
                  2);
  regionRows(table, "pre-op", map.preopRegions, metric, decimals);
  regionRows(table, "scan", map.scanRegions, metric, decimals);
  return table.html();
}

/// A 4 x 4 as rows of text.
std::string matrixTable(const Isometry3d& transform) {
  HtmlTable table({"scan x, y, z from", "pre-op x", "pre-op y", "pre-op z", "offset (mm)"}, 1);
  const char* axes[] = {"x", "y", "z"};
  for (int row = 0; row < 3; ++row)
    table.row({axes[row], fixed(transform.linear()(row, 0), 6), fixed(transform.linear()(row, 1), 6),
               fixed(transform.linear()(row, 2), 6), fixed(transform.translation()[row], 3)});
  return table.html();
}

std::string basinTable(const RegistrationResult& fit) {
  if (fit.basins.size() < 2) return "";
  HtmlTable table(
      {"Pose", "Starts that ended here", "Score (0 best, 1 worst)", "Turned against the best (deg)"}, 1);
  for (std::size_t i = 0; i < fit.basins.size(); ++i) {
    const Matrix3d turn =
        fit.basins[i].scanFromPreop.linear() * fit.basins.front().scanFromPreop.linear().transpose();
    table.row({i == 0 ? "kept" : std::to_string(i + 1), std::to_string(fit.basins[i].starts),
               fixed(fit.basins[i].score, 3), fixed(Eigen::AngleAxisd(turn).angle() * 180 / EIGEN_PI, 1)});
  }
  return "<h3>Poses that the starts led to</h3>\n" + table.html();
}

template <class S>
void settingRows(HtmlTable& table, const std::string& step, S settings) {
  describe(settings, [&]<class T>(const FieldInfo& info, T& value) {
    std::string text;
    if constexpr (NamedEnum<T>)
      text = enumToString(value);
    else if constexpr (std::is_same_v<T, bool>)
      text = value ? "yes" : "no";
    else if constexpr (std::is_same_v<T, std::vector<int>>)
      text = value.empty() ? "all" : integersText(value);
    else if constexpr (std::is_same_v<T, std::string>)
      text = value;
    else
      text = numberText(static_cast<double>(value));
    table.row({step, std::string(info.label), text, std::string(info.unit), std::string(info.help)});
  });
}

}  // namespace

std::string surfaceSection(const CaseOutcome& outcome) {
  HtmlTable table({"What", "Value"});
  const Surface& preop = *outcome.preop;
  table.row(
      {"Pre-op surface", count(preop.size()) + " points, " + count(preop.triangles.rows()) + " triangles"});
  table.row({"Topology", describeTopology(inspectTopology(preop))});
  table.row({"Area", fixed(area(preop) / 100, 1) + " cm²"});
  if (outcome.import) {
    const SurfaceImportResult& import = *outcome.import;
    table.row({"Volume of the selected voxels", fixed(import.voxelVolumeMm3 / 1000, 1) + " ml (" +
                                                    std::to_string(import.selectedVoxels) + " voxels)"});
    table.row(
        {"Volume of the surface", fixed(import.surfaceVolumeMm3 / 1000, 1) + " ml, " +
                                      fixed(100 * (import.surfaceVolumeMm3 / import.voxelVolumeMm3 - 1), 2) +
                                      " % against the voxels"});
  }
  table.row({"Scan",
             count(outcome.scan->size()) + " points" +
                 (outcome.scan->triangles.rows() ? ", " + count(outcome.scan->triangles.rows()) + " triangles"
                                                 : ", a cloud") +
                 ", frame " + outcome.scan->frame});
  for (const auto& [name, surface] : outcome.structures)
    table.row({"Structure: " + name, count(surface->size()) + " points"});
  return htmlSection("Surfaces", table.html());
}

std::string patchSection(const CaseOutcome& outcome) {
  HtmlTable table({"Side", "Patch", "Points", "Area (cm²)", "Length (mm)", "Width (mm)", "Pieces"}, 2);
  const auto side = [&](const char* name, const std::vector<PatchStatistics>& patches) {
    for (const PatchStatistics& patch : patches)
      table.row({name, patch.name, count(patch.points),
                 patch.areaMm2 > 0 ? fixed(patch.areaMm2 / 100, 1) : "-", fixed(patch.lengthMm, 1),
                 fixed(patch.widthMm, 1), std::to_string(patch.pieces)});
  };
  side("pre-op", outcome.preopPatches);
  side("scan", outcome.scanPatches);
  return htmlSection("Patches", table.empty() ? htmlParagraph("Nothing is painted.") : table.html());
}

std::string registrationSection(const CaseOutcome& outcome) {
  const RegistrationResult& fit = *outcome.registration;
  HtmlTable table({"Figure", "Value", "Unit", "Meaning"});
  table.row({"RMS residual", fixed(fit.rmsMm, 3), "mm",
             "fit, not target error: all scan points to the pre-op surface, unweighted"});
  table.row({"Weighted RMS", fixed(fit.weightedRmsMm, 3), "mm",
             "fit, with the patch weights of the last iteration"});
  table.row({"Mean residual", fixed(fit.meanMm, 3), "mm", "fit, not target error"});
  table.row({"P95 residual", fixed(fit.p95Mm, 3), "mm", "95 % of scan points lie nearer"});
  for (const auto& [label, rms] : fit.patchRmsMm)
    table.row({"RMS, " + patchName(*outcome.preop, label), fixed(rms, 3), "mm",
               "scan patch to the same patch of the pre-op surface"});
  if (fit.expectedErrorMeanMm > 0)
    table.row({"Expected target error", fixed(fit.expectedErrorMeanMm, 1), "mm",
               "of the rigid pose, bending included: root mean square over the liver"});
  table.row({"Coverage", fixed(100 * fit.coverage, 1), "%",
             "of the pre-op surface's area within reach of the scan"});
  table.row({"Rotation", fixed(fit.rotationDeg, 2), "deg", "against " + outcome.start.reference});
  table.row({"Translation", fixed(fit.translationMm, 2), "mm",
             "of the scan's centroid, against " + outcome.start.reference});
  table.row({"Start", "", "", outcome.start.words});
  table.row({"Iterations", std::to_string(fit.iterations), "", fit.stopReason});
  table.row({"Converged", fit.converged ? "yes" : "no", "", ""});
  table.row({"Points", count(fit.scanPoints) + " / " + count(fit.preopPoints), "", "scan / pre-op"});
  table.row({"Time", fixed(fit.seconds, 2), "s", ""});
  return htmlSection("Registration", table.html() + "<h3>Transform: maps pre-op LPS mm to scan mm</h3>\n" +
                                         matrixTable(fit.scanFromPreop) + basinTable(fit));
}

std::string targetSection(const CaseOutcome& outcome) {
  if (!outcome.targetError) return "";
  const TargetError& error = *outcome.targetError;
  HtmlTable summary({"Target error (mm)", "Mean", "RMS", "Largest"}, 1);
  summary.row({"after registration", fixed(error.meanMm, 2), fixed(error.rmsMm, 2), fixed(error.maxMm, 2)});
  summary.row({"at the start", fixed(error.startMeanMm, 2), "", ""});
  summary.row({"rigid motion fitted to the targets themselves", fixed(error.optimalRigidMeanMm, 2), "", ""});
  // Three targets a row: a list of dozens should not push the rest off the page.
  HtmlTable each({"Target", "Error (mm)", "Target", "Error (mm)", "Target", "Error (mm)"});
  for (std::size_t i = 0; i < error.names.size(); i += 3) {
    std::vector<std::string> cells;
    for (std::size_t k = i; k < i + 3; ++k) {
      const bool there = k < error.names.size();
      cells.push_back(there ? error.names[k] : "");
      cells.push_back(there ? fixed(error.errorsMm[static_cast<Index>(k)], 2) : "");
    }
    each.row(cells);
  }
  return htmlSection("Target error of the registration",
                     htmlParagraph("Points inside the liver whose true place is known. What "
                                   "no rigid motion can reach is deformation.") +
                         summary.html() + each.html());
}

std::string distanceSection(const CaseOutcome& outcome) {
  const DistanceMap& map = *outcome.distance;
  std::string html = htmlSection(
      "Signed distance (mm)",
      htmlParagraph("Positive where the scan lies outside the pre-op surface; only where the scan reaches: " +
                    fixed(100 * map.coverage, 1) +
                    " % of the pre-op surface. Pre-op: from each of its vertices " +
                    "to the scan; scan: from each of its points to the pre-op surface.") +
          regionTable(map, &RegionFigures::distance, 2));
  if (map.preopRegions.front().curvatureDifference.count > 0)
    html += htmlSection(
        "Mean curvature difference (1/mm)",
        htmlParagraph("The scan's less the pre-op surface's: positive where the liver is now more "
                      "convex. No value near the scan's border.") +
            regionTable(map, &RegionFigures::curvatureDifference, 4));
  return html;
}

std::string settingsSection(const CaseSettings& settings) {
  HtmlTable table({"Step", "Setting", "Value", "Unit", "Meaning"});
  settingRows(table, "Import", settings.import);
  settingRows(table, "Patch transfer", settings.patches);
  settingRows(table, "Registration", settings.registration);
  settingRows(table, "Distance map", settings.distance);
  if (settings.withUpdate) {
    settingRows(table, "Mesh", settings.mesh);
    settingRows(table, "Model update", settings.update);
  }
  return htmlSection("Settings",
                     htmlParagraph("Registration preset: " + settings.preset + ".") + table.html());
}

std::string provenanceSection(const Provenance& provenance) {
  HtmlTable facts({"What", "Value"});
  facts.row({"Command", provenance.command});
  facts.row({"Started", provenance.startedUtc});
  facts.row({"Seed", std::to_string(provenance.seed)});
  facts.row({"Threads", std::to_string(provenance.threads) + " (results do not depend on it)"});
  HtmlTable inputs({"Input file", "SHA-256"});
  for (const auto& [file, digest] : provenance.inputSha256) inputs.row({file, digest});
  return htmlSection("Provenance", facts.html() + (inputs.empty() ? "" : inputs.html()));
}

}  // namespace falciform::commandline
