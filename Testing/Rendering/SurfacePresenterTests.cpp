#include "Widgets/Rendering/SurfacePresenter.h"

#include <gtest/gtest.h>
#include <vtkMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Rendering/Scene.h"

namespace falciform {

namespace {

struct Shown : testing::Test {
  Shown() { window.show(scene); }

  void look(StandardView view) {
    setStandardView(scene.renderer(), view);
    window.render();
  }
  /// Pixel where a vertex is drawn, red, green, blue.
  [[nodiscard]] Vector3d pixelOf(const RenderedImage& image, const Vector3d& point) const {
    const Eigen::Vector2d at = screenPosition(scene.renderer(), point);
    const auto c = image.at(static_cast<int>(at.x()), image.height - 1 - static_cast<int>(at.y()));
    return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
  }
  /// Vertices that the camera sees well inside the outline and whose neighbours all carry the same value of
  /// `same`.
  template <class Same>
  [[nodiscard]] std::vector<int> clearVertices(const Surface& surface, const Same& same) const {
    const SurfacePicker picker(std::make_shared<Surface>(surface));
    const Points normals = vertexNormals(surface);
    const Adjacency around = neighboursOfVertices(surface.triangles, surface.size());
    std::vector<int> ids;
    for (int i = 0; i < surface.size(); ++i) {
      const Vector3d p = surface.points.row(i).transpose();
      const Eigen::Vector2d at = screenPosition(scene.renderer(), p);
      const PickRay ray = pickRay(scene.renderer(), at.x(), at.y());
      const auto hit = picker.pick(ray);
      if (!hit || (hit->point - p).norm() > 0.01) continue;
      if (normals.row(i).dot(ray.direction) > -0.4) continue;  // background blends into the outline
      if (std::all_of(around.begin(i), around.end(i), [&](int j) { return same(i, j); })) ids.push_back(i);
    }
    return ids;
  }

  Scene scene;
  OffscreenWindow window{640, 480};
  SurfacePresenter& presenter = scene.add<SurfacePresenter>();
};

}  // namespace

TEST_F(Shown, PatchesHaveTheirColoursWhereTheirVerticesAreDrawn) {
  const auto body = std::make_shared<Surface>(test::lumpyBody(5));
  presenter.show(body);
  look(StandardView::Superior);
  const RenderedImage image = window.image();
  const auto clear = clearVertices(*body, [&](int i, int j) { return body->patchAt(i) == body->patchAt(j); });
  int checked = 0;
  for (const int i : clear) {
    const int label = body->patchAt(i);
    if (label == patch::kNone && i % 20) continue;
    const Vector3d pixel = pixelOf(image, body->points.row(i).transpose()).normalized();
    // Light changes brightness and a highlight adds white, but of the colours in use the right one stays the
    // nearest.
    const auto likeness = [&](int candidate) {
      return pixel.dot((candidate == patch::kNone ? kLiverColour : patchColour(candidate)).normalized());
    };
    EXPECT_GT(likeness(label), 0.95) << i;
    for (int other = 0; other <= 4; ++other)
      if (other != label) {
        EXPECT_GT(likeness(label), likeness(other)) << i << " looks like " << other;
      }
    checked += label == patch::kFalciform;
  }
  EXPECT_GT(checked, 10) << "falciform vertices are in view";
}

TEST_F(Shown, NoValueIsGreyAndSignsHaveTheirColours) {
  auto ball = std::make_shared<Surface>(test::sphere(50, 4));
  VectorXd values = ball->points.col(0) / 5;
  for (Index i = 0; i < ball->size(); ++i)
    if (ball->points(i, 2) > 20) values[i] = std::numeric_limits<double>::quiet_NaN();
  ball->arrays["d"] = values;
  presenter.show(ball);
  presenter.setScalarMap(ScalarMap{"d", "Distance", "mm", -10, 10, OutOfRange::Grey});
  look(StandardView::Anterior);
  const RenderedImage image = window.image();
  const auto none = [&](int i) { return std::isnan(values[i]); };
  int grey = 0, red = 0, blue = 0;
  for (const int i : clearVertices(*ball, [&](int a, int b) { return none(a) == none(b); })) {
    const Vector3d pixel = pixelOf(image, ball->points.row(i).transpose());
    if (none(i)) {
      EXPECT_LT(pixel.maxCoeff() - pixel.minCoeff(), 4) << "grey has three equal channels, of 255";
      ++grey;
    } else if (values[i] > 5) {
      EXPECT_GT(pixel.x(), pixel.z() + 40);
      ++red;
    } else if (values[i] < -5) {
      EXPECT_GT(pixel.z(), pixel.x() + 40);
      ++blue;
    }
  }
  EXPECT_GT(std::min({grey, red, blue}), 20);
}

TEST_F(Shown, AnArrayThatIsMissingIsAllGrey) {
  const auto ball = std::make_shared<Surface>(test::sphere(50, 3));
  presenter.show(ball);
  presenter.setScalarMap(ScalarMap{"nothing", "", "", -1, 1, OutOfRange::Grey});
  look(StandardView::Anterior);
  const auto c = window.image().at(320, 240);
  EXPECT_EQ(c[0], c[1]);
  EXPECT_EQ(c[1], c[2]);
}

TEST_F(Shown, LabelEditsChangeColoursAndNothingElse) {
  const auto ball = std::make_shared<Surface>(test::sphere(50, 3));
  presenter.show(ball);
  look(StandardView::Anterior);
  auto* geometry = presenter.actor()->GetMapper()->GetInput();
  const RenderedImage before = window.image();
  std::vector<int> all(static_cast<std::size_t>(ball->size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  presenter.setPatchLabels(all, std::vector<int>(all.size(), patch::kFalciform));
  const auto c = window.image().at(320, 240);
  EXPECT_GT(c[2], c[0] + 60) << "blue";
  presenter.setPatchLabels(all, std::vector<int>(all.size(), patch::kNone));
  EXPECT_EQ(window.image().rgb, before.rgb);

  auto painted = std::make_shared<Surface>(*ball);
  painted->patch.assign(all.size(), patch::kInferiorRidge);
  presenter.show(painted);
  EXPECT_EQ(presenter.actor()->GetMapper()->GetInput(), geometry) << "same geometry is kept";
  presenter.show(std::make_shared<Surface>(test::sphere(50, 2)));
  EXPECT_NE(presenter.actor()->GetMapper()->GetInput(), geometry);
}

TEST_F(Shown, ScansShowTheirOwnColoursUnlessTurnedOff) {
  auto scan = std::make_shared<Surface>(test::sphere(50, 3));
  scan->colours = Colours::Zero(scan->size(), 3);
  scan->colours.col(1).setConstant(220);
  presenter.show(scan);
  look(StandardView::Anterior);
  auto c = window.image().at(320, 240);
  EXPECT_GT(c[1], c[0] + 100) << "green texture";
  SurfaceStyle style;
  style.ownColours = false;
  presenter.setStyle(style);
  c = window.image().at(320, 240);
  EXPECT_GT(c[0], c[1]) << "the liver's colour";
}

TEST_F(Shown, CloudsAreLitFromEitherSide) {
  auto cloud = std::make_shared<Surface>(test::grid(100, 100));
  cloud->triangles.resize(0, 3);
  presenter.show(cloud);
  for (const StandardView view : {StandardView::Superior, StandardView::Inferior}) {
    look(view);
    const RenderedImage image = window.image();
    EXPECT_GT(pixelOf(image, Vector3d(50, 50, 0)).maxCoeff(), 150)
        << "not black, view " << static_cast<int>(view);
  }
}

TEST_F(Shown, SeeThroughSurfacesLetInnerOnesShow) {
  const auto ball = std::make_shared<Surface>(test::sphere(50, 3));
  presenter.show(ball);
  auto& inner = scene.add<SurfacePresenter>();
  SurfaceStyle blue;
  blue.colour = {0, 0, 1};
  inner.setStyle(blue);
  inner.show(std::make_shared<Surface>(test::sphere(20, 3)));
  look(StandardView::Anterior);
  const auto solid = window.image().at(320, 240);
  SurfaceStyle glass;
  glass.opacity = 0.4;
  presenter.setStyle(glass);
  const auto through = window.image().at(320, 240);
  EXPECT_LT(solid[2], solid[0]);
  EXPECT_GT(through[2], through[0]);
}

TEST_F(Shown, EmptyAndHiddenSurfacesDrawNothing) {
  const RenderedImage empty = window.image();
  presenter.show(std::make_shared<Surface>());
  EXPECT_EQ(window.image().rgb, empty.rgb);
  presenter.show(std::make_shared<Surface>(test::sphere(50, 2)));
  SurfaceStyle hidden;
  hidden.visible = false;
  presenter.setStyle(hidden);
  EXPECT_EQ(window.image().rgb, empty.rgb);
  presenter.setStyle({});
  presenter.show(nullptr);
  EXPECT_EQ(window.image().rgb, empty.rgb);
  Surface two;
  two.points = Points::Random(2, 3);
  presenter.show(std::make_shared<Surface>(two));
  EXPECT_NO_THROW(window.render()) << "a cloud too small for normals";
}

TEST_F(Shown, ASurfaceThatMovesIsDrawnAsIfItWereShownAnew) {
  const Surface rest = test::sphere(40, 4);
  Surface moved = rest;
  for (Index i = 0; i < moved.size(); ++i) moved.points(i, 2) *= 1 + 0.01 * moved.points(i, 0);
  presenter.show(std::make_shared<Surface>(rest));
  look(StandardView::Anterior);
  const RenderedImage before = window.image();
  presenter.show(std::make_shared<Surface>(moved));
  const RenderedImage live = window.image();
  presenter.show(nullptr);
  presenter.show(std::make_shared<Surface>(moved));
  EXPECT_NE(live.rgb, before.rgb);
  EXPECT_EQ(live.rgb, window.image().rgb);
}

}  // namespace falciform
