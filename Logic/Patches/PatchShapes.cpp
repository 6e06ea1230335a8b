#include "Logic/Patches/PatchShapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace falciform {

namespace {

constexpr double kLargestHole = 0.25;     // of the patch's area
constexpr double kLargestFill = 0.5;      // of the surface's
constexpr int kMostDiffusionSteps = 400;  // far more than 20 mm on a mesh of 2 mm edges
constexpr double kBandWidths = 3;         // beyond three standard deviations nothing changes

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Members that are joined to a point that is none, and the reverse: the two sides of the border.
struct Border {
  std::vector<int> inside, outside;
};
Border borderOf(const BrushSurface& surface, const std::vector<int>& labels, int label) {
  Border border;
  std::vector<char> outside(labels.size(), 0);
  std::vector<int> joined;
  for (int i = 0; at(i) < labels.size(); ++i) {
    if (labels[at(i)] != label) continue;
    bool any = false;
    surface.neighbours(i, joined);
    for (const int j : joined)
      if (labels[at(j)] != label) outside[at(j)] = 1, any = true;
    if (any) border.inside.push_back(i);
  }
  for (int i = 0; at(i) < labels.size(); ++i)
    if (outside[at(i)] != 0) border.outside.push_back(i);
  return border;
}

/// Connected parts of the points for which `member` holds.
template <class Member>
std::vector<std::vector<int>> piecesOf(const BrushSurface& surface, std::size_t points, Member member) {
  std::vector<std::vector<int>> pieces;
  std::vector<char> seen(points, 0);
  std::vector<int> joined;
  for (int first = 0; at(first) < points; ++first) {
    if (seen[at(first)] != 0 || !member(first)) continue;
    std::vector<int> piece{first};
    seen[at(first)] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      surface.neighbours(piece[next], joined);
      for (const int j : joined)
        if (seen[at(j)] == 0 && member(j)) {
          seen[at(j)] = 1;
          piece.push_back(j);
        }
    }
    std::sort(piece.begin(), piece.end());
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

double sizeOf(const BrushSurface& surface, const std::vector<int>& ids) {
  double sum = 0;
  for (const int id : ids) sum += surface.weights()[id];
  return sum;
}

/// Mean of the squared distances from the points `ids` to those joined to them, mm^2.
double squaredStep(const BrushSurface& surface, const std::vector<int>& ids) {
  double sum = 0;
  std::size_t count = 0;
  std::vector<int> joined;
  for (const int i : ids) {
    surface.neighbours(i, joined);
    for (const int j : joined)
      sum += (surface.shape().points.row(i) - surface.shape().points.row(j)).squaredNorm();
    count += joined.size();
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace

PatchChange grownPatch(const BrushSurface& surface, const std::vector<int>& labels, int label, double mm) {
  PatchChange change;
  for (const int id : surface.around(borderOf(surface, labels, label).inside, mm))
    if (labels[at(id)] != label) change.gained.push_back(id);
  return change;
}

PatchChange shrunkPatch(const BrushSurface& surface, const std::vector<int>& labels, int label, double mm) {
  PatchChange change;
  for (const int id : surface.around(borderOf(surface, labels, label).outside, mm))
    if (labels[at(id)] == label) change.lost.push_back(id);
  return change;
}

PatchChange smoothedPatch(const BrushSurface& surface, const std::vector<int>& labels, int label, double mm) {
  PatchChange change;
  const Border border = borderOf(surface, labels, label);
  if (border.inside.empty() || !(mm > 0)) return change;
  std::vector<int> seeds = border.inside;
  seeds.insert(seeds.end(), border.outside.begin(), border.outside.end());
  const std::vector<int> band = surface.around(seeds, kBandWidths * mm);

  // Half of a point's share goes to those joined to it: a step of variance step^2 / 4 along either direction.
  const double step2 = squaredStep(surface, band);
  const int steps =
      step2 > 0 ? std::clamp(static_cast<int>(std::lround(4 * mm * mm / step2)), 1, kMostDiffusionSteps) : 1;
  VectorXd share(static_cast<Index>(labels.size()));
  for (int i = 0; at(i) < labels.size(); ++i) share[i] = labels[at(i)] == label ? 1 : 0;
  std::vector<std::vector<int>> joined(band.size());
  for (std::size_t k = 0; k < band.size(); ++k) surface.neighbours(band[k], joined[k]);
  VectorXd next = share;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t k = 0; k < band.size(); ++k) {
      double sum = 0;
      for (const int j : joined[k]) sum += share[j];
      const int i = band[k];
      if (!joined[k].empty()) next[i] = 0.5 * (share[i] + sum / static_cast<double>(joined[k].size()));
    }
    std::swap(share, next);
  }

  // The largest shares, as many as make the area that the patch had.
  std::vector<int> byShare = band;
  std::stable_sort(byShare.begin(), byShare.end(), [&](int a, int b) { return share[a] > share[b]; });
  double left = 0;
  for (const int i : band)
    if (labels[at(i)] == label) left += surface.weights()[i];
  for (const int i : byShare) {
    const bool member = left > 0.5 * surface.weights()[i];
    left -= surface.weights()[i];
    if (member == (labels[at(i)] == label)) continue;
    (member ? change.gained : change.lost).push_back(i);
  }
  std::sort(change.gained.begin(), change.gained.end());
  std::sort(change.lost.begin(), change.lost.end());
  return change;
}

PatchChange largestPieceOfPatch(const BrushSurface& surface, const std::vector<int>& labels, int label) {
  PatchChange change;
  const auto pieces = piecesOf(surface, labels.size(), [&](int i) { return labels[at(i)] == label; });
  const auto largest = std::max_element(pieces.begin(), pieces.end(), [&](const auto& a, const auto& b) {
    return sizeOf(surface, a) < sizeOf(surface, b);
  });
  for (auto piece = pieces.begin(); piece != pieces.end(); ++piece)
    if (piece != largest) change.lost.insert(change.lost.end(), piece->begin(), piece->end());
  std::sort(change.lost.begin(), change.lost.end());
  return change;
}

PatchChange filledHoles(const BrushSurface& surface, const std::vector<int>& labels, int label) {
  PatchChange change;
  double patch = 0;
  for (int i = 0; at(i) < labels.size(); ++i)
    if (labels[at(i)] == label) patch += surface.weights()[i];
  for (const auto& piece : piecesOf(surface, labels.size(), [&](int i) { return labels[at(i)] != label; })) {
    const bool open =
        std::any_of(piece.begin(), piece.end(), [&](int i) { return surface.onBorder()[at(i)] != 0; });
    if (!open && sizeOf(surface, piece) <= kLargestHole * patch)
      change.gained.insert(change.gained.end(), piece.begin(), piece.end());
  }
  std::sort(change.gained.begin(), change.gained.end());
  return change;
}

std::vector<int> regionAt(const BrushSurface& surface, const std::vector<int>& labels, int point) {
  if (point < 0 || at(point) >= labels.size()) return {};
  std::vector<char> seen(labels.size(), 0);
  std::vector<int> region{point}, joined;
  seen[at(point)] = 1;
  for (std::size_t next = 0; next < region.size(); ++next) {
    surface.neighbours(region[next], joined);
    for (const int j : joined)
      if (seen[at(j)] == 0 && labels[at(j)] == labels[at(point)]) {
        seen[at(j)] = 1;
        region.push_back(j);
      }
  }
  std::sort(region.begin(), region.end());
  return region;
}

std::string fillProblem(const BrushSurface& surface, const std::vector<int>& region) {
  if (sizeOf(surface, region) <= kLargestFill * surface.weights().sum()) return {};
  return "What was clicked is more than half of the surface: close the border around the part to be filled "
         "first.";
}

}  // namespace falciform
