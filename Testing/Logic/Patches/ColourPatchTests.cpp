#include "Logic/Patches/ColourPatch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {
namespace {

/// A scan of the synthetic liver as the camera sees it: the ligament is paler, both are mottled.
const Surface& scan() {
  static const Surface made = [] {
    SyntheticLiverSettings settings;
    settings.edgeLengthMm = 3;
    VirtualScannerSettings scanner;
    scanner.stride = 4;
    scanner.elevationDeg = 0;
    return scanSurface(makeSyntheticLiver(settings).surface, scanner).scan;
  }();
  return made;
}

std::vector<int> truth() { return pointsOfPatch(scan(), patch::kFalciform); }

/// Points within `mm` of the true patch, moved by `shift`: what a hurried hand would paint.
Surface roughlyPainted(double mm, const Vector3d& shift) {
  Surface rough = scan();
  const KdTree tree(scan().points, truth());
  for (Index i = 0; i < rough.size(); ++i) {
    const Vector3d at = rough.points.row(i).transpose() - shift;
    rough.patch[static_cast<std::size_t>(i)] =
        tree.nearest(at).squaredDistance <= mm * mm ? patch::kFalciform : patch::kNone;
  }
  return rough;
}

double dice(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return 2.0 * static_cast<double>(both.size()) / static_cast<double>(a.size() + b.size());
}

TEST(ColourPatch, AWidePatchShrinksToWhatTheCameraSaw) {
  const Surface rough = roughlyPainted(6, Vector3d::Zero());
  EXPECT_LT(dice(pointsOfPatch(rough, patch::kFalciform), truth()), 0.75);  // or there is nothing to mend
  const ColourPatch refined = refinePatchByColour(rough, patch::kFalciform);
  EXPECT_TRUE(refined.refined);
  EXPECT_GT(dice(refined.vertices, truth()), 0.9);
}

TEST(ColourPatch, APatchPaintedAsideComesBack) {
  const Surface rough = roughlyPainted(3, Vector3d(3, 3, 3));
  const ColourPatch refined = refinePatchByColour(rough, patch::kFalciform);
  EXPECT_GT(dice(refined.vertices, truth()), 0.9);
}

TEST(ColourPatch, AThinScribbleGrows) {
  Surface scribble = scan();
  const std::vector<int> whole = truth();
  // Every point of the ligament that lies within 2.5 mm of its middle line, told by its nearest outside
  // point.
  std::vector<int> outside;
  for (Index i = 0; i < scan().size(); ++i)
    if (scan().patchAt(i) != patch::kFalciform) outside.push_back(static_cast<int>(i));
  const KdTree tree(scan().points, outside);
  double deepest = 0;
  for (const int v : whole) deepest = std::max(deepest, tree.nearest(scan().points.row(v)).squaredDistance);
  for (const int v : whole)
    if (tree.nearest(scan().points.row(v)).squaredDistance < 0.3 * deepest)
      scribble.patch[static_cast<std::size_t>(v)] = patch::kNone;
  EXPECT_LT(dice(pointsOfPatch(scribble, patch::kFalciform), whole), 0.8);
  EXPECT_GT(dice(refinePatchByColour(scribble, patch::kFalciform).vertices, whole), 0.9);
}

TEST(ColourPatch, WorksOnACloud) {
  Surface rough = roughlyPainted(6, Vector3d::Zero());
  rough.triangles.resize(0, 3);
  EXPECT_GT(dice(refinePatchByColour(rough, patch::kFalciform).vertices, truth()), 0.9);
}

TEST(ColourPatch, LeavesAPatchAloneWhereColourTellsNothing) {
  Surface grey = roughlyPainted(6, Vector3d::Zero());
  grey.colours.setConstant(120);
  const ColourPatch kept = refinePatchByColour(grey, patch::kFalciform);
  EXPECT_FALSE(kept.refined);
  EXPECT_EQ(kept.vertices, pointsOfPatch(grey, patch::kFalciform));
  EXPECT_THAT(kept.warnings, testing::SizeIs(1));
}

TEST(ColourPatch, RefusesASurfaceWithoutColoursAndAPatchThatIsNotThere) {
  Surface plain = roughlyPainted(6, Vector3d::Zero());
  EXPECT_THROW((void)refinePatchByColour(plain, 7), InputError);
  plain.colours.resize(0, 3);
  EXPECT_THROW((void)refinePatchByColour(plain, patch::kFalciform), InputError);
}

}  // namespace
}  // namespace falciform
