#include "Modules/CommandLine/AtlasFigures.h"

#include <algorithm>
#include <cstdio>

#include "Modules/CommandLine/Figures.h"

namespace falciform::commandline {

namespace {

/// Over all members.
struct Extremes {
  double maxMm = 0, rmsMm = 0, errorMm = 0, minDetJ = 1, foldedShare = 0;
  std::size_t worst = 0;
  int folded = 0;
};

Extremes extremesOf(const Atlas& atlas) {
  Extremes result;
  for (std::size_t m = 0; m < atlas.figures.size(); ++m) {
    const MemberFigures& f = atlas.figures[m];
    result.maxMm = std::max(result.maxMm, f.maxMm);
    result.rmsMm = std::max(result.rmsMm, f.rmsMm);
    result.errorMm = std::max(result.errorMm, f.errorMm);
    if (f.minDetJ <= 0) ++result.folded;
    result.foldedShare = std::max(result.foldedShare, f.foldedShare);
    if (f.minDetJ >= result.minDetJ) continue;
    result.minDetJ = f.minDetJ;
    result.worst = m;
  }
  return result;
}

std::string counted(std::size_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

int tumoursOf(const Atlas& atlas) {
  int highest = 0;
  for (const int region : atlas.mesh.regions) highest = std::max(highest, region);
  return highest;
}

std::string tissueText(const TissueSettings& tissue) {
  return numberText(tissue.youngsModulusKPa) + " kPa, Poisson's ratio " + numberText(tissue.poissonsRatio) +
         ", " + numberText(tissue.densityKgPerM3) + " kg/m3";
}

std::string meshText(const TetrahedralMesh& mesh) {
  return std::string(mesh.quadratic() ? "quadratic" : "linear") + " mesh of " + std::to_string(mesh.size()) +
         " elements and " + std::to_string(3 * mesh.nodes()) + " degrees of freedom in frame " + mesh.frame;
}

std::string vectorText(const Vector3d& v, int decimals) {
  return fixed(v[0], decimals) + " " + fixed(v[1], decimals) + " " + fixed(v[2], decimals);
}

}  // namespace

nlohmann::json atlasFigures(const Atlas& atlas) {
  const Extremes extremes = extremesOf(atlas);
  return {{"kind", enumToString(atlas.design.kind)},
          {"members", atlas.members.size()},
          {"setups", atlas.setups.size()},
          {"independent_solves", atlas.solves},
          {"rank", atlas.rank()},
          {"energy", atlas.energy},
          {"nodes", atlas.mesh.nodes()},
          {"elements", atlas.mesh.size()},
          {"degrees_of_freedom", 3 * atlas.mesh.nodes()},
          {"max_displacement_mm", extremes.maxMm},
          {"max_rms_displacement_mm", extremes.rmsMm},
          {"max_compression_error_mm", extremes.errorMm},
          {"min_det_j", extremes.minDetJ},
          {"folding_members", extremes.folded},
          {"max_folded_share", extremes.foldedShare}};
}

std::vector<std::string> atlasLines(const Atlas& atlas) {
  const Extremes extremes = extremesOf(atlas);
  std::vector<std::string> lines;
  lines.push_back("kind " + enumToString(atlas.design.kind) + ": " +
                  counted(atlas.members.size(), "member", "members") + " of " +
                  counted(atlas.setups.size(), "setup", "setups") + ", from " +
                  counted(static_cast<std::size_t>(atlas.solves), "independent solve", "independent solves"));
  lines.push_back("rank " + std::to_string(atlas.rank()) + " holds " + fixed(atlas.energy, 7) +
                  " of the mean squared displacement (" + numberText(atlas.design.energy) + " asked for); " +
                  fixed(extremes.errorMm, 3) + " mm RMS are left of a member at most");
  lines.push_back("displacements up to " + fixed(extremes.maxMm, 1) + " mm, " + fixed(extremes.rmsMm, 1) +
                  " mm RMS; smallest local volume ratio (det J) " + fixed(extremes.minDetJ, 3) +
                  " in member " + std::to_string(extremes.worst));
  lines.push_back(meshText(atlas.mesh));
  lines.push_back("liver: " + tissueText(atlas.design.liver));
  if (const int tumours = tumoursOf(atlas); tumours > 0)
    lines.push_back(counted(static_cast<std::size_t>(tumours), "tumour: ", "tumours: ") +
                    tissueText(atlas.design.tumour) +
                    (atlas.design.kind == AtlasKind::Sampled
                         ? "; its stiffness by the setups' ratio to the liver's"
                         : ""));
  return lines;
}

nlohmann::json loadFigures(const LoadAtlas& atlas) {
  const TetrahedralMesh& mesh = atlas.loads.mesh;
  return {{"kind", enumToString(atlas.design.kind)},
          {"loads", atlas.loads.loads()},
          {"independent_solves", atlas.loads.loads()},
          {"nodes", mesh.nodes()},
          {"elements", mesh.size()},
          {"degrees_of_freedom", 3 * mesh.nodes()}};
}

std::vector<std::string> loadLines(const LoadAtlas& atlas) {
  return {"kind " + enumToString(atlas.design.kind) + ": " + std::to_string(atlas.loads.loads()) +
              " loads at " + std::to_string(atlas.loads.centres.rows()) + " places of radius " +
              numberText(atlas.design.surfaceLoads.radiusMm) + " mm; falciform update fits them",
          meshText(atlas.loads.mesh), "liver: " + tissueText(atlas.design.liver)};
}

std::vector<std::string> atlasWarnings(const Atlas& atlas) {
  std::vector<std::string> warnings;
  const Extremes extremes = extremesOf(atlas);
  if (extremes.folded > 0)
    warnings.push_back(std::to_string(extremes.folded) + " of " + std::to_string(atlas.members.size()) +
                       " members turn tissue inside out somewhere (up to " +
                       fixed(100 * extremes.foldedShare, 2) + " % of the volume, det J down to " +
                       fixed(extremes.minDetJ, 2) +
                       "): their loads are beyond small strains; see Docs/Atlas.md");
  if (atlas.design.kind == AtlasKind::Sampled && atlas.design.sampled.stiffnessLevels > 1 &&
      tumoursOf(atlas) == 0)
    warnings.emplace_back(
        "the design varies the stiffness of tumours but the mesh has none; give --tumours, or one level");
  return warnings;
}

std::vector<std::string> setupLines(const Atlas& atlas) {
  std::vector<std::string> lines;
  for (std::size_t s = 0; s < atlas.setups.size(); ++s) {
    const AtlasSetup& setup = atlas.setups[s];
    std::string line = "setup " + std::to_string(s) + " '" + setup.name + "':";
    for (const Support& support : setup.supports)
      line += " " + support.name +
              (support.kind == SupportKind::Fixed     ? " fixed"
               : support.kind == SupportKind::Sliding ? " sliding"
                                                      : " pushed") +
              " (" + counted(support.faces.size(), "face", "faces") + "),";
    line.pop_back();
    if (setup.pushed >= 0)
      line += " at " + vectorText(setup.centreMm, 1) + " mm, radius " + fixed(setup.extentMm, 1) + " mm";
    if (setup.stiffnessRatio > 0 && tumoursOf(atlas) > 0)
      line += "; tumours " + fixed(setup.stiffnessRatio, 2) + " times as stiff";
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> memberLines(const Atlas& atlas) {
  std::vector<std::string> lines{
      "member  setup  push_mm  gravity_change_m_per_s2     rms_mm   max_mm  error_mm  min_det_j  "
      "folded_percent"};
  for (std::size_t m = 0; m < atlas.members.size(); ++m) {
    const AtlasMember& member = atlas.members[m];
    const MemberFigures& f = atlas.figures[m];
    const Vector3d& g = member.gravityChangeMPerS2;
    char line[160];
    std::snprintf(line, sizeof line,
                  "%6zu  %5d  %7.2f  %7.3f %7.3f %7.3f  %9.3f  %7.2f  %8.4f  %9.4f  %14.3f", m, member.setup,
                  member.pushMm, g[0], g[1], g[2], f.rmsMm, f.maxMm, f.errorMm, f.minDetJ,
                  100 * f.foldedShare);
    lines.emplace_back(line);
  }
  return lines;
}

std::vector<ResultField> atlasResultFields() {
  return {{"independent_solves", "Independent solves", ""},
          {"rank", "Modes kept", ""},
          {"energy", "Share of the mean squared displacement", ""},
          {"min_det_j", "Smallest local volume ratio", ""}};
}

}  // namespace falciform::commandline
