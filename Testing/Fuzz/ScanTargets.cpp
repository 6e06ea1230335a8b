#include <cstring>
#include <fstream>
#include <iterator>

#include "Logic/IO/DepthCamera.h"
#include "Logic/IO/ImageFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Fuzz/FuzzTarget.h"
#include "Testing/Logic/IO/ScanSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"

namespace falciform::test {

namespace {

namespace fs = std::filesystem;

constexpr char kCamera[] =
    R"({"width": 20, "height": 15, "fx": 100, "fy": 110, "cx": 9.5, "cy": 7.5, "depth_scale": 1000})";

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The bytes of a file that is written and taken away again.
template <class Write>
std::string written(const fs::path& file, Write write) {
  write(file);
  std::string bytes = bytesOf(file);
  fs::remove(file);
  return bytes;
}

void readSound(const fs::path& file) {
  const Surface surface = readSurface(file).value;
  checkSurface(surface, "mutant");
  demand(surface.size() > 0, "a surface without points");
  demand(surface.texture == nullptr || surface.textureAt.rows() == surface.size(),
         "a texture without places");
}

void soundImage(const ColourImage& image) {
  demand(image.width > 0 && image.height > 0 &&
             image.rgb.size() == std::size_t{3} * static_cast<std::size_t>(image.width) *
                                     static_cast<std::size_t>(image.height),
         "an image with fewer pixels than it says");
}

std::string csvRaster() {
  std::string text = "row,column,x,y,z\n";
  const Points sheet = tiltedSheet(12, 10);
  for (Index i = 0; i < sheet.rows(); ++i)
    text += std::to_string(i / 10) + ',' + std::to_string(i % 10) + ',' + std::to_string(sheet(i, 0)) + ',' +
            std::to_string(sheet(i, 1)) + ',' + std::to_string(sheet(i, 2)) + '\n';
  return text;
}

std::string xyzRaster() {
  std::string text = "# raster 12 10\nnan nan nan\n";
  const Points sheet = tiltedSheet(12, 10);
  for (Index i = 1; i < sheet.rows(); ++i)
    text += std::to_string(sheet(i, 0)) + ' ' + std::to_string(sheet(i, 1)) + ' ' +
            std::to_string(sheet(i, 2)) + '\n';
  return text;
}

std::string rgbd() {
  const std::int32_t size[2]{20, 15};
  std::string bytes(reinterpret_cast<const char*>(size), sizeof size);
  for (const std::uint16_t depth : slantedDepths(20, 15).depth) {
    bytes += std::string("\x64\x32\x0A\x00", 4);
    bytes.append(reinterpret_cast<const char*>(&depth), sizeof depth);
  }
  return bytes;
}

/// With the image that it names beside it.
std::string texturedSheet(const fs::path& folder, const std::string& kind) {
  Surface surface;
  surface.points = tiltedSheet(4, 5);
  surface.triangles.resize(2, 3);
  surface.triangles << 0, 5, 6, 0, 6, 1;
  surface.textureAt = (surface.points.leftCols<2>() / 5).cast<float>();
  surface.texture = std::make_shared<const ColourImage>(gradientImage(16, 8));
  const fs::path good = folder / ("s." + kind);
  writeSurface(good, surface, Overwrite::Refuse);
  std::string bytes = bytesOf(good);
  fs::remove(good);
  return bytes;
}

std::vector<FuzzTarget> rasterTargets() {
  std::vector<FuzzTarget> targets;
  for (const std::string coding : {"ascii", "binary", "binary_compressed"})
    targets.push_back({"pcd_" + coding, "s.pcd",
                       [coding](const fs::path&) {
                         return pcdOf(tiltedSheet(12, 10), 12, 10, {7, 50}, coding);
                       },
                       readSound});
  targets.push_back({"ply_range_grid", "s.ply",
                     [](const fs::path&) {
                       return rangeGridOf(tiltedSheet(12, 10), 12, 10, {3, 44});
                     },
                     readSound});
  targets.push_back({"csv_raster", "s.csv", [](const fs::path&) { return csvRaster(); }, readSound});
  targets.push_back({"xyz_raster", "s.xyz", [](const fs::path&) { return xyzRaster(); }, readSound});
  for (const std::string kind : {"obj", "ply", "vtp"})
    targets.push_back({"textured_" + kind, "s." + kind,
                       [kind](const fs::path& folder) { return texturedSheet(folder, kind); }, readSound});
  return targets;
}

std::vector<FuzzTarget> depthTargets() {
  std::vector<FuzzTarget> targets;
  targets.push_back({"rgbd", "rgbd_1.rgbd",
                     [](const fs::path& folder) {
                       put(folder / "camera.json", kCamera);
                       return rgbd();
                     },
                     readSound});
  targets.push_back({"depth_png", "depth.png",
                     [](const fs::path& folder) {
                       put(folder / "camera.json", kCamera);
                       return written(folder / "d.png", [](const fs::path& file) {
                         writePng(file, slantedDepths(20, 15), Overwrite::Refuse);
                       });
                     },
                     [](const fs::path& file) {
                       const DepthImage depths = readDepthImage(file);
                       demand(depths.depth.size() == static_cast<std::size_t>(depths.width) *
                                                         static_cast<std::size_t>(depths.height),
                              "depths with fewer pixels than they say");
                       readSound(file);
                     }});
  const auto camera = [](const fs::path& file) {
    demand(readDepthCamera(file).fx > 0, "a camera without a focal length");
  };
  targets.push_back({"camera_json", "c.json", [](const fs::path&) { return std::string(kCamera); }, camera});
  targets.push_back(
      {"camera_calib", "c.calib",
       [](const fs::path&) { return std::string("20\n15\n100 0 9.5\n0 110 7.5\n0 0 1\n100 0 9.5 0\n"); },
       camera});
  targets.push_back({"tracker_xml", "p.xml",
                     [](const fs::path&) {
                       return std::string(
                           "<ImageData>\n<position_camera RMES=\"0\">\n0 0 0.6 0.8 10 20 "
                           "30\n</position_camera>\n</ImageData>");
                     },
                     [](const fs::path& file) {
                       demand(readCameraPose(file).matrix().allFinite(), "a pose that is not finite");
                     }});
  return targets;
}

std::vector<FuzzTarget> imageTargets() {
  const auto read = [](const fs::path& file) { soundImage(readColourImage(file)); };
  return {{"png", "i.png",
           [](const fs::path& folder) {
             return written(folder / "g.png", [](const fs::path& file) {
               writePng(file, gradientImage(31, 17), Overwrite::Refuse, {{"Comment", "gradient"}});
             });
           },
           read},
          {"jpeg", "i.jpg", [](const fs::path&) { return smallJpeg(); }, read}};
}

}  // namespace

std::vector<FuzzTarget> scanTargets() {
  std::vector<FuzzTarget> all;
  for (auto&& some : {rasterTargets(), depthTargets(), imageTargets()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace falciform::test
