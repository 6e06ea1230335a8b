#include "Widgets/Rendering/Pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "Logic/Core/Errors.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Testing/Rendering/Baseline.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/PictureScenes.h"

namespace falciform {

namespace {

constexpr PictureSize kSmall{320, 240};

PictureSources allSources() {
  const Isometry3d pose = test::randomMotion(4);
  PictureSources sources;
  sources.preop = std::make_shared<Surface>(test::lumpyBody(4));
  Surface scan = transformed(*sources.preop, pose, "scanner");
  scan.points *= 1.01;
  sources.scan = std::make_shared<Surface>(scan);
  RegistrationResult registration;
  registration.scanFromPreop = pose;
  for (int i = 1; i <= 30; ++i) registration.history.push_back({i, 1 + 5.0 / i, 100.0 / i, 0.1, {}});
  sources.registration = std::make_shared<RegistrationResult>(registration);
  sources.distance = std::make_shared<DistanceMap>(mapDistances(*sources.preop, *sources.scan, pose));
  return sources;
}

std::vector<std::string> names(const std::vector<PictureFile>& pictures) {
  std::vector<std::string> result;
  for (const PictureFile& picture : pictures) result.push_back(picture.file.filename().string());
  return result;
}

}  // namespace

TEST(Pictures, AllEightAreWrittenInOrderNoneEmpty) {
  const test::TemporaryFolder folder;
  const auto pictures = savePictures(allSources(), folder / "new", Overwrite::Refuse, kSmall);
  EXPECT_THAT(names(pictures),
              testing::ElementsAre("preop.png", "scan.png", "before.png", "after.png", "distance_preop.png",
                                   "distance_scan.png", "histogram.png", "convergence.png"));
  for (const PictureFile& picture : pictures) {
    const RenderedImage image = readPng(picture.file);
    EXPECT_EQ(image.width, 320) << picture.file;
    EXPECT_EQ(image.height, 240) << picture.file;
    const int white = test::countColour(image, {1, 1, 1}, 2);
    EXPECT_LT(white, 320 * 240 * 0.95) << picture.file << " is all but blank";
    EXPECT_GT(white, 320 * 240 * 0.2) << picture.file << " has no background left";
    EXPECT_FALSE(picture.caption.empty());
  }
}

TEST(Pictures, WhatIsMissingIsLeftOut) {
  const test::TemporaryFolder folder;
  PictureSources sources = allSources();
  sources.scan = nullptr;
  sources.distance = nullptr;
  EXPECT_THAT(names(savePictures(sources, folder.path(), Overwrite::Refuse, kSmall)),
              testing::ElementsAre("preop.png", "convergence.png"));
  EXPECT_TRUE(savePictures({}, folder.path(), Overwrite::Refuse, kSmall).empty());
}

TEST(Pictures, OldFilesAreReplacedOnlyWhenAskedFor) {
  const test::TemporaryFolder folder;
  PictureSources sources;
  sources.preop = allSources().preop;
  EXPECT_EQ(savePictures(sources, folder.path(), Overwrite::Refuse, kSmall).size(), 1u);
  EXPECT_THROW((void)savePictures(sources, folder.path(), Overwrite::Refuse, kSmall), InputError);
  EXPECT_EQ(savePictures(sources, folder.path(), Overwrite::Replace, kSmall).size(), 1u);
}

TEST(Pictures, AbsurdSizesAreRefused) {
  const test::TemporaryFolder folder;
  const Surface body = test::lumpyBody(2);
  EXPECT_THROW(savePreopPicture(body, {}, folder / "a.png", Overwrite::Refuse, {10, 10}), InputError);
  EXPECT_THROW(savePreopPicture(body, {}, folder / "a.png", Overwrite::Refuse, {9000, 100}), InputError);
  EXPECT_THROW(savePreopPicture(body, {}, folder / "a.png", Overwrite::Refuse, {-5, 2000000000}), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(Pictures, StopLeavesOnlyWholeFiles) {
  const test::TemporaryFolder folder;
  std::stop_source stop;
  const Progress progress(
      [&](double fraction, std::string_view) {
        if (fraction > 0.2) stop.request_stop();
      },
      stop.get_token());
  EXPECT_THROW((void)savePictures(allSources(), folder.path(), Overwrite::Refuse, kSmall, progress),
               Cancelled);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_NO_THROW((void)readPng(entry.path()));
}

TEST(Pictures, DistancePictureHasALabelledBar) {
  const test::TemporaryFolder folder;
  const PictureSources sources = allSources();
  saveDistancePicture(*sources.distance, DistanceSide::Preop, folder / "d.png", Overwrite::Refuse,
                      {640, 480});
  const RenderedImage image = readPng(folder / "d.png");
  const auto dark = [&](int x0, int x1, int y0, int y1) {
    int count = 0;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) {
        const auto c = image.at(x, y);
        count += c[0] < 130 && c[1] < 130 && c[2] < 130;
      }
    return count;
  };
  EXPECT_GT(dark(592, 640, 60, 320), 60) << "numbers right of the bar";
  EXPECT_GT(dark(500, 640, 40, 66), 60) << "title and unit above it";
  EXPECT_EQ(dark(636, 640, 0, 480), 0) << "nothing is cut off at the edge";
  EXPECT_GT(dark(0, 420, 435, 458), 150) << "the sentence on the sign";
  const auto top = image.at(578, 70), bottom = image.at(578, 300);
  EXPECT_GT(top[0], top[2] + 60) << "red at the upper end";
  EXPECT_GT(bottom[2], bottom[0] + 60) << "blue at the lower end";
}

TEST(Pictures, OverlayShowsPreopPatchesRedAndScanPatchesBlue) {
  const Surface preop = test::lumpyBody(5);
  const Surface scan = transformed(preop, Isometry3d(Eigen::Translation3d(250, 0, 0)), "scanner");
  const auto scene = overlayScene(preop, scan, Isometry3d::Identity(), "Apart", {640, 480},
                                  directionOf(StandardView::Superior));
  OffscreenWindow window(640, 480);
  window.show(*scene);
  const RenderedImage image = window.image();
  // Seen from above, +x lies at the left: the scan left, the pre-op surface right.
  int red[2] = {0, 0}, blue[2] = {0, 0};
  for (int y = 110; y < 440; ++y)  // below the legend
    for (int x = 0; x < 640; ++x) {
      const auto c = image.at(x, y);
      red[x >= 320] += c[0] > c[1] + 80 && c[0] > c[2] + 70;
      blue[x >= 320] += c[2] > c[0] + 80 && c[2] > c[1] + 60;
    }
  EXPECT_EQ(red[0], 0);
  EXPECT_GT(red[1], 50);
  EXPECT_GT(blue[0], 50);
  EXPECT_EQ(blue[1], 0);
}

}  // namespace falciform
