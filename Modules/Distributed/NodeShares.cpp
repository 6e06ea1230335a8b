#include "Modules/Distributed/NodeShares.h"

#include <algorithm>
#include <numeric>

#include "Logic/Core/Errors.h"

namespace falciform::distributed {
namespace {

/// Below that many nodes their order no longer counts for the processor's caches.
constexpr std::ptrdiff_t kLeaf = 32;

using Place = std::vector<int>::iterator;

void bisect(const Points& points, Place first, Place last, int ranks) {
  if (ranks <= 1 && last - first <= kLeaf) return;
  Eigen::RowVector3d low = points.row(*first), high = low;
  for (Place node = first; node != last; ++node) {
    low = low.cwiseMin(points.row(*node));
    high = high.cwiseMax(points.row(*node));
  }
  Index axis = 0;
  (high - low).maxCoeff(&axis);
  const int left = std::max(1, ranks / 2);
  const std::ptrdiff_t count = ranks > 1 ? (last - first) * left / ranks : (last - first) / 2;
  std::nth_element(first, first + count, last, [&](int a, int b) {
    return points(a, axis) != points(b, axis) ? points(a, axis) < points(b, axis) : a < b;
  });
  bisect(points, first, first + count, left);
  bisect(points, first + count, last, std::max(1, ranks - left));
}

/// The borders that `bisect` cuts at.
void cut(int first, int last, int ranks, std::vector<int>& begin) {
  if (ranks == 1) {
    begin.push_back(first);
    return;
  }
  const int left = ranks / 2;
  const auto middle = first + static_cast<int>(static_cast<std::ptrdiff_t>(last - first) * left / ranks);
  cut(first, middle, left, begin);
  cut(middle, last, ranks - left, begin);
}

}  // namespace

NodeShares shareNodes(const Points& points, int ranks) {
  const auto count = static_cast<int>(points.rows());
  if (count < ranks)
    throw InputError("the mesh has " + std::to_string(count) + " nodes for " + std::to_string(ranks) +
                     " ranks; start fewer");
  NodeShares shares;
  shares.nodes.resize(static_cast<std::size_t>(count));
  std::iota(shares.nodes.begin(), shares.nodes.end(), 0);
  bisect(points, shares.nodes.begin(), shares.nodes.end(), ranks);
  cut(0, count, ranks, shares.begin);
  shares.begin.push_back(count);
  shares.placeOf.resize(shares.nodes.size());
  for (int place = 0; place < count; ++place)
    shares.placeOf[static_cast<std::size_t>(shares.nodes[static_cast<std::size_t>(place)])] = place;
  return shares;
}

int OwnElements::at(int node) const {
  return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
}

OwnElements ownElements(const TetrahedralMesh& whole, const NodeShares& shares, int rank) {
  const int first = shares.begin[static_cast<std::size_t>(rank)],
            last = shares.begin[static_cast<std::size_t>(rank) + 1];
  const auto mine = [&](int node) {
    const int place = shares.placeOf[static_cast<std::size_t>(node)];
    return place >= first && place < last;
  };
  OwnElements own;
  std::vector<Index> elements;
  for (Index e = 0; e < whole.size(); ++e)
    for (Index k = 0; k < whole.elements.cols(); ++k)
      if (mine(whole.elements(e, k))) {
        elements.push_back(e);
        break;
      }
  for (const Index e : elements)
    for (Index k = 0; k < whole.elements.cols(); ++k) own.nodes.push_back(whole.elements(e, k));
  std::sort(own.nodes.begin(), own.nodes.end());
  own.nodes.erase(std::unique(own.nodes.begin(), own.nodes.end()), own.nodes.end());
  own.nodes.shrink_to_fit();
  TetrahedralMesh& mesh = own.mesh;
  mesh.frame = whole.frame;
  mesh.points.resize(static_cast<Index>(own.nodes.size()), 3);
  for (std::size_t n = 0; n < own.nodes.size(); ++n)
    mesh.points.row(static_cast<Index>(n)) = whole.points.row(own.nodes[n]);
  mesh.elements.resize(static_cast<Index>(elements.size()), whole.elements.cols());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (Index k = 0; k < whole.elements.cols(); ++k)
      mesh.elements(static_cast<Index>(e), k) = own.at(whole.elements(elements[e], k));
    if (!whole.regions.empty()) mesh.regions.push_back(whole.regionOf(elements[e]));
  }
  return own;
}

}  // namespace falciform::distributed
