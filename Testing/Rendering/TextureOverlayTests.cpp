#include "Widgets/Rendering/TextureOverlay.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "Testing/Support/SmallSurfaces.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

namespace {

/// A sheet of four cells, so that its points cannot show what the picture on it does: a blue stripe between
/// x = 10 and 15 of 40 on red.
std::shared_ptr<Surface> stripedSheet() {
  auto sheet = std::make_shared<Surface>(test::grid(40, 2));
  sheet->textureAt = (sheet->points.leftCols<2>() / 40).cast<float>();
  ColourImage image{80, 80, {}};
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 80; ++x) {
      const bool stripe = x >= 20 && x < 30;
      image.rgb.insert(image.rgb.end(), {static_cast<std::uint8_t>(stripe ? 0 : 200), 0,
                                         static_cast<std::uint8_t>(stripe ? 200 : 0)});
    }
  sheet->texture = std::make_shared<const ColourImage>(std::move(image));
  sheet->colours = coloursAt(*sheet->texture, sheet->textureAt);
  return sheet;
}

struct TexturedView : testing::Test {
  TexturedView() { window.show(scene); }

  void show(const std::shared_ptr<const Surface>& surface) {
    presenter.show(surface);
    fitView(scene.renderer(), surface->points, {Vector3d::UnitZ(), Vector3d::UnitY()}, 1.0);
    draw();
  }
  void draw() {
    window.render();
    image = window.image();
  }
  /// What is drawn at a place of the sheet.
  [[nodiscard]] std::array<int, 3> at(double x, double y) const {
    const Eigen::Vector2d pixel = screenPosition(scene.renderer(), Vector3d(x, y, 0));
    return image.at(static_cast<int>(pixel.x()), image.height - 1 - static_cast<int>(pixel.y()));
  }
  [[nodiscard]] bool blueAt(double x, double y) const { return at(x, y)[2] > 2 * at(x, y)[0] + 40; }
  [[nodiscard]] bool redAt(double x, double y) const { return at(x, y)[0] > 2 * at(x, y)[2] + 40; }

  Scene scene;
  OffscreenWindow window{400, 400};
  SurfacePresenter& presenter = scene.add<SurfacePresenter>();
  RenderedImage image;
};

TEST_F(TexturedView, ThePhotographIsDrawnFinerThanThePoints) {
  show(stripedSheet());
  for (const double y : {3.0, 12.0, 33.0}) {
    EXPECT_TRUE(redAt(5, y));
    EXPECT_TRUE(blueAt(12.5, y));
    EXPECT_TRUE(redAt(18, y));
    EXPECT_TRUE(redAt(35, y));
  }
}

TEST_F(TexturedView, PaintShowsOnItAlsoWhileAStrokeRuns) {
  auto sheet = stripedSheet();
  sheet->patch.assign(9, patch::kNone);
  sheet->patch[8] = patch::kInferiorRidge;  // the corner (40, 40): yellow
  show(sheet);
  EXPECT_GT(at(39, 39)[1], 100);
  EXPECT_TRUE(blueAt(12.5, 5));
  presenter.setPatchLabels({0}, {patch::kInferiorRidge});
  draw();
  EXPECT_GT(at(1, 1)[1], 100);
  presenter.setPatchLabels({0}, {patch::kNone});
  draw();
  EXPECT_TRUE(redAt(1, 1));
}

TEST_F(TexturedView, ValuesPlainColourAndTransparencyTakeItAway) {
  auto sheet = stripedSheet();
  sheet->arrays["a"] = VectorXd::Constant(9, 0.5);
  show(sheet);
  ScalarMap map;
  map.array = "a";
  presenter.setScalarMap(map);
  draw();
  EXPECT_FALSE(blueAt(12.5, 20) && redAt(18, 20));
  presenter.setScalarMap(std::nullopt);
  presenter.setStyle({.colour = {0, 1, 0}, .ownColours = false});
  draw();
  EXPECT_GT(at(12.5, 20)[1], at(12.5, 20)[2] + 40);
  presenter.setStyle({.opacity = 0.5});
  draw();
  EXPECT_FALSE(blueAt(12.5, 20)) << "its points have no stripe";
}

TEST_F(TexturedView, TrianglesOnASeamAreDrawnInTheColoursOfTheirPoints) {
  auto sheet = stripedSheet();
  sheet->textureAt.row(0).setConstant(std::numeric_limits<float>::quiet_NaN());  // the corner (0, 0)
  show(sheet);
  EXPECT_FALSE(blueAt(12.5, 3)) << "the cell at the corner has lost its place";
  EXPECT_TRUE(blueAt(12.5, 33));
}

TEST_F(TexturedView, ItMovesWithTheSurfaceAndGoesWithIt) {
  show(stripedSheet());
  Isometry3d motion = Isometry3d::Identity();
  motion.translation() = Vector3d(10, 0, 0);
  presenter.setSceneFromSurface(motion);
  draw();
  EXPECT_TRUE(blueAt(22.5, 20));
  EXPECT_TRUE(redAt(15, 20));
  auto plain = stripedSheet();
  plain->texture.reset();
  presenter.show(plain);
  draw();
  EXPECT_FALSE(blueAt(22.5, 20));
}

}  // namespace

}  // namespace falciform
