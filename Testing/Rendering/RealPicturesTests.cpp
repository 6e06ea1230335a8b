#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Support/RealData.h"
#include "Testing/Support/TemporaryFolder.h"
#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/Pictures.h"
#include "Widgets/Rendering/RenderedImage.h"
#include "Widgets/Rendering/ScanView.h"

namespace falciform {

namespace {

Isometry3d truePose(const std::filesystem::path& folder) {
  const auto truth = nlohmann::json::parse(std::ifstream(folder / "truth.json"));
  Isometry3d pose;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      pose.matrix()(r, c) =
          truth["scannerFromPreop_rigid"][static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
  return pose;
}

}  // namespace

class RealPictures : public testing::TestWithParam<const char*> {};

TEST_P(RealPictures, AreDrawnFromTheScansSideAndNotEmpty) {
  const std::string relative = std::string("update/") + GetParam();
  FALCIFORM_NEEDS_DATA(relative);
  const auto data = test::realData() / relative;
  PictureSources sources;
  sources.preop = std::make_shared<Surface>(readSurface(data / "preop.vtp").value);
  sources.scan = std::make_shared<Surface>(readSurface(data / "scan.vtp").value);
  RegistrationResult registration;
  registration.scanFromPreop = truePose(data);
  registration.history = {{1, 20, 1000, 5, {}}, {2, 10, 900, 2, {}}, {3, 8, 800, 1, {}}};
  sources.registration = std::make_shared<RegistrationResult>(registration);
  sources.distance =
      std::make_shared<DistanceMap>(mapDistances(*sources.preop, *sources.scan, registration.scanFromPreop));

  // The scanner stood outside: the cloud alone must tell which side that is.
  const Vector3d outwards =
      (sources.scan->points.colwise().mean() - sources.distance->preop.points.colwise().mean()).transpose();
  EXPECT_GT(seenFrom(*sources.scan).dot(outwards.normalized()), 0);

  const test::TemporaryFolder folder;
  const auto pictures = savePictures(sources, folder.path(), Overwrite::Refuse, {400, 300});
  ASSERT_EQ(pictures.size(), 8u);
  for (const PictureFile& picture : pictures) {
    const RenderedImage image = readPng(picture.file);
    int ink = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
      ink += image.rgb[i] + image.rgb[i + 1] + image.rgb[i + 2] < 720;
    EXPECT_GT(ink, 400 * 300 / 40) << picture.file;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, RealPictures,
                         testing::Values("ircad10_both", "ircad10_left", "ircad17_both", "ircad17_left",
                                         "ircad5_left", "ircad5_right", "ircad8_both"));

}  // namespace falciform
