#include "Logic/Acquisition/Parenchyma.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "Logic/Acquisition/LabColour.h"
#include "Logic/Acquisition/TissueModel.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/NumberText.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

constexpr double kSeedRadiusMm = 6;     // of the tissue around a click that tells its colour
constexpr double kFarthestSeedMm = 20;  // a click that misses the scan by more is not meant for it
constexpr int kSmoothings = 4;
constexpr std::size_t kChunk = 2048;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Grower {
 public:
  Grower(const Surface& scan, const Adjacency& neighbours, const std::vector<char>& allowed,
         const ParenchymaPlan& plan)
      : scan_(scan), neighbours_(neighbours), allowed_(allowed), plan_(plan) {
    byColour_ = scan.colours.rows() > 0 && plan.colourLimit > 0;
    if (scan.colours.rows() > 0) lab_ = smoothed(labOf(scan.colours), kSmoothings);
    normals_ = scan.triangles.rows() > 0 ? vertexNormals(scan) : scan.normals;
    // Noise of half a millimetre makes the normals of single triangles point anywhere: they are averaged
    // until they stand for about a third of the length over which a crease counts.
    const double spacing = usualSpacing(scan, neighbours);
    const double steps = spacing > 0 ? plan.creaseMm / 3 / spacing : 0;
    if (normals_.rows() > 0) {
      normals_ = smoothed(normals_, std::clamp(static_cast<int>(std::lround(steps * steps)), 2, 40));
      normals_.rowwise().normalize();
      findCreases(spacing);
    }
  }

  [[nodiscard]] bool byColour() const { return byColour_; }

  /// The points nearest to the clicks.
  [[nodiscard]] std::vector<int> seedsAt(const Points& clicks) const {
    const KdTree tree(scan_.points, idsOf(allowed_));
    std::vector<int> seeds;
    for (Index s = 0; s < clicks.rows(); ++s) {
      const Neighbour nearest = tree.nearest(clicks.row(s).transpose());
      if (nearest.index < 0 || nearest.squaredDistance > kFarthestSeedMm * kFarthestSeedMm)
        throw InputError("seed " + std::to_string(s + 1) + " lies " +
                         numberText(static_cast<float>(std::sqrt(nearest.squaredDistance))) +
                         " mm from the scan; give a place on it, in the scan's frame and mm");
      seeds.push_back(nearest.index);
    }
    return seeds;
  }

  /// The point deepest inside the largest part with liver's colours, or, without colours, inside the largest
  /// piece.
  [[nodiscard]] int findSeed() const {
    std::vector<char> like = allowed_;
    for (std::size_t i = 0; i < like.size() && byColour_; ++i)
      like[i] = like[i] && looksLikeLiver(lab_.row(static_cast<Index>(i)).transpose());
    const ScanPieces pieces = scanPieces(scan_, neighbours_, like);
    const int largest = pieces.largest();
    if (largest < 0)
      throw InputError("nothing in the scan is as red or brown as liver; give a place on it with --seed");
    std::vector<char> outside(like.size());
    for (std::size_t i = 0; i < like.size(); ++i) outside[i] = pieces.of[i] != largest;
    const std::vector<char> everywhere(like.size(), 1);
    std::vector<double> depth = distancesAlong(scan_, neighbours_, outside, everywhere, 1e6);
    // A scan that is liver all over has no outside: its middle is as good as any.
    if (std::find(outside.begin(), outside.end(), 1) == outside.end()) {
      const Vector3d middle = centroid(scan_.points);
      for (std::size_t i = 0; i < depth.size(); ++i)
        depth[i] = -(scan_.points.row(static_cast<Index>(i)).transpose() - middle).norm();
    }
    int deepest = -1;
    for (int i = 0; i < static_cast<int>(depth.size()); ++i)
      if (!outside[at(i)] && (deepest < 0 || depth[at(i)] > depth[at(deepest)])) deepest = i;
    return deepest;
  }

  /// All that is joined to the seeds by like colour and without a crease.
  [[nodiscard]] std::vector<char> grow(const std::vector<int>& seeds) const {
    std::vector<char> like(allowed_.size(), !byColour_);
    std::vector<char> seeded(allowed_.size());
    for (const int seed : seeds) seeded[at(seed)] = 1;
    for (std::size_t s = 0; byColour_ && s < seeds.size(); ++s) {
      const TissueModel first(lab_, around(seeds[s]));
      // Once more with all that the first colour reaches: a click tells little of a whole liver.
      const std::vector<char> reached = connected({seeds[s]}, likeness(first));
      const std::vector<int> ids = idsOf(reached);
      const std::vector<char> all = likeness(ids.empty() ? first : TissueModel(lab_, ids));
      for (std::size_t i = 0; i < like.size(); ++i) like[i] = like[i] || all[i] || seeded[i];
    }
    // The falciform ligament may part the liver from border to border.
    return connected(seeds, byColour_ && plan_.closeMm > 0 ? closed(like) : like);
  }

  /// Without what hangs on narrow bridges; with enclosed holes and narrow strips.
  [[nodiscard]] std::vector<char> mended(std::vector<char> region, const std::vector<int>& seeds) const {
    if (plan_.bridgeMm > 0) region = withoutBridges(region, seeds);
    if (plan_.closeMm > 0) region = closed(region);
    fillHoles(region);
    return pieceWith(region, seeds);
  }

 private:
  static std::vector<int> idsOf(const std::vector<char>& mask) {
    std::vector<int> ids;
    for (std::size_t i = 0; i < mask.size(); ++i)
      if (mask[i]) ids.push_back(static_cast<int>(i));
    return ids;
  }

  /// Each row the mean of its own and its allowed neighbours', so many times.
  [[nodiscard]] Points smoothed(Points values, int times) const {
    Points next = values;
    for (int k = 0; k < times; ++k) {
      forEachChunk(allowed_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i) {
          if (!allowed_[at(i)]) continue;
          Vector3d sum = values.row(i);
          int count = 1;
          for (const int* j = neighbours_.begin(i); j != neighbours_.end(i); ++j)
            if (allowed_[at(*j)]) {
              sum += values.row(*j).transpose();
              ++count;
            }
          next.row(i) = sum.transpose() / count;
        }
      });
      values.swap(next);
    }
    return values;
  }

  /// A valley: normals of neighbours lean towards each other, so much that over creaseMm they would turn by
  /// more than creaseDeg.
  void findCreases(double spacing) {
    crease_.assign(allowed_.size(), 0);
    if (plan_.creaseDeg >= 180 || !(spacing > 0)) return;
    const double most = plan_.creaseDeg * std::numbers::pi / 180 / plan_.creaseMm;  // 1/mm
    forEachChunk(allowed_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
      for (int i = static_cast<int>(begin); i < static_cast<int>(end); ++i) {
        if (!allowed_[at(i)]) continue;
        // Curvature along each edge, averaged: a single one is noise.
        double sum = 0;
        int count = 0;
        for (const int* j = neighbours_.begin(i); j != neighbours_.end(i); ++j) {
          if (!allowed_[at(*j)]) continue;
          const Vector3d step = (scan_.points.row(*j) - scan_.points.row(i)).transpose();
          const double length = std::max(step.norm(), 0.2 * spacing);
          sum += (normals_.row(*j) - normals_.row(i)).dot(step) / (length * length);
          ++count;
        }
        // Across a crease only half of the edges bend.
        crease_[at(i)] = count > 0 && sum / count < -0.5 * most;
      }
    });
  }

  [[nodiscard]] std::vector<int> around(int seed) const {
    std::vector<char> source(allowed_.size());
    source[at(seed)] = 1;
    const std::vector<double> distance =
        distancesAlong(scan_, neighbours_, source, allowed_, 2 * kSeedRadiusMm);
    std::vector<int> ids;
    for (int i = 0; i < static_cast<int>(distance.size()); ++i)
      if (distance[at(i)] <= kSeedRadiusMm) ids.push_back(i);
    return ids;
  }

  [[nodiscard]] std::vector<char> likeness(const TissueModel& model) const {
    std::vector<char> like(allowed_.size());
    for (std::size_t i = 0; i < like.size(); ++i)
      like[i] =
          allowed_[i] && model.distance(lab_.row(static_cast<Index>(i)).transpose()) <= plan_.colourLimit;
    return like;
  }

  /// Points on a crease are reached, and not gone on from.
  [[nodiscard]] std::vector<char> connected(const std::vector<int>& seeds,
                                            const std::vector<char>& like) const {
    std::vector<char> in(allowed_.size());
    std::vector<int> stack;
    for (const int seed : seeds) {
      in[at(seed)] = 1;
      stack.push_back(seed);
    }
    while (!stack.empty()) {
      const int i = stack.back();
      stack.pop_back();
      for (const int* j = neighbours_.begin(i); j != neighbours_.end(i); ++j)
        if (allowed_[at(*j)] && like[at(*j)] && !in[at(*j)]) {
          in[at(*j)] = 1;
          if (crease_.empty() || !crease_[at(*j)]) stack.push_back(*j);
        }
    }
    return in;
  }

  [[nodiscard]] std::vector<char> not_(const std::vector<char>& mask) const {
    std::vector<char> result(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i) result[i] = allowed_[i] && !mask[i];
    return result;
  }

  /// Points farther than `mm` from all with `from`.
  [[nodiscard]] std::vector<char> beyond(const std::vector<char>& from, double mm) const {
    const std::vector<double> distance = distancesAlong(scan_, neighbours_, from, allowed_, 2 * mm);
    std::vector<char> far(from.size());
    for (std::size_t i = 0; i < far.size(); ++i) far[i] = allowed_[i] && distance[i] > mm;
    return far;
  }

  /// The piece that holds most seeds' surroundings, else the largest.
  [[nodiscard]] std::vector<char> pieceWith(const std::vector<char>& region,
                                            const std::vector<int>& seeds) const {
    const ScanPieces pieces = scanPieces(scan_, neighbours_, region);
    std::vector<char> wanted(pieces.areaMm2.size());
    bool any = false;
    for (const int seed : seeds)
      if (pieces.of[at(seed)] >= 0) {
        wanted[at(pieces.of[at(seed)])] = 1;
        any = true;
      }
    if (!any && pieces.largest() >= 0) wanted[at(pieces.largest())] = 1;
    std::vector<char> kept(region.size());
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = pieces.of[i] >= 0 && wanted[at(pieces.of[i])];
    return kept;
  }

  [[nodiscard]] std::vector<char> withoutBridges(const std::vector<char>& region,
                                                 const std::vector<int>& seeds) const {
    const double half = plan_.bridgeMm / 2;
    std::vector<char> core = beyond(not_(region), half);
    for (std::size_t i = 0; i < core.size(); ++i) core[i] = core[i] && region[i];
    core = pieceWith(core, seeds);
    if (std::find(core.begin(), core.end(), 1) == core.end()) return region;
    std::vector<char> grown = beyond(core, 1.5 * half);
    for (std::size_t i = 0; i < grown.size(); ++i) grown[i] = region[i] && !grown[i];
    return grown;
  }

  [[nodiscard]] std::vector<char> closed(const std::vector<char>& region) const {
    const double half = plan_.closeMm / 2;
    std::vector<char> result = beyond(beyond(region, half), half);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[i] || region[i];
    return result;
  }

  void fillHoles(std::vector<char>& region) const {
    const VectorXd areas = vertexAreas(scan_);
    double whole = 0;
    for (const int i : idsOf(region)) whole += areas[i];
    const ScanPieces holes = scanPieces(scan_, neighbours_, not_(region));
    // A part that reaches the border of the scan is no hole.
    const std::vector<char> border = borderOf();
    std::vector<char> open(holes.areaMm2.size());
    for (std::size_t i = 0; i < border.size(); ++i)
      if (border[i] && holes.of[i] >= 0) open[at(holes.of[i])] = 1;
    for (std::size_t i = 0; i < region.size(); ++i) {
      const int hole = holes.of[i];
      if (hole >= 0 && !open[at(hole)] && holes.areaMm2[at(hole)] <= plan_.largestHoleShare * whole)
        region[i] = 1;
    }
  }

  /// Points beside ones that are not allowed, or on an edge of one triangle.
  [[nodiscard]] std::vector<char> borderOf() const {
    std::vector<char> border(allowed_.size());
    const Adjacency around = trianglesOfVertices(scan_.triangles, scan_.size());
    for (int i = 0; i < static_cast<int>(border.size()); ++i) {
      if (scan_.triangles.rows() > 0)
        border[at(i)] = around.count(i) != neighbours_.count(i);  // an open fan has one more spoke
      for (const int* j = neighbours_.begin(i); j != neighbours_.end(i); ++j)
        if (!allowed_[at(*j)]) border[at(i)] = 1;
    }
    return border;
  }

  const Surface& scan_;
  const Adjacency& neighbours_;
  const std::vector<char>& allowed_;
  const ParenchymaPlan& plan_;
  bool byColour_ = false;
  Points lab_, normals_;
  std::vector<char> crease_;
};

}  // namespace

Parenchyma findParenchyma(const Surface& scan, const Adjacency& neighbours, const std::vector<char>& allowed,
                          const Points& seeds, const ParenchymaPlan& plan, const Progress& progress) {
  progress.report(0, "Looking for the liver");
  const Grower grower(scan, neighbours, allowed, plan);
  Parenchyma found;
  found.byColour = grower.byColour();
  found.automatic = seeds.rows() == 0;
  found.seeds = found.automatic ? std::vector<int>{grower.findSeed()} : grower.seedsAt(seeds);
  progress.report(0.3, "Growing over the liver");
  found.in = grower.mended(grower.grow(found.seeds), found.seeds);
  const VectorXd areas = vertexAreas(scan);
  double all = 0;
  for (Index i = 0; i < scan.size(); ++i)
    if (allowed[static_cast<std::size_t>(i)]) {
      all += areas[i];
      if (found.in[static_cast<std::size_t>(i)]) found.areaMm2 += areas[i];
    }
  if (found.areaMm2 > 0.98 * all)
    found.warnings.push_back(
        "nearly all of the scan is taken for liver; lower the colour limit if it is not");
  if (found.areaMm2 < 0.05 * all)
    found.warnings.push_back(
        "hardly anything is taken for liver; set a seed on it, or raise the colour limit");
  if (!found.byColour && plan.colourLimit > 0)
    found.warnings.push_back(
        "the scan has no colours: the liver is told from its surroundings by folds alone");
  progress.report(1);
  return found;
}

}  // namespace falciform
