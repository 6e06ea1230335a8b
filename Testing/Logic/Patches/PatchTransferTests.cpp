#include "Logic/Patches/PatchTransfer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

Surface paintedGrid(int cells, double size) {
  Surface s = test::grid(size, cells);
  s.patch.assign(static_cast<std::size_t>(s.size()), 0);
  return s;
}

TEST(PatchTransfer, PaintsExactlyWhatLiesWithinTheRadius) {
  Surface from = paintedGrid(30, 30);
  for (Index i = 0; i < from.size(); ++i)
    if (from.points(i, 0) < 9.5) from.patch[static_cast<std::size_t>(i)] = 2;  // x = 0 .. 9
  const Surface to = test::grid(30, 60);                                       // points every 0.5 mm
  const std::vector<int> labels = transferPatches(from, to, 3.0);
  for (Index i = 0; i < to.size(); ++i) {
    const double x = to.points(i, 0), off = to.points(i, 1) - std::round(to.points(i, 1));
    const bool within =
        x <= 9 || (x - 9) * (x - 9) + off * off <= 9;  // 3 mm from the last painted column, both ends counted
    EXPECT_EQ(labels[static_cast<std::size_t>(i)], within ? 2 : 0) << to.points.row(i);
  }
}

TEST(PatchTransfer, GivesTheNearerLabelAndTiesToTheLowerIndex) {
  Surface from;
  from.points.resize(3, 3);
  from.points << -1, 0, 0, 1, 0, 0, 0, 0, 0;
  from.patch = {2, 1, 0};  // the unpainted point in between is no one's neighbour
  Surface to;
  to.points.resize(4, 3);
  to.points << 0, 0, 0, 0.1, 0, 0, -0.1, 0, 0, 0, 9, 0;
  EXPECT_EQ(transferPatches(from, to, 3.0), (std::vector<int>{2, 1, 2, 0}));
}

TEST(PatchTransfer, KeepsOldLabelsOnlyIfAsked) {
  Surface from;
  from.points = Points::Zero(1, 3);
  from.patch = {1};
  Surface to;
  to.points.resize(2, 3);
  to.points << 0, 0, 1, 0, 0, 50;
  to.patch = {4, 4};
  EXPECT_EQ(transferPatches(from, to, 3.0), (std::vector<int>{1, 0}));
  EXPECT_EQ(transferPatches(from, to, 3.0, true), (std::vector<int>{1, 4}));
  from.patch = {0};
  EXPECT_EQ(transferPatches(from, to, 3.0, true), (std::vector<int>{4, 4}));
}

TEST(PatchTransfer, OntoTheSameSurfaceChangesNoPaintedPointAndDoesNotDependOnThreads) {
  const Surface body = test::lumpyBody(4);
  ASSERT_FALSE(patchLabels(body).empty());
  setThreads(1);
  const std::vector<int> one = transferPatches(body, body);
  setThreads(4);
  EXPECT_EQ(transferPatches(body, body), one);
  setThreads(0);
  EXPECT_EQ(transferPatches(body, body, 0.0), body.patch);
  for (Index i = 0; i < body.size(); ++i)
    if (body.patchAt(i) != 0) {
      EXPECT_EQ(one[static_cast<std::size_t>(i)], body.patchAt(i));
    }
}

}  // namespace
}  // namespace falciform
