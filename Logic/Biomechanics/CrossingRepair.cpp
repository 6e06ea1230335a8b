#include "Logic/Biomechanics/CrossingRepair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "Logic/Geometry/GridField.h"
#include "Logic/Geometry/Remesh.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

namespace {

constexpr int kPolishes = 4;
constexpr int kRounds = 5;         ///< of finer edges
constexpr double kFinest = 0.125;  ///< of the edge length
constexpr double kSlope = 0.4;     ///< of the edge length's growth away from a fine spot

constexpr double kSmallestBallMm = 1, kSmallestCellMm = 1.5;

/// A place around which edges are finer.
struct FineSpot {
  Vector3d place;
  double radiusMm, edgeMm;
};

double edgeLengthAt(const Vector3d& x, const std::vector<FineSpot>& spots, double edgeLengthMm) {
  double edge = edgeLengthMm;
  for (const FineSpot& spot : spots) {
    const double reach = spot.radiusMm + (edge - spot.edgeMm) / kSlope, away = (x - spot.place).squaredNorm();
    if (spot.edgeMm >= edge || away >= reach * reach) continue;
    edge = spot.edgeMm + kSlope * std::max(0.0, std::sqrt(away) - spot.radiusMm);
  }
  return edge;
}

/// Halves the edge length around the places; false where it is at its finest already.
bool refine(const std::vector<Vector3d>& places, double edgeLengthMm, std::vector<FineSpot>& spots) {
  const std::vector<FineSpot> before = spots;
  bool finer = false;
  for (const Vector3d& place : places) {
    const double edge = edgeLengthAt(place, before, edgeLengthMm);
    if (edge <= kFinest * edgeLengthMm * 1.01) continue;
    finer = true;
    const FineSpot spot{place, edge, std::max(edge / 2, kFinest * edgeLengthMm)};
    const bool known = std::any_of(spots.begin(), spots.end(), [&](const FineSpot& other) {
      return other.edgeMm <= spot.edgeMm && (other.place - spot.place).norm() < spot.radiusMm / 4;
    });
    if (!known) spots.push_back(spot);
  }
  return finer;
}

std::vector<Vector3d> placesOf(const std::vector<Crossing>& crossings) {
  std::vector<Vector3d> places;
  for (const Crossing& crossing : crossings) places.push_back(crossing.place);
  return places;
}

struct Attempt {
  Surface surface;
  std::vector<Crossing> first, left;
  std::vector<FineSpot> spots;
  std::size_t poor = 0;
};

Surface remeshedAround(const Surface& source, double edgeLengthMm, const std::vector<FineSpot>& spots,
                       const Progress& progress) {
  if (spots.empty()) return remeshIsotropic(source, edgeLengthMm, 6, progress);
  const auto edge = [&](const Vector3d& x) { return edgeLengthAt(x, spots, edgeLengthMm); };
  return remeshIsotropic(source, edge, kFinest * edgeLengthMm, 6, progress);
}

/// `most`: crossings at first from which on finer edges are not tried.
Attempt remeshedFinely(const Surface& source, double edgeLengthMm, std::size_t most,
                       const Progress& progress) {
  Attempt attempt;
  for (int round = 0;; ++round) {
    const Progress step = progress.part(round / (kRounds + 1.0), (round + 1) / (kRounds + 1.0));
    attempt.surface = remeshedAround(source, edgeLengthMm, attempt.spots, step);
    attempt.left = selfCrossings(attempt.surface);
    if (round == 0) attempt.first = attempt.left;
    if (attempt.left.empty() || attempt.first.size() > most || round == kRounds ||
        !refine(placesOf(attempt.left), edgeLengthMm, attempt.spots))
      return attempt;
  }
}

/// Finer edges where the mesh would be poor; the best of a few rounds is kept.
void polish(const Surface& source, double edgeLengthMm, const PoorPlaces& poorPlaces, Attempt& best,
            const Progress& progress) {
  std::vector<Vector3d> poor = poorPlaces(best.surface);
  best.poor = poor.size();
  Attempt trial = best;
  for (int round = 0; round < kPolishes && best.poor > 0; ++round) {
    const Progress step = progress.part(round / double(kPolishes), (round + 1.0) / kPolishes);
    if (!refine(poor, edgeLengthMm, trial.spots)) return;
    trial.surface = remeshedAround(source, edgeLengthMm, trial.spots, step);
    trial.left = selfCrossings(trial.surface);
    poor = trial.left.empty() ? poorPlaces(trial.surface) : placesOf(trial.left);
    trial.poor = poor.size();
    if (trial.left.empty() && trial.poor < best.poor) best = trial;
  }
}

std::string words(const char* format, double a, double b) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, a, b);
  return text.data();
}

/// The rounded surface with even triangles instead of the lattice's, where that goes without crossings: later
/// rounds are quicker.
Surface evenlyRounded(const Surface& surface, double closeMm, double openMm, double cellMm) {
  const Surface rounded = roundedSurface(surface, closeMm, openMm, cellMm);
  Surface even = remeshIsotropic(rounded, 1.5 * cellMm, 3);
  return selfCrossings(even).empty() ? even : rounded;
}

}  // namespace

MeshableSurface meshableSurface(const Surface& surface, double edgeLengthMm, double maxRepairMm,
                                const PoorPlaces& poorPlaces, const Progress& progress) {
  // Radii of the balls that close clefts and cut threads, as shares of the edge length; none first.
  constexpr std::array<std::array<double, 2>, 6> kBalls{
      {{0, 0}, {0.1, 0.1}, {0.2, 0.1}, {0.3, 0.15}, {0.4, 0.25}, {0.5, 0.4}}};
  constexpr std::size_t kFew = 12;  // above, the surface is riddled with tunnels, as noise makes them
  // Voxel noise is of a millimetre, however short the edges are.
  const auto ball = [&](double share) {
    return share > 0 ? std::max(share * edgeLengthMm, kSmallestBallMm) : 0;
  };
  MeshableSurface result;
  const std::vector<Crossing> own = selfCrossings(surface);
  for (std::size_t i = 0; i < kBalls.size(); ++i) {
    const Progress step = progress.part(static_cast<double>(i) / kBalls.size(), (i + 1.0) / kBalls.size());
    const double close = ball(kBalls[i][0]), open = ball(kBalls[i][1]);
    const bool mayRound = ball(kBalls[1][0]) <= maxRepairMm;
    if (std::max(close, open) > maxRepairMm) break;
    if (i == 0 && !own.empty() && mayRound) {  // no remeshing mends what the surface itself does
      result.first = result.left = own;
      result.surface = surface;
      continue;
    }
    if (i > 0) step.report(0, "Closing narrow clefts");
    const Surface source =
        i == 0 ? surface : evenlyRounded(surface, close, open, std::max(edgeLengthMm / 5, kSmallestCellMm));
    Attempt attempt = remeshedFinely(source, edgeLengthMm, i == 0 && mayRound ? kFew : std::size_t(-1),
                                     step.part(0.4, 0.8));
    if (attempt.left.empty() && poorPlaces)
      polish(source, edgeLengthMm, poorPlaces, attempt, step.part(0.8, 1));
    if (i == 0) result.first = attempt.first;
    result.surface = std::move(attempt.surface);
    result.left = std::move(attempt.left);
    if (!result.left.empty()) continue;
    if (i > 0)
      result.repairs.push_back(words(
          "clefts narrower than %.2g mm closed and threads thinner than %.2g mm cut", 2 * close, 2 * open));
    double finest = edgeLengthMm;
    for (const FineSpot& spot : attempt.spots) finest = std::min(finest, spot.edgeMm);
    if (!attempt.spots.empty())
      result.repairs.push_back(words("edges made finer, down to %.2g mm, around narrow places (%.0f)", finest,
                                     static_cast<double>(attempt.spots.size())));
    break;
  }
  result.surface.frame = surface.frame;
  progress.report(1, "Surface ready");
  return result;
}

}  // namespace falciform
