#include "Logic/Segmentation/LevelSetChecks.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/PlaceText.h"
#include "Logic/Segmentation/GridFilters.h"
#include "Logic/Segmentation/RegionPieces.h"
#include "Logic/Segmentation/VolumePyramid.h"

namespace falciform {

namespace {

constexpr double kSameSpreads = 2;     ///< two sides closer than this are equally bright
constexpr double kWeakShare = 0.35;    ///< above it the border is guessed rather than seen
constexpr std::size_t kMostNamed = 3;  ///< places named one by one

std::string placesText(const std::vector<LeftOut>& parts) {
  std::string text;
  for (std::size_t i = 0; i < std::min(parts.size(), kMostNamed); ++i)
    text += (i > 0 ? "; " : "") + roundedText(parts[i].volumeMl, 0) + " ml at " + placeText(parts[i].place) +
            " behind " + roundedText(parts[i].neckMm, 1) + " mm";
  if (parts.size() > kMostNamed) text += "; and " + std::to_string(parts.size() - kMostNamed) + " more";
  return text;
}

std::string enclosedText(const std::vector<EnclosedPart>& parts) {
  std::string text;
  for (std::size_t i = 0; i < std::min(parts.size(), kMostNamed); ++i)
    text += (i > 0 ? "; " : "") + roundedText(parts[i].volumeMl, 0) + " ml of " +
            roundedText(parts[i].levelHu, 0) + " HU at " + placeText(parts[i].place);
  if (parts.size() > kMostNamed) text += "; and " + std::to_string(parts.size() - kMostNamed) + " more";
  return text;
}

}  // namespace

std::vector<LeftOut> partsBehindNecks(const Volume<std::uint8_t>& organ, double neckMm, double wideness,
                                      double leastMl) {
  const Image depth = depthWithin(organ);
  Volume<std::uint8_t> middles = sameGrid<std::uint8_t>(organ, 0);
  for (std::size_t i = 0; i < middles.voxels.size(); ++i)
    middles.voxels[i] = organ.voxels[i] != 0 && static_cast<double>(depth.voxels[i]) >= neckMm;
  // Each part is the balls of the neck's radius about its middles.
  std::vector<LeftOut> parts;
  for (const RegionPiece& piece : piecesOf(middles)) {
    float deepest = 0;
    for (const std::size_t voxel : piece.voxels) deepest = std::max(deepest, depth.voxels[voxel]);
    if (static_cast<double>(deepest) < wideness * neckMm) continue;
    Volume<std::uint8_t> flags = sameGrid<std::uint8_t>(organ, 0);
    for (const std::size_t voxel : piece.voxels) flags.voxels[voxel] = 1;
    const Image away = distanceTo(flags);
    std::size_t count = 0;
    for (const float value : away.voxels) count += static_cast<double>(value) < neckMm;
    const double ml = static_cast<double>(count) * organ.voxelVolume() / 1000;
    if (ml >= leastMl) parts.push_back({neckMm, ml, organ.world(piece.middle)});
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const LeftOut& a, const LeftOut& b) { return a.volumeMl > b.volumeMl; });
  if (!parts.empty()) parts.erase(parts.begin());
  return parts;
}

double weakBorderShare(const Image& image, const Image& phi, const Tissue& tissue, double reachMm) {
  const Vector3d spacing = image.spacing();
  const double skin = spacing.minCoeff();
  std::size_t border = 0, weak = 0;
  for (int k = 1; k + 1 < phi.size.z(); ++k)
    for (int j = 1; j + 1 < phi.size.y(); ++j)
      for (int i = 1; i + 1 < phi.size.x(); ++i) {
        const double here = static_cast<double>(phi.at(i, j, k));
        if (here < 0 || here >= skin) continue;
        Vector3d slope((phi.at(i + 1, j, k) - phi.at(i - 1, j, k)) / 2.0,
                       (phi.at(i, j + 1, k) - phi.at(i, j - 1, k)) / 2.0,
                       (phi.at(i, j, k + 1) - phi.at(i, j, k - 1)) / 2.0);
        slope = slope.cwiseQuotient(spacing);
        if (slope.norm() < 0.1) continue;
        const Vector3d step = slope.normalized().cwiseQuotient(spacing), at(i, j, k);
        const double in = static_cast<double>(valueAt(image, at - (here + reachMm) * step)),
                     out = static_cast<double>(valueAt(image, at + (reachMm - here) * step));
        ++border;
        weak += std::abs(in - out) < kSameSpreads * tissue.spread;
      }
  return border == 0 ? 0 : static_cast<double>(weak) / static_cast<double>(border);
}

std::vector<std::string> sidesTouched(const LabelMap& organ, const StorageOrder& order) {
  static constexpr const char* kSides[3][2] = {{"right", "left"}, {"front", "back"}, {"bottom", "top"}};
  bool touched[3][2] = {};
  for (int a = 0; a < 3; ++a) {
    const int u = (a + 1) % 3, v = (a + 2) % 3;
    for (int end = 0; end < 2; ++end)
      for (int q = 0; q < order.size[v] && !touched[a][end]; ++q)
        for (int p = 0; p < order.size[u]; ++p) {
          Vector3i at;
          at[a] = end == 0 ? 0 : order.size[a] - 1;
          at[u] = p;
          at[v] = q;
          touched[a][end] |= organ.voxels[order.offset(at.x(), at.y(), at.z())] > 0;
        }
  }
  std::vector<std::string> sides;
  for (int a = 0; a < 3; ++a)
    for (int end = 0; end < 2; ++end)
      if (touched[a][end]) sides.emplace_back(kSides[a][end]);
  return sides;
}

void warnOfLeaks(LevelSetResult& result, const LevelSetSettings& settings,
                 const std::vector<LeftOut>& behindNecks, const std::vector<std::string>& sides) {
  auto& warnings = result.warnings;
  if (!sides.empty()) {
    std::string list;
    for (std::size_t i = 0; i < sides.size(); ++i) list += (i > 0 ? ", " : "") + sides[i];
    warnings.push_back("the organ touches the volume's border (" + list +
                       "): it is cut off there, or the front has left it");
  }
  if (settings.leastVolumeMl > 0 && result.volumeMl < settings.leastVolumeMl)
    warnings.push_back("only " + roundedText(result.volumeMl, 0) + " ml, less than the " +
                       roundedText(settings.leastVolumeMl, 0) +
                       " ml expected: the front may have stopped short; add seeds where it should go on");
  if (settings.mostVolumeMl > 0 && result.volumeMl > settings.mostVolumeMl)
    warnings.push_back(roundedText(result.volumeMl, 0) + " ml, more than the " +
                       roundedText(settings.mostVolumeMl, 0) +
                       " ml expected: the front has probably leaked; look where, and forbid it");
  if (!result.enclosed.empty())
    warnings.push_back("darker tissue that the organ encloses for the most part was taken in: " +
                       enclosedText(result.enclosed) +
                       "; look at it, and forbid it if it is not the organ's");
  if (!behindNecks.empty())
    warnings.push_back(
        "possible leak through a narrow bridge: parts hang on by a neck thinner than their own "
        "width: " +
        placesText(behindNecks));
  if (!result.leftOut.empty())
    warnings.push_back("the front stopped at narrow necks with tissue of the same brightness behind them: " +
                       placesText(result.leftOut) + "; add a seed there if that is the organ");
  if (result.weakBorderShare > kWeakShare)
    warnings.push_back(roundedText(100 * result.weakBorderShare, 0) +
                       " % of the border shows no edge in the image: check it against its neighbours");
}

}  // namespace falciform
