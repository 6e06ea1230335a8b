#include <flann/flann.hpp>
#include <numeric>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/ClosestPointGrid.h"
#include "Logic/Geometry/KdTree.h"
#include "Testing/Benchmarks/Comparisons.h"
#include "Testing/Benchmarks/Peers.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Benchmarks/Table.h"

namespace falciform::bench {

namespace {

constexpr int kRuns = 15;
constexpr double kCellMm = 4, kMarginMm = 40;  // of the map in the search (CoarseAlignment.cpp)

using Search = std::function<void(const Points& queries, std::vector<int>& rows)>;

Search chunked(std::function<int(const Vector3d&)> nearest) {
  return [nearest = std::move(nearest)](const Points& queries, std::vector<int>& rows) {
    forEachChunk(rows.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        rows[i] = nearest(queries.row(static_cast<Index>(i)).transpose());
    });
  };
}

class Flann {
 public:
  explicit Flann(Points points)
      : points_(std::move(points)),
        tree_(flann::Matrix<double>(points_.data(), static_cast<std::size_t>(points_.rows()), 3),
              flann::KDTreeSingleIndexParams(10)) {
    tree_.buildIndex();
  }
  void nearest(const Points& queries, std::vector<int>& rows) const {
    std::vector<double> squared(rows.size());
    forEachChunk(rows.size(), 256, [&](std::size_t begin, std::size_t end) {
      // FLANN takes no pointer to const, and writes nothing through it.
      auto* first = const_cast<double*>(queries.data() + 3 * begin);
      flann::Matrix<int> ids(rows.data() + begin, end - begin, 1);
      flann::Matrix<double> distances(squared.data() + begin, end - begin, 1);
      tree_.knnSearch(flann::Matrix<double>(first, end - begin, 3), ids, distances, 1,
                      flann::SearchParams(-1));
    });
  }

 private:
  Points points_;
  flann::Index<flann::L2_Simple<double>> tree_;
};

Row timed(const std::string& who, const Search& search, const Points& points, const Points& queries,
          const std::vector<int>& exact) {
  Row row{who, {}, false};
  std::vector<int> rows(exact.size());
  for (int run = 0; run < kRuns; ++run) {
    const Spent spent = measured([&] { search(queries, rows); });
    row.tally.addTime(spent.wallMs, spent.cpuMs);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto query = queries.row(static_cast<Index>(i));
    row.tally.errorsMm.push_back((points.row(rows[i]) - query).norm() -
                                 (points.row(exact[i]) - query).norm());
  }
  return row;
}

}  // namespace

void compareNeighbours(const BenchCase& c) {
  const Points& points = c.preop.points;
  const KdTree tree(points);
  const Flann flann(points);
  const VtkNeighbours vtk(points);
  std::vector<int> all(static_cast<std::size_t>(points.rows()));
  std::iota(all.begin(), all.end(), 0);
  const ClosestPointGrid grid(points, all, kCellMm, kMarginMm);
  const std::vector<std::pair<std::string, Search>> searches{
      {"FLANN", [&](const Points& q, std::vector<int>& rows) { flann.nearest(q, rows); }},
      {"ours, exact tree", chunked([&](const Vector3d& q) { return tree.nearest(q).index; })},
      {"ours, map of closest points",
       chunked([&](const Vector3d& q) { return grid.closest(q.cast<float>()); })},
      {"vtkStaticPointLocator", [&](const Points& q, std::vector<int>& rows) { vtk.nearest(q, rows); }},
  };
  for (const double offMm : {0.0, 100.0})
    for (const int count : {1, 2}) {
      setThreads(count);
      Isometry3d pose = c.bestRigid.inverse();
      pose.pretranslate(Vector3d(offMm, 0, 0));
      const Points queries = transformed(c.scan.points, pose);
      std::vector<int> exact(static_cast<std::size_t>(queries.rows()));
      searches.front().second(queries, exact);  // exact but for ties
      Comparison table(c.name + ": neighbours, " + (offMm > 0 ? "100 mm off" : "at the answer") + ", " +
                       std::to_string(count) + (count > 1 ? " threads" : " thread"));
      for (const auto& [who, search] : searches) table.print(timed(who, search, points, queries, exact));
    }
  setThreads(0);
}

}  // namespace falciform::bench
