#include "Logic/Acquisition/ScanThinning.h"

#include <gtest/gtest.h>

#include "Logic/Geometry/Measures.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

using namespace test;

std::vector<char> maskOf(const std::vector<int>& ids, Index size) {
  std::vector<char> mask(static_cast<std::size_t>(size));
  for (const int id : ids) mask[static_cast<std::size_t>(id)] = 1;
  return mask;
}

TEST(PoissonDisks, StandApartAndLeaveNoGap) {
  const Surface scan = sphere(40, 5);
  const Adjacency neighbours = scanNeighbours(scan);
  const std::vector<int> ids = poissonDisks(scan, neighbours, 5, 1);
  const std::vector<char> everywhere(static_cast<std::size_t>(scan.size()), 1);
  for (const double distance : distancesAlong(scan, neighbours, maskOf(ids, scan.size()), everywhere, 100))
    EXPECT_LT(distance, 5);  // mm
  for (std::size_t k = 0; k < ids.size(); k += 20) {
    std::vector<int> others = ids;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const auto distance = distancesAlong(scan, neighbours, maskOf(others, scan.size()), everywhere, 100);
    EXPECT_GE(distance[static_cast<std::size_t>(ids[k])], 5);
  }
}

TEST(ThinnedScans, KeepMeasuredPointsAndTheirDataAndStayOneSheet) {
  Surface scan = sphere(40, 5);
  scan.colours = Colours::Constant(scan.size(), 3, 9);
  scan.arrays["number"] = VectorXd::LinSpaced(scan.size(), 0, static_cast<double>(scan.size() - 1));
  const Adjacency neighbours = scanNeighbours(scan);
  const std::vector<int> ids = poissonDisks(scan, neighbours, 5, 1);
  const Surface thin = thinned(scan, neighbours, ids);
  ASSERT_EQ(thin.size(), static_cast<Index>(ids.size()));
  EXPECT_EQ(thin.points.row(7), scan.points.row(ids[7]));
  EXPECT_EQ(thin.arrays.at("number")[7], ids[7]);
  const TopologyReport topology = inspectTopology(thin);
  EXPECT_EQ(topology.components, 1);
  EXPECT_LE(topology.boundaryEdges + topology.nonManifoldEdges, 6);  // four regions may meet in a point
  // Chords of 5 to 8 mm under a ball of 40 mm cost some 1 % of its area.
  EXPECT_NEAR(area(thin) / area(scan), 0.99, 0.02);
  EXPECT_GT(signedVolume(thin), 0);
}

TEST(ThinnedScans, DoNotFillWhatIsCoarserAlready) {
  const Surface scan = grid(100, 10);
  const std::vector<int> ids = poissonDisks(scan, scanNeighbours(scan), 3, 1);
  EXPECT_EQ(static_cast<Index>(ids.size()), scan.size());
  EXPECT_EQ(thinned(scan, scanNeighbours(scan), ids).triangles, scan.triangles);
}

}  // namespace
}  // namespace falciform
