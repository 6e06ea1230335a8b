#include "Logic/Acquisition/ScanPreparation.h"

#include <algorithm>

#include "Logic/Acquisition/Parenchyma.h"
#include "Logic/Acquisition/ScanCleaning.h"
#include "Logic/Acquisition/ScanFacing.h"
#include "Logic/Acquisition/ScanThinning.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/NumberText.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/ScannerSide.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {

namespace {

constexpr int kSmoothingIterations = 20;
constexpr double kSmoothingPassBand = 0.1;  // keeps what is wider than about ten samples
constexpr int kThinningSeed = 1;

std::string unitName(LengthUnit unit) { return enumToString(unit); }

/// In mm, with what there is to say about that.
void scaleToMm(const ScanPreparationSettings& settings, MarkedScan& marked) {
  marked.unit = guessUnit(marked.scan.points);
  const std::string size =
      "the scan is " + numberText(static_cast<float>(marked.unit.extent)) + " units long: ";
  if (settings.unit != LengthUnit::Automatic) {
    marked.factor = millimetresIn(settings.unit);
  } else if (marked.unit.unit != LengthUnit::Millimetres && marked.unit.certain) {
    marked.factor = millimetresIn(marked.unit.unit);
    marked.warnings.push_back(size + "it is taken for " + unitName(marked.unit.unit) +
                              " and scaled to mm; give the unit as mm if that is wrong");
  } else if (marked.unit.unit != LengthUnit::Millimetres) {
    marked.warnings.push_back(size + "it may be in " + unitName(marked.unit.unit) +
                              ", and is taken for mm; give the unit if that is wrong");
  }
  const double extent = marked.unit.extent * marked.factor;
  if (extent > 0 && (extent < 20 || extent > 3000))
    marked.warnings.push_back("the scan is " + numberText(static_cast<float>(extent)) +
                              " mm long, which no liver in its surroundings is; check its unit");
  marked.scan.points *= marked.factor;
}

void mark(MarkedScan& marked, const std::vector<char>& which, ScanMark as) {
  for (std::size_t i = 0; i < which.size(); ++i)
    if (which[i] && marked.marks[i] == ScanMark::Kept) marked.marks[i] = as;
}

std::vector<char> keptOf(const MarkedScan& marked) {
  std::vector<char> kept(marked.marks.size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = marked.marks[i] == ScanMark::Kept;
  return kept;
}

std::vector<int> idsOf(const std::vector<char>& mask) {
  std::vector<int> ids;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) ids.push_back(static_cast<int>(i));
  return ids;
}

/// Points in no triangle, of a surface that has triangles, are specks at the rim.
Surface withoutSpecks(const Surface& scan) {
  if (scan.triangles.rows() == 0) return scan;
  std::vector<char> used(static_cast<std::size_t>(scan.size()));
  for (const int v : scan.triangles.reshaped()) used[static_cast<std::size_t>(v)] = 1;
  return subset(scan, idsOf(used));
}

}  // namespace

Index MarkedScan::count(ScanMark mark) const {
  return static_cast<Index>(std::count(marks.begin(), marks.end(), mark));
}

MarkedScan markScan(const Surface& raw, const Points& seeds, const std::optional<Vector3d>& scannerAt,
                    const ScanPreparationSettings& settings, const Progress& progress) {
  checkSettings(settings);
  if (raw.size() < 3)
    throw InputError("the scan has " + std::to_string(raw.size()) + " points; at least 3 are needed");
  MarkedScan marked;
  marked.scan = raw;
  marked.marks.assign(static_cast<std::size_t>(raw.size()), ScanMark::Kept);
  scaleToMm(settings, marked);
  progress.report(0.02, "Which side faces the scanner");
  marked.towardsScanner =
      scannerAt ? Vector3d((*scannerAt - centroid(marked.scan.points)).normalized()) : seenFrom(marked.scan);
  faceTowards(marked.scan, marked.towardsScanner);

  const Adjacency neighbours = scanNeighbours(marked.scan);
  const FalseReturns found = findFalseReturns(marked.scan, neighbours, marked.towardsScanner,
                                              {.outlierSpread = settings.outlierSpread,
                                               .grazingDeg = settings.grazingDeg,
                                               .smallestPieceShare = settings.smallestPieceShare},
                                              progress.part(0.05, settings.extract ? 0.5 : 1.0));
  mark(marked, found.outlier, ScanMark::Outlier);
  mark(marked, found.grazing, ScanMark::Grazing);
  mark(marked, found.smallPiece, ScanMark::SmallPiece);
  if (!settings.extract) return marked;

  const std::vector<char> allowed = keptOf(marked);
  Parenchyma liver = findParenchyma(marked.scan, neighbours, allowed, seeds,
                                    {.colourLimit = settings.colourLimit,
                                     .creaseDeg = settings.creaseDeg,
                                     .bridgeMm = settings.bridgeMm,
                                     .closeMm = settings.closeMm},
                                    progress.part(0.5, 1));
  for (char& in : liver.in) in = !in;
  mark(marked, liver.in, ScanMark::OtherTissue);
  marked.seeds = std::move(liver.seeds);
  marked.automatic = liver.automatic;
  marked.byColour = liver.byColour;
  marked.warnings.insert(marked.warnings.end(), liver.warnings.begin(), liver.warnings.end());
  return marked;
}

Surface finishScan(const MarkedScan& marked, const ScanPreparationSettings& settings,
                   const Progress& progress) {
  progress.report(0, "Taking out what goes");
  Surface kept = withoutSpecks(subset(marked.scan, idsOf(keptOf(marked))));
  if (kept.size() < 3)
    throw InputError("of the scan's " + std::to_string(marked.scan.size()) + " points " +
                     std::to_string(kept.size()) +
                     " are left; loosen the limits, or set a seed on the liver");
  if (settings.smooth) {
    progress.report(0.2, "Smoothing");
    kept = smoothWindowedSinc(kept, kSmoothingIterations, kSmoothingPassBand);
  }
  if (settings.spacingMm > 0) {
    progress.report(0.5, "Thinning");
    const Adjacency neighbours = scanNeighbours(kept);
    kept = withoutSpecks(
        thinned(kept, neighbours, poissonDisks(kept, neighbours, settings.spacingMm, kThinningSeed)));
  }
  progress.report(0.9, "Normals");
  // Those of a raster are planes over seven by seven samples: better than of single triangles.
  if (kept.normals.rows() == 0) giveNormals(kept, marked.towardsScanner);
  progress.report(1);
  return kept;
}

}  // namespace falciform
