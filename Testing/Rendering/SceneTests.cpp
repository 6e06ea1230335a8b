#include "Widgets/Rendering/Scene.h"

#include <gtest/gtest.h>

#include <memory>

#include "Logic/Core/Errors.h"
#include "Testing/Rendering/Baseline.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

namespace {

/// Pixels in a rectangle (from the top left) that are not white.
int inked(const RenderedImage& image, int x0, int y0, int x1, int y1) {
  int count = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const auto c = image.at(x, y);
      count += c[0] + c[1] + c[2] < 3 * 200;
    }
  return count;
}

}  // namespace

TEST(Scene, AlwaysSaysResearchUseOnly) {
  Scene scene;
  OffscreenWindow window(640, 480);
  window.show(scene);
  const RenderedImage image = window.image();
  EXPECT_GT(inked(image, 0, 455, 320, 480), 300) << "the notice at the lower left";
  EXPECT_EQ(inked(image, 0, 0, 640, 380), 0) << "and nothing else above";
}

TEST(Scene, CubeShowsItsLettersUnlessHidden) {
  Scene scene;
  OffscreenWindow window(640, 480);
  window.show(scene);
  const int with = inked(window.image(), 545, 390, 640, 480);
  scene.orientation().setVisible(false);
  EXPECT_GT(with, 100);
  EXPECT_EQ(inked(window.image(), 545, 390, 640, 480), 0);
}

TEST(Scene, RemovedPresenterLeavesNothingBehind) {
  Scene scene;
  OffscreenWindow window(320, 240);
  window.show(scene);
  const RenderedImage empty = window.image();
  auto& presenter = scene.add<SurfacePresenter>();
  presenter.show(std::make_shared<Surface>(test::sphere(50, 3)));
  scene.renderer()->ResetCamera();
  EXPECT_NE(window.image().rgb, empty.rgb);
  scene.remove(presenter);
  EXPECT_EQ(window.image().rgb, empty.rgb);
}

TEST(Scene, OneWindowAfterTheOtherShowsTheSame) {
  Scene scene;
  scene.add<SurfacePresenter>().show(std::make_shared<Surface>(test::lumpyBody(3)));
  scene.renderer()->ResetCamera();
  OffscreenWindow first(320, 240);
  first.show(scene);
  const RenderedImage image = first.image();
  OffscreenWindow second(320, 240);
  second.show(scene);
  EXPECT_EQ(second.image().rgb, image.rgb);
}

TEST(Scene, TwoWindowsLiveSideBySide) {
  Scene red, blue;
  for (Scene* scene : {&red, &blue}) {
    auto& presenter = scene->add<SurfacePresenter>();
    SurfaceStyle style;
    style.colour = scene == &red ? Vector3d(1, 0, 0) : Vector3d(0, 0, 1);
    presenter.setStyle(style);
    presenter.show(std::make_shared<Surface>(test::sphere(50, 3)));
    scene->renderer()->ResetCamera();
  }
  OffscreenWindow a(200, 200), b(300, 200);
  a.show(red);
  b.show(blue);
  for (int round = 0; round < 2; ++round) {
    EXPECT_GT(a.image().at(100, 100)[0], 150);
    EXPECT_GT(b.image().at(150, 100)[2], 150);
  }
}

TEST(OffscreenWindow, RefusesAbsurdSizes) {
  EXPECT_THROW(OffscreenWindow(0, 100), InputError);
  EXPECT_THROW(OffscreenWindow(100, 100000), InputError);
}

TEST(OffscreenWindow, SavedPictureIsThePictureShownAndIsNotReplacedUnasked) {
  const test::TemporaryFolder folder;
  Scene scene;
  scene.add<SurfacePresenter>().show(std::make_shared<Surface>(test::sphere(50, 3)));
  scene.renderer()->ResetCamera();
  OffscreenWindow window(160, 120);
  window.show(scene);
  window.savePng(folder / "a.png", Overwrite::Refuse);
  EXPECT_EQ(readPng(folder / "a.png").rgb, window.image().rgb);
  EXPECT_THROW(window.savePng(folder / "a.png", Overwrite::Refuse), InputError);
  EXPECT_NO_THROW(window.savePng(folder / "a.png", Overwrite::Replace));
}

TEST(RenderedImage, HalvedIsTheMeanOfFour) {
  const RenderedImage image{
      4, 2, {0, 0, 0, 100, 0, 0, 8, 8, 8, 8, 8, 8, 100, 0, 0, 200, 0, 0, 8, 8, 8, 8, 8, 8}};
  const RenderedImage half = halved(image);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.rgb, (std::vector<std::uint8_t>{100, 0, 0, 8, 8, 8}));
}

}  // namespace falciform
