#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <memory>

#include "Testing/Rendering/Baseline.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/BrushCursorPresenter.h"
#include "Widgets/Rendering/BrushRing.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

namespace {

constexpr PictureSize kSize{320, 240};

RenderedImage drawn(Scene& scene) {
  OffscreenWindow window(kSize.width, kSize.height);
  window.show(scene);
  return window.image();
}

/// Distances that run from -8 to 8 mm along x; none where z < -20.
Surface withDistances(Surface body) {
  VectorXd values = body.points.col(0) / 100 * 8;
  for (Index i = 0; i < body.size(); ++i)
    if (body.points(i, 2) < -20) values[i] = std::numeric_limits<double>::quiet_NaN();
  body.arrays[kSignedDistance] = values;
  return body;
}

}  // namespace

TEST(Baselines, AreNotMatchedByAnotherPicture) {
  if (std::getenv("FALCIFORM_UPDATE_BASELINES")) GTEST_SKIP() << "baselines are being written";
  Surface other = test::lumpyBody(4);
  other.patch.assign(other.patch.size(), patch::kInferiorRidge);
  EXPECT_FALSE(test::matchesBaseline(drawn(*preopScene(other, {}, kSize)), "preop"));
}

TEST(Baselines, PreopWithPatchesAndTumour) {
  const Structures structures{{"tumour", std::make_shared<Surface>(test::sphere(15, 3, {-30, 0, 10}))}};
  EXPECT_TRUE(test::matchesBaseline(drawn(*preopScene(test::lumpyBody(4), structures, kSize)), "preop"));
}

TEST(Baselines, OverlayOfBodyAndCloud) {
  const Surface preop = test::lumpyBody(4);
  Surface scan = preop;
  scan.triangles.resize(0, 3);
  scan.points.col(2).array() += 6;
  EXPECT_TRUE(test::matchesBaseline(drawn(*overlayScene(preop, scan, Isometry3d::Identity(), "Overlay", kSize,
                                                        directionOf(StandardView::Anterior))),
                                    "overlay"));
}

TEST(Baselines, DistanceMapWithBar) {
  DistanceMap map;
  map.preop = withDistances(test::lumpyBody(4));
  map.scan = map.preop;
  EXPECT_TRUE(test::matchesBaseline(
      drawn(*distanceScene(map, DistanceSide::Preop, kSize, Isometry3d::Identity())), "distance"));
}

TEST(Baselines, ConvergenceCurve) {
  RegistrationResult result;
  for (int i = 1; i <= 60; ++i) result.history.push_back({i, 2 + 10.0 / i, 1 + 999.0 / (i * i), 0.1, {}});
  EXPECT_TRUE(test::matchesBaseline(drawn(*convergenceScene(result, kSize)), "convergence"));
}

TEST(Baselines, BrushRingAndEdgesOnScreenBackground) {
  Scene scene(screenStyle(9));
  auto& presenter = scene.add<SurfacePresenter>();
  SurfaceStyle style;
  style.edges = true;
  presenter.setStyle(style);
  const auto ball = std::make_shared<Surface>(test::sphere(50, 2));
  presenter.show(ball);
  auto& cursor = scene.add<BrushCursorPresenter>();
  const TriangleTree tree(*ball);
  const auto hit = tree.cast({10, -100, 10}, {0, 1, 0});
  ASSERT_TRUE(hit);
  cursor.show(geodesicRing(tree, hit->triangle, hit->point, 15), patchColour(1));
  setStandardView(scene.renderer(), StandardView::Anterior);
  EXPECT_TRUE(test::matchesBaseline(drawn(scene), "brush"));
}

}  // namespace falciform
