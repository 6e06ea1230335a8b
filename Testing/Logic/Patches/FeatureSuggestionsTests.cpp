#include "Logic/Patches/FeatureSuggestions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {
namespace {

const SyntheticLiver& liver() {
  static const SyntheticLiver made = [] {
    SyntheticLiverSettings settings;
    settings.edgeLengthMm = 4;
    return makeSyntheticLiver(settings);
  }();
  return made;
}
const FeatureSuggestions& suggested() {
  static const FeatureSuggestions made = suggestFeatures(liver().surface);
  return made;
}

/// Share of `points` within `mm` of the points of the liver's patch `label`.
double shareNear(const Points& points, int label, double mm) {
  const KdTree tree(liver().surface.points, pointsOfPatch(liver().surface, label));
  double near = 0;
  for (Index i = 0; i < points.rows(); ++i)
    near += tree.nearest(points.row(i)).squaredDistance <= mm * mm ? 1 : 0;
  return near / static_cast<double>(points.rows());
}
/// Share of the points of the patch within `mm` of the line.
double shareFound(const Points& line, int label, double mm) {
  const KdTree tree(line);
  const std::vector<int> patch = pointsOfPatch(liver().surface, label);
  double near = 0;
  for (const int v : patch)
    near += tree.nearest(liver().surface.points.row(v)).squaredDistance <= mm * mm ? 1 : 0;
  return near / static_cast<double>(patch.size());
}

// The synthetic liver is nobody's: what was learnt from marked livers has to hold on it too. Its marks run
// from the notch to the right end, and people's ridges go on to the left lobe, hence no more than 3 in 4.
TEST(FeatureSuggestions, FindTheSyntheticLiversRidge) {
  ASSERT_FALSE(suggested().ridge.empty());
  const FeatureSuggestion& ridge = suggested().ridge.front();
  EXPECT_EQ(ridge.label, patch::kInferiorRidge);
  EXPECT_GT(shareNear(ridge.line, patch::kInferiorRidge, 5), 0.7);
  EXPECT_GT(shareFound(ridge.line, patch::kInferiorRidge, 10), 0.75);
}

TEST(FeatureSuggestions, RunFromThePatientsRightToTheLeft) {
  const Points& line = suggested().ridge.front().line;
  EXPECT_LT(line(0, 0), line(line.rows() - 1, 0));  // LPS: left is +x
}

TEST(FeatureSuggestions, PaintVerticesWithinHalfTheWidthOfTheirLine) {
  for (const FeatureSuggestion& s : suggested().ridge) {
    const KdTree tree(s.line);
    for (const int v : s.vertices)
      EXPECT_LE(tree.nearest(liver().surface.points.row(v)).squaredDistance, 6.0 * 6.0);  // mm^2
    const std::vector<int> labels = paintedLabels(liver().surface, s);
    EXPECT_TRUE(std::all_of(s.vertices.begin(), s.vertices.end(),
                            [&](int v) { return labels[static_cast<std::size_t>(v)] == s.label; }));
  }
}

// Its lobes are unlike those that people marked, so that other places look as likely: its valley decides,
// fine mesh or coarse. Its marks go on over the dome, farther than people's: hence no more than 4 in 10.
TEST(FeatureSuggestions, PutTheSyntheticLiversGrooveFirst) {
  const FeatureSuggestion& first = suggested().groove.at(0);
  EXPECT_GT(shareNear(first.line, patch::kFalciform, 10), 0.8);
  EXPECT_GT(shareFound(first.line, patch::kFalciform, 10), 0.4);
  SyntheticLiverSettings settings;
  settings.edgeLengthMm = 2;
  const FeatureSuggestions fine = suggestFeatures(makeSyntheticLiver(settings).surface);
  EXPECT_GT(shareNear(fine.groove.at(0).line, patch::kFalciform, 10), 0.8);
  for (const FeatureSuggestion& s : suggested().groove) {
    EXPECT_EQ(s.label, patch::kFalciform);
    EXPECT_LT(s.line(0, 2), s.line(s.line.rows() - 1, 2));  // from foot to top
  }
}

TEST(FeatureSuggestions, ScoresLieBetween0And1) {
  for (const FeatureSuggestion& s : suggested().groove) {
    EXPECT_GE(s.score, 0);
    EXPECT_LE(s.score, 1);
  }
}

TEST(FeatureSuggestions, DoNotDependOnTheThreads) {
  setThreads(1);
  const FeatureSuggestions one = suggestFeatures(liver().surface);
  setThreads(3);
  const FeatureSuggestions three = suggestFeatures(liver().surface);
  setThreads(0);
  EXPECT_EQ(one.ridge.front().line, three.ridge.front().line);
  EXPECT_EQ(one.groove.front().vertices, three.groove.front().vertices);
}

TEST(FeatureSuggestions, FollowALiverThatIsTurnedIfItsAxesAre) {
  const Isometry3d turn(Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()));
  AnatomicalAxes axes = lpsAxes();
  axes.rows = axes.rows * turn.rotation().transpose();
  const FeatureSuggestions turned = suggestFeatures(transformed(liver().surface, turn, "scanner"), {}, axes);
  // Rounding may move a tie by a vertex, no more: 4 mm edges.
  const KdTree tree(transformed(suggested().ridge.front().line, turn));
  const Points& line = turned.ridge.front().line;
  for (Index i = 0; i < line.rows(); ++i) EXPECT_LT(tree.nearest(line.row(i)).squaredDistance, 16.0);
}

TEST(FeatureSuggestions, RefuseACloudAndACrumb) {
  Surface cloud = liver().surface;
  cloud.triangles.resize(0, 3);
  EXPECT_THROW((void)suggestFeatures(cloud), InputError);
  EXPECT_THROW((void)suggestFeatures(subset(liver().surface, {0, 1, 2, 3, 4, 5})), InputError);
}

TEST(VerticesAlong, LeaveOutAFoldBeyondAGap) {
  // Two sheets of 1 mm squares, 2 mm apart; the line runs on the lower one.
  Surface sheets;
  sheets.points.resize(2 * 21 * 5, 3);
  std::vector<Vector3i> faces;
  for (int s = 0; s < 2; ++s)
    for (int i = 0; i < 21; ++i)
      for (int j = 0; j < 5; ++j) {
        const int v = s * 105 + i * 5 + j;
        sheets.points.row(v) << i, j, 2 * s;
        if (i < 20 && j < 4) faces.insert(faces.end(), {{v, v + 5, v + 1}, {v + 1, v + 5, v + 6}});
      }
  sheets.triangles.resize(static_cast<Index>(faces.size()), 3);
  for (std::size_t f = 0; f < faces.size(); ++f)
    sheets.triangles.row(static_cast<Index>(f)) = faces[f].transpose();
  Points line(11, 3);
  for (int i = 0; i < 11; ++i) line.row(i) << 5 + i, 2, 0;
  const std::vector<int> found = verticesAlong(sheets, line, 3);
  ASSERT_FALSE(found.empty());
  EXPECT_LT(found.back(), 105);
  EXPECT_TRUE(std::binary_search(found.begin(), found.end(), 5 * 5 + 2));
  EXPECT_FALSE(std::binary_search(found.begin(), found.end(), 1 * 5 + 2));
}

}  // namespace
}  // namespace falciform
