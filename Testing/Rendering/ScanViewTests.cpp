#include "Widgets/Rendering/ScanView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {

namespace {

/// The part of a bumpy body that looks towards `view` by less than 70 degrees, in a frame of its own.
Surface seenPart(const Vector3d& view, const Isometry3d& frame) {
  const Surface body = test::lumpyBody(5);
  const Points normals = vertexNormals(body);
  std::vector<int> keep;
  for (Index i = 0; i < body.size(); ++i)
    if (normals.row(i).dot(view) > std::cos(70 * 3.14159265358979 / 180)) keep.push_back(static_cast<int>(i));
  return transformed(subset(body, keep), frame, "scanner");
}

}  // namespace

TEST(ScanView, FindsTheScannersSideOfMeshAndCloud) {
  const Vector3d views[] = {{0, 0, 1}, {0, -1, 0}, {0.5, -0.6, 0.6}, {0, 0.3, -1}};
  unsigned seed = 1;
  for (const Vector3d& direction : views) {
    const Vector3d view = direction.normalized();
    const Isometry3d frame = test::randomMotion(seed++);
    Surface scan = seenPart(view, frame);
    // A picture needs the right side and little foreshortening, not the angle itself: 35 degrees.
    const double enough = std::cos(35 * 3.14159265358979 / 180);
    EXPECT_GT(seenFrom(scan).dot(frame.linear() * view), enough) << "mesh, " << view.transpose();
    scan.triangles.resize(0, 3);
    EXPECT_GT(seenFrom(scan).dot(frame.linear() * view), enough) << "cloud, " << view.transpose();
  }
}

TEST(ScanView, LaysTheLongestExtentAcrossAndTheRidgeBelow) {
  const Isometry3d frame = test::randomMotion(9);
  const Surface scan = seenPart(Vector3d(0, -1, 0), frame);
  const Vector3d view = seenFrom(scan), up = uprightFor(scan, view);
  EXPECT_NEAR(up.dot(view), 0, 1e-9);
  const Vector3d longest = frame.linear() * Vector3d(1, 0, 0);
  EXPECT_LT(std::abs(up.dot(longest)), 0.35) << "the body is longest along x";
  Surface ridged = scan;
  for (Index i = 0; i < ridged.size(); ++i)
    ridged.patch[static_cast<std::size_t>(i)] =
        (ridged.points.row(i) - ridged.points.colwise().mean()).dot(up) > 25 ? patch::kInferiorRidge
                                                                             : patch::kNone;
  EXPECT_LT((uprightFor(ridged, view) + up).norm(), 1e-9) << "turned by 180 degrees";
}

TEST(ScanView, HasAnAnswerForTinyClouds) {
  for (const Index n : {0, 1, 2, 3, 5}) {
    Surface cloud;
    cloud.points = Points::Zero(n, 3);
    const Vector3d view = seenFrom(cloud);
    EXPECT_NEAR(view.norm(), 1, 1e-12) << n;
    EXPECT_NEAR(uprightFor(cloud, view).norm(), 1, 1e-12) << n;
  }
}

}  // namespace falciform
