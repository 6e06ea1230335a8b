#include "Logic/Patches/CrestLines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "Logic/Core/Errors.h"

namespace falciform {

namespace {

constexpr double kRunsOn = 0.7;  ///< cosine: how straight two ends must run on into each other

using Edge = std::pair<int, int>;  ///< lower vertex first

/// Curvature, its direction and its slope along that direction, at each vertex.
struct Extremality {
  VectorXd k, slope;
  Points direction;
};

Extremality extremalityOf(const Surface& surface, CrestKind kind, double scaleMm) {
  CurvatureSettings settings;
  settings.radiusMm = scaleMm;
  const Curvatures curvatures = principalCurvatures(surface, settings);
  Extremality e{crestCurvature(curvatures, kind), VectorXd::Zero(surface.size()),
                kind == CrestKind::Ridge ? curvatures.direction1 : curvatures.direction2};
  Points gradient = Points::Zero(surface.size(), 3);  // area-weighted, summed over triangles
  VectorXd area = VectorXd::Zero(surface.size());
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const Vector3i v = surface.triangles.row(t);
    const Vector3d a = surface.points.row(v[0]), b = surface.points.row(v[1]), c = surface.points.row(v[2]);
    const Vector3d normal = (b - a).cross(c - a);  // twice the area long
    const double twice = normal.norm();
    if (!(twice > 0)) continue;
    const Vector3d n = normal / twice;
    const Eigen::RowVector3d g =
        0.5 *
        (e.k[v[0]] * n.cross(c - b) + e.k[v[1]] * n.cross(a - c) + e.k[v[2]] * n.cross(b - a)).transpose();
    for (int i = 0; i < 3; ++i) {
      gradient.row(v[i]) += g;
      area[v[i]] += 0.5 * twice;
    }
  }
  for (Index i = 0; i < surface.size(); ++i)
    if (area[i] > 0 && e.k[i] > 0) e.slope[i] = gradient.row(i).dot(e.direction.row(i)) / area[i];
  return e;
}

/// A place on an edge where the curvature is largest across the crest.
struct Crossing {
  Vector3d place;
  double curvature = 0;
};

std::optional<Crossing> crossingOf(const Surface& surface, const Extremality& e, const Edge& edge,
                                   double low) {
  const auto [i, j] = edge;
  if (!(e.k[i] > 0 && e.k[j] > 0)) return std::nullopt;
  const Vector3d ti = e.direction.row(i);
  Vector3d tj = e.direction.row(j);
  double ej = e.slope[j];
  if (ti.dot(tj) < 0) tj = -tj, ej = -ej;
  const double ei = e.slope[i];
  if (!(ei * ej < 0)) return std::nullopt;
  const Vector3d along = surface.points.row(j) - surface.points.row(i);
  // Uphill from both ends towards the crossing: a largest, not a smallest, curvature.
  if (!(ei * along.dot(ti) > 0 && ej * along.dot(tj) < 0)) return std::nullopt;
  const double share = std::abs(ei) / (std::abs(ei) + std::abs(ej));
  const double k = (1 - share) * e.k[i] + share * e.k[j];
  if (k < low) return std::nullopt;
  return Crossing{surface.points.row(i).transpose() + share * along, k};
}

using Chain = std::vector<Crossing>;

/// Crossings joined through the triangles that have two of them.
std::vector<Chain> chainsOf(const Surface& surface, const Extremality& e, double low) {
  std::map<Edge, int> known;
  std::vector<Crossing> crossings;
  std::vector<std::vector<int>> joined;
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    std::vector<int> met;
    for (int c = 0; c < 3; ++c) {
      const Edge edge = std::minmax({surface.triangles(t, c), surface.triangles(t, (c + 1) % 3)});
      const auto [place, fresh] = known.try_emplace(edge, -1);
      if (fresh)
        if (const auto crossing = crossingOf(surface, e, edge, low)) {
          place->second = static_cast<int>(crossings.size());
          crossings.push_back(*crossing);
          joined.emplace_back();
        }
      if (place->second >= 0) met.push_back(place->second);
    }
    if (met.size() != 2) continue;
    joined[static_cast<std::size_t>(met[0])].push_back(met[1]);
    joined[static_cast<std::size_t>(met[1])].push_back(met[0]);
  }
  std::vector<char> used(crossings.size(), 0);
  std::vector<Chain> chains;
  const auto follow = [&](int start) {
    Chain chain;
    for (int at = start; at >= 0;) {
      used[static_cast<std::size_t>(at)] = 1;
      chain.push_back(crossings[static_cast<std::size_t>(at)]);
      int next = -1;
      for (const int n : joined[static_cast<std::size_t>(at)])
        if (!used[static_cast<std::size_t>(n)]) next = n;
      at = next;
    }
    chains.push_back(std::move(chain));
  };
  for (std::size_t c = 0; c < crossings.size(); ++c)  // open lines from their ends first, then loops
    if (joined[c].size() == 1 && !used[c]) follow(static_cast<int>(c));
  for (std::size_t c = 0; c < crossings.size(); ++c)
    if (joined[c].size() > 1 && !used[c]) follow(static_cast<int>(c));
  return chains;
}

/// Direction in which the chain leaves its last point.
Vector3d heading(const Chain& chain) {
  const std::size_t back = std::min<std::size_t>(chain.size() - 1, 4);
  return (chain.back().place - chain[chain.size() - 1 - back].place).normalized();
}

/// Joins `other` to the end of `chain` if they run on into each other; returns whether it did. Tries both
/// ways round.
bool joinEnds(Chain& chain, Chain& other, double gapMm) {
  for (int flips = 0; flips < 4; ++flips) {
    if (flips % 2 == 1) std::reverse(other.begin(), other.end());
    if (flips == 2) std::reverse(chain.begin(), chain.end());
    const Vector3d across = other.front().place - chain.back().place;
    if (across.norm() > gapMm || chain.size() < 2 || other.size() < 2) continue;
    const Vector3d out = heading(chain), step = across.norm() > 0 ? Vector3d(across.normalized()) : out;
    Chain reversed(other.rbegin(), other.rend());
    if (out.dot(step) < kRunsOn || -heading(reversed).dot(step) < kRunsOn) continue;
    chain.insert(chain.end(), other.begin(), other.end());
    return true;
  }
  return false;
}

void linkGaps(std::vector<Chain>& chains, double gapMm) {
  for (std::size_t a = 0; a < chains.size(); ++a)
    for (std::size_t b = a + 1; b < chains.size();) {
      if (joinEnds(chains[a], chains[b], gapMm)) {
        chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(b));
        b = a + 1;  // the longer line may reach others now
      } else {
        ++b;
      }
    }
}

CrestLine lineOf(const Chain& chain) {
  CrestLine line;
  line.points.resize(static_cast<Index>(chain.size()), 3);
  line.curvature.resize(static_cast<Index>(chain.size()));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    line.points.row(static_cast<Index>(i)) = chain[i].place;
    line.curvature[static_cast<Index>(i)] = chain[i].curvature;
    if (i == 0) continue;
    const double length = (chain[i].place - chain[i - 1].place).norm();
    line.lengthMm += length;
    line.strength += 0.5 * length * (chain[i].curvature + chain[i - 1].curvature);
  }
  return line;
}

}  // namespace

std::vector<CrestLine> crestLines(const Surface& surface, CrestKind kind, const CrestLineSettings& settings) {
  checkSettings(settings);
  if (surface.triangles.rows() == 0)
    throw InputError("crest lines run over triangles, and this is a cloud of points; mesh it first");
  const Extremality e = extremalityOf(surface, kind, settings.scaleMm);
  std::vector<Chain> chains = chainsOf(surface, e, settings.lowPerMm);
  std::erase_if(chains, [&](const Chain& chain) {
    return std::none_of(chain.begin(), chain.end(),
                        [&](const Crossing& c) { return c.curvature >= settings.highPerMm; });
  });
  linkGaps(chains, settings.gapMm);
  std::vector<CrestLine> lines;
  for (const Chain& chain : chains) {
    CrestLine line = lineOf(chain);
    if (line.lengthMm >= settings.leastLengthMm && line.strength >= settings.leastStrength)
      lines.push_back(std::move(line));
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const CrestLine& a, const CrestLine& b) { return a.strength > b.strength; });
  return lines;
}

}  // namespace falciform
