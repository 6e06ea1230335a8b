#include <gmock/gmock.h>

#include <cstring>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Logic/IO/ScanSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr int kWidth = 40, kHeight = 30;
constexpr char kCamera[] =
    R"({"width": 40, "height": 30, "fx": 100, "fy": 110, "cx": 19.5, "cy": 14.5, "depth_scale": 1000})";

class DepthFrames : public testing::Test {
 protected:
  void writeDepth(const std::string& name) {
    std::filesystem::create_directories((folder / name).parent_path());
    writePng(folder / name, slantedDepths(kWidth, kHeight), Overwrite::Replace);
  }
  TemporaryFolder folder;
};

/// The point of pixel (u, v), u > 0, by the pinhole's formula.
Vector3d pointOf(int u, int v) {
  const double z = 500 + 2 * (u - v);
  return {(u - 19.5) / 100 * z, (v - 14.5) / 110 * z, z};
}

void expectTheSlant(const Surface& scan, double scale = 1) {
  ASSERT_EQ(scan.size(), (kWidth - 1) * kHeight);  // the first column has no depth
  for (const auto& [u, v] : {std::pair(1, 0), {39, 0}, {7, 12}, {39, 29}})
    EXPECT_LT(
        (scan.points.row(static_cast<Index>(v) * (kWidth - 1) + u - 1).transpose() - pointOf(u, v) * scale)
            .norm(),
        1e-9);
  EXPECT_EQ(scan.triangles.rows(), 2 * (kWidth - 2) * (kHeight - 1));
  EXPECT_EQ(facingShare(scan, Vector3d::Zero()), 1);
}

TEST_F(DepthFrames, APngOfDepthsWithItsCameraIsASheetThatFacesIt) {
  writeDepth("frame.png");
  put(folder / "frame.json", kCamera);
  const Loaded<Surface> loaded = readSurface(folder / "frame.png");
  EXPECT_THAT(loaded.warnings, testing::IsEmpty());
  EXPECT_EQ(loaded.value.frame, "scanner");
  expectTheSlant(loaded.value);
  EXPECT_TRUE(isSurfaceFile(folder / "frame.png"));
}

TEST_F(DepthFrames, FoldersOfDepthAndColourWithOneCameraAreFound) {
  writeDepth("depth/0001.png");
  std::filesystem::create_directory(folder / "rgb");
  writePng(folder / "rgb/0001.png", gradientImage(2 * kWidth, 2 * kHeight), Overwrite::Refuse);
  // Open3D's file, column by column.
  put(folder / "camera_intrinsic.json",
      R"({"width": 40, "height": 30, "intrinsic_matrix": [100, 0, 0, 0, 110, 0, 19.5, 14.5, 1]})");
  const Surface scan = readSurface(folder / "depth/0001.png").value;
  expectTheSlant(scan);
  ASSERT_TRUE(scan.texture);
  EXPECT_EQ(scan.texture->width, 2 * kWidth);
  // Pixel (7, 12) covers columns 14 and 15, rows 24 and 25 of a photograph twice as fine; 14.5 rounds up.
  EXPECT_EQ(scan.colours.row(12 * (kWidth - 1) + 6), (Colours(1, 3) << 15, 25, 40).finished());
}

TEST_F(DepthFrames, TumDepthsAreDividedByTheirScale) {
  writeDepth("frame_depth.png");
  put(folder / "frame_depth.json", R"({"fx": 100, "fy": 110, "cx": 19.5, "cy": 14.5, "depth_scale": 5000})");
  expectTheSlant(readSurface(folder / "frame_depth.png").value, 0.2);
}

TEST_F(DepthFrames, APoseCarriesTheScanIntoTheTrackersFrame) {
  writeDepth("frame_depth.png");
  put(folder / "frame_depth.json", kCamera);
  put(folder / "frame_pose.txt", "0 -1 0 10\n1 0 0 20\n0 0 1 30\n0 0 0 1\n");
  const Surface scan = readSurface(folder / "frame_depth.png").value;
  EXPECT_EQ(scan.frame, "tracker");
  const Vector3d p = pointOf(1, 0);
  EXPECT_LT((scan.points.row(0).transpose() - Vector3d(-p.y() + 10, p.x() + 20, p.z() + 30)).norm(), 1e-9);
  EXPECT_EQ(facingShare(scan, Vector3d(10, 20, 30)), 1);
}

TEST_F(DepthFrames, AnRgbdFileIsReadWithItsCalibAndTracker) {
  std::string bytes(8, '\0');
  const std::int32_t size[2]{kWidth, kHeight};
  std::memcpy(bytes.data(), size, sizeof size);
  for (const std::uint16_t depth : slantedDepths(kWidth, kHeight).depth) {
    bytes += std::string("\x64\x32\x0A\x00", 4);
    bytes.append(reinterpret_cast<const char*>(&depth), sizeof depth);
  }
  put(folder / "rgbd_4.rgbd", bytes);
  put(folder / "endo.calib", "40\n30\n100 0 19.5\n0 110 14.5\n0 0 1\n");
  put(folder / "polaris_4.xml",
      "<ImageData><position_camera RMES=\"0\">0 0 0 1 0 0 5</position_camera></ImageData>");
  const Surface scan = readSurface(folder / "rgbd_4.rgbd").value;
  EXPECT_EQ(scan.frame, "tracker");
  EXPECT_LT((scan.points.row(0).transpose() - pointOf(1, 0) - Vector3d(0, 0, 5)).norm(), 1e-9);
  EXPECT_EQ(scan.colours.row(9), (Colours(1, 3) << 100, 50, 10).finished());
  put(folder / "rgbd_4.rgbd", bytes.substr(0, bytes.size() - 1));
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "rgbd_4.rgbd"); }), HasSubstr("40 x 30"));
}

TEST_F(DepthFrames, WhatIsMissingOrDoesNotFitIsSaid) {
  writeDepth("frame.png");
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "frame.png"); }), HasSubstr("frame.json"));
  put(folder / "frame.json", R"({"width": 41, "height": 30, "fx": 1, "fy": 1, "cx": 1, "cy": 1})");
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "frame.png"); }), HasSubstr("41 x 30"));
  put(folder / "frame.json", R"({"fx": "a"})");
  EXPECT_THAT(refusalOf([&] { (void)readSurface(folder / "frame.png"); }), HasSubstr("no camera"));
  writePng(folder / "photo.png", gradientImage(4, 4), Overwrite::Refuse);
  EXPECT_FALSE(isSurfaceFile(folder / "photo.png"));
}

}  // namespace
}  // namespace falciform
