#include "Logic/Acquisition/SyntheticLiver.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "Logic/Acquisition/LiverShape.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Logic/Acquisition/SyntheticLivers.h"

namespace falciform {
namespace {

using test::coarseLiver;
using test::defaultLiver;

/// Mean over the vertices with `label` of how far a vertex lies below (+, hollow) or above (-, ridge) the
/// mean of the surface's points between 5 and 8 mm away, along its normal, mm.
double meanHollow(const Surface& surface, const std::vector<int>& ids) {
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < ids.size(); n += 10) {
    const Vector3d p = surface.points.row(ids[n]).transpose(),
                   normal = surface.normals.row(ids[n]).transpose();
    Vector3d mean = Vector3d::Zero();
    int around = 0;
    for (Index i = 0; i < surface.size(); ++i) {
      const Vector3d q = surface.points.row(i).transpose();
      const double d = (q - p).norm();
      if (d > 5 && d < 8) mean += q, ++around;
    }
    if (around == 0) continue;
    sum += normal.dot(mean / around - p);
    ++count;
  }
  return sum / count;
}

std::vector<int> unpainted(const Surface& surface) { return pointsOfPatch(surface, patch::kNone); }

TEST(SyntheticLiver, IsOneClosedManifoldOfAboutSixtyThousandPoints) {
  const Surface& surface = defaultLiver().surface;
  const TopologyReport report = inspectTopology(surface);
  EXPECT_TRUE(report.closedManifold()) << describeTopology(report);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(report.eulerCharacteristic, 2);
  EXPECT_NEAR(static_cast<double>(surface.size()), 60000, 9000);  // as many as the real cases, within 15 %
  EXPECT_EQ(surface.frame, "LPS");
  EXPECT_EQ(surface.normals.rows(), surface.size());
}

TEST(SyntheticLiver, HasALiversVolumeAndTheStatedSize) {
  const Surface& surface = defaultLiver().surface;
  const double millilitres = signedVolume(surface) / 1000;
  EXPECT_GT(millilitres, 1300);  // adult livers
  EXPECT_LT(millilitres, 1900);
  const auto box = boundingBox(surface.points);
  const SyntheticLiverSettings settings;
  const Vector3d stated(settings.widthMm, settings.depthMm, settings.heightMm);
  for (int axis = 0; axis < 3;
       ++axis)  // the sizes steer the primitives, whose blends change them by some percent
    EXPECT_NEAR(box(1, axis) - box(0, axis), stated[axis], 0.05 * stated[axis]) << axis;
}

TEST(SyntheticLiver, FollowsTheStatedSizes) {
  SyntheticLiverSettings settings;
  settings.edgeLengthMm = 8;
  settings.widthMm = 252;  // each by a factor of 1.2 or 0.8
  settings.depthMm = 120;
  settings.heightMm = 192;
  settings.leftLobeShare = 0.45;
  const auto box = boundingBox(makeSyntheticLiver(settings).surface.points);
  EXPECT_NEAR(box(1, 0) - box(0, 0), 252, 13);
  EXPECT_NEAR(box(1, 1) - box(0, 1), 120, 8);
  EXPECT_NEAR(box(1, 2) - box(0, 2), 192, 12);
  EXPECT_NEAR(box(1, 0), 0.45 * 252, 8);  // the left lobe, from the falciform notch at x = 0
}

TEST(SyntheticLiver, LiesOnItsImplicitBody) {
  const LiverShape shape{SyntheticLiverSettings{}};
  const Surface& surface = defaultLiver().surface;
  double worst = 0;
  for (Index i = 0; i < surface.size(); ++i)
    worst = std::max(worst, std::abs(shape.distance(surface.points.row(i).transpose())));
  EXPECT_LT(worst, 0.05);  // mm; Newton steps end far below, except at the creases of the blends
}

TEST(SyntheticLiver, LiesInThePatientAsALiverDoes) {
  const Surface& surface = defaultLiver().surface;
  const auto box = boundingBox(surface.points);
  // x to the left, y to the back, z to the head: more of it right of the falciform than left.
  EXPECT_LT(box(0, 0), -100);
  EXPECT_GT(box(1, 0), 50);
  double rightTop = -1e9, leftTop = -1e9, rightBottom = 1e9, leftBottom = 1e9;
  for (Index i = 0; i < surface.size(); ++i) {
    const double x = surface.points(i, 0), z = surface.points(i, 2);
    (x < 0 ? rightTop : leftTop) = std::max(x < 0 ? rightTop : leftTop, z);
    (x < 0 ? rightBottom : leftBottom) = std::min(x < 0 ? rightBottom : leftBottom, z);
  }
  EXPECT_GT(rightTop, leftTop);             // the dome
  EXPECT_LT(rightBottom, leftBottom - 30);  // the margin rises to the left
}

TEST(SyntheticLiver, PatchesHaveTheSizesOfRealOnes) {
  const Surface& surface = defaultLiver().surface;
  EXPECT_THAT(patchLabels(surface), testing::ElementsAre(patch::kFalciform, patch::kInferiorRidge));
  const auto falciform = pointsOfPatch(surface, patch::kFalciform).size(),
             ridge = pointsOfPatch(surface, patch::kInferiorRidge).size();
  EXPECT_GT(falciform, 400u);  // of 58,000 points the real cases have 417 to 506, and 1,826 to 2,376
  EXPECT_LT(falciform, 3000u);
  EXPECT_GT(ridge, 1300u);
  EXPECT_LT(ridge, 2600u);
}

TEST(SyntheticLiver, FalciformLiesInAGrooveAndRidgeOnASharpEdgeBelow) {
  const Surface& surface = defaultLiver().surface;
  const auto falciform = pointsOfPatch(surface, patch::kFalciform),
             ridge = pointsOfPatch(surface, patch::kInferiorRidge);
  EXPECT_GT(meanHollow(surface, falciform), 0.3);  // mm; a flat strip has 0, a dome less
  EXPECT_LT(meanHollow(surface, ridge), -0.7);
  std::vector<int> rest = unpainted(surface);
  rest.resize(rest.size() / 20);
  EXPECT_LT(std::abs(meanHollow(surface, rest)), 0.5);
  for (const int i : ridge) EXPECT_LT(surface.points(i, 1), 5);  // in front
  double ridgeZ = 0, falciformZ = 0;
  for (const int i : ridge) ridgeZ += surface.points(i, 2) / static_cast<double>(ridge.size());
  for (const int i : falciform) falciformZ += surface.points(i, 2) / static_cast<double>(falciform.size());
  EXPECT_LT(ridgeZ, falciformZ - 30);
}

TEST(SyntheticLiver, EachPatchIsOnePiece) {
  const Surface& surface = defaultLiver().surface;
  for (const int label : {patch::kFalciform, patch::kInferiorRidge}) {
    const auto ids = pointsOfPatch(surface, label);
    const Surface piece = subset(surface, ids);
    // A frayed border may leave a vertex or two aside.
    EXPECT_GT(static_cast<double>(largestPiece(piece).size()), 0.98 * static_cast<double>(ids.size()))
        << label;
  }
}

TEST(SyntheticLiver, StructuresLieInsideAndAreClosed) {
  const SyntheticLiver& liver = defaultLiver();
  const TriangleTree tree(liver.surface);
  std::set<std::string> names;
  for (const auto& [name, structure] : liver.structures) {
    names.insert(name);
    EXPECT_TRUE(inspectTopology(structure).closedManifold())
        << name << ": " << describeTopology(inspectTopology(structure));
    EXPECT_GT(signedVolume(structure), 2000) << name;  // mm3, faces outwards
    for (Index i = 0; i < structure.size(); ++i) {
      const ClosestPlace place = tree.closest(structure.points.row(i).transpose());
      ASSERT_LT(place.side * place.distance, -1) << name;  // mm
    }
  }
  EXPECT_THAT(names, testing::ElementsAre("hepatic vein", "portal vein", "tumour 1", "tumour 2"));
  for (const char* name : {"tumour 1", "tumour 2"}) {
    const auto box = boundingBox(liver.structures.at(name).points);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GT(box(1, axis) - box(0, axis), 15) << name;
      EXPECT_LT(box(1, axis) - box(0, axis), 30) << name;
    }
  }
}

TEST(SyntheticLiver, TargetsLieInsideAndLandmarksOnTheSurface) {
  const SyntheticLiver& liver = defaultLiver();
  const TriangleTree tree(liver.surface);
  EXPECT_GE(liver.targets.points.size(), 20u);
  EXPECT_GE(liver.anatomical.points.size(), 5u);
  std::set<std::string> names;
  for (const Landmark& target : liver.targets.points) {
    EXPECT_TRUE(names.insert(target.name).second) << target.name;
    const ClosestPlace place = tree.closest(target.position);
    EXPECT_LT(place.side * place.distance, -3) << target.name;  // mm
  }
  for (const Landmark& landmark : liver.anatomical.points) {
    EXPECT_TRUE(names.insert(landmark.name).second) << landmark.name;
    EXPECT_LT(tree.closest(landmark.position).distance, 1e-9) << landmark.name;  // they are vertices
  }
}

TEST(SyntheticLiver, IsTheSameWithAnyNumberOfThreads) {
  SyntheticLiverSettings settings;
  settings.edgeLengthMm = 6;
  settings.variation = 0.1;
  settings.seed = 7;
  setThreads(1);
  const SyntheticLiver one = makeSyntheticLiver(settings);
  setThreads(3);
  const SyntheticLiver three = makeSyntheticLiver(settings);
  setThreads(0);
  EXPECT_TRUE(one.surface.points == three.surface.points);
  EXPECT_TRUE(one.surface.triangles == three.surface.triangles);
  EXPECT_EQ(one.surface.patch, three.surface.patch);
  for (const auto& [name, structure] : one.structures)
    EXPECT_TRUE(structure.points == three.structures.at(name).points) << name;
}

TEST(SyntheticLiver, RefusesSettingsOutOfRange) {
  SyntheticLiverSettings settings;
  settings.widthMm = 20;
  EXPECT_THROW((void)makeSyntheticLiver(settings), InputError);
  EXPECT_THROW((void)makeSyntheticLabelMap(settings), InputError);
}

TEST(SyntheticLiver, StopsOnRequest) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)makeSyntheticLiver({}, Progress({}, stop.get_token())), Cancelled);
}

}  // namespace
}  // namespace falciform
