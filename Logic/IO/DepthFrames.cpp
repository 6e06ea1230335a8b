#include "Logic/IO/DepthFrames.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <memory>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DepthCamera.h"
#include "Logic/IO/ImageFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/RangeGrid.h"
#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// The first of these names that is a file in the folder; empty if none is.
fs::path firstIn(const fs::path& folder, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (isFile(folder / name)) return folder / name;
  return {};
}

/// `text` with "depth" replaced by each of `words`; empty if it holds none.
std::vector<std::string> renamed(const std::string& text, std::initializer_list<const char*> words) {
  std::vector<std::string> names;
  const std::size_t at = lower(text).find("depth");
  for (const char* word : words)
    if (at != std::string::npos) names.push_back(text.substr(0, at) + word + text.substr(at + 5));
  return names;
}

fs::path onlyCalibration(const fs::path& folder) {
  fs::path found;
  int count = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored))
    if (entry.path().extension() == ".calib") {
      found = entry.path();
      ++count;
    }
  return count == 1 ? found : fs::path();
}

fs::path cameraBeside(const fs::path& depth) {
  const fs::path folder = fs::absolute(depth).parent_path();
  for (const fs::path& place : {folder, folder.parent_path()}) {
    const fs::path found =
        firstIn(place, {depth.stem().string() + ".json", "camera_intrinsic.json", "intrinsics.json",
                        "camera_intrinsics.json", "camera.json", "camera.txt"});
    if (!found.empty()) return found;
    if (const fs::path calibration = onlyCalibration(place); !calibration.empty()) return calibration;
  }
  return {};
}

fs::path colourBeside(const fs::path& depth) {
  const fs::path folder = fs::absolute(depth).parent_path();
  const std::string stem = depth.stem().string();
  std::vector<std::string> stems = renamed(stem, {"color", "colour", "rgb"});
  for (const std::string& other : stems)
    if (const fs::path found = firstIn(folder, {other + ".png", other + ".jpg"}); !found.empty())
      return found;
  stems.push_back(stem);
  for (const std::string& sister : renamed(folder.filename().string(), {"color", "colour", "rgb"}))
    for (const std::string& other : stems)
      if (const fs::path found = firstIn(folder.parent_path() / sister, {other + ".png", other + ".jpg"});
          !found.empty())
        return found;
  return {};
}

fs::path poseBeside(const fs::path& depth) {
  const fs::path folder = fs::absolute(depth).parent_path();
  const std::string stem = depth.stem().string();
  std::vector<std::string> names{stem + "_pose.txt", stem + "_pose.tfm", stem + "_pose.json"};
  for (const std::string& other : renamed(stem, {"pose"}))
    names.insert(names.end(), {other + ".txt", other + ".tfm", other + ".json"});
  if (lower(stem).starts_with("rgbd")) names.push_back("polaris" + stem.substr(4) + ".xml");
  return firstIn(folder, names);
}

struct Frame {
  DepthImage depth;
  std::shared_ptr<const ColourImage> colour;
};

Frame readRgbd(const fs::path& file) {
  constexpr std::size_t kHead = 8, kPixel = 6;
  const std::string bytes = readTextFile(file), name = file.filename().string();
  const auto at = [&bytes]<class T>(std::size_t place, T value) {
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
  };
  if (bytes.size() < kHead) throw InputError(name + " is truncated; copy or export it again");
  const auto width = at(0, std::int32_t{}), height = at(4, std::int32_t{});
  if (width < 1 || height < 1 ||
      static_cast<double>(kPixel) * width * height + double{kHead} != static_cast<double>(bytes.size()))
    throw InputError(name + " announces " + std::to_string(width) + " x " + std::to_string(height) +
                     " pixels, and has not the " + std::to_string(kPixel) +
                     " bytes for each; copy or export it again");
  Frame frame{{width, height, {}}, nullptr};
  ColourImage colours{width, height, {}};
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  frame.depth.depth.reserve(pixels);
  colours.rgb.reserve(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::size_t pixel = kHead + kPixel * i;
    for (std::size_t k = 0; k < 3; ++k) colours.rgb.push_back(static_cast<std::uint8_t>(bytes[pixel + k]));
    frame.depth.depth.push_back(at(pixel + 4, std::uint16_t{}));
  }
  if (std::any_of(colours.rgb.begin(), colours.rgb.end(), [](std::uint8_t c) { return c > 0; }))
    frame.colour = std::make_shared<const ColourImage>(std::move(colours));
  return frame;
}

/// A photograph of another resolution is taken if it has the same shape.
void checkColour(const Frame& frame, const std::string& name) {
  if (!frame.colour) return;
  const double ratio = static_cast<double>(frame.colour->width) * frame.depth.height /
                       (static_cast<double>(frame.colour->height) * frame.depth.width);
  if (ratio < 0.99 || ratio > 1.01)
    throw InputError(name + " is " + std::to_string(frame.colour->width) + " x " +
                     std::to_string(frame.colour->height) + " pixels, and the depths are " +
                     std::to_string(frame.depth.width) + " x " + std::to_string(frame.depth.height) +
                     "; give the colours as seen from the depth camera");
}

void place(const Frame& frame, const DepthCamera& camera, Surface& surface, RangeGrid& grid) {
  const auto seen = std::count_if(frame.depth.depth.begin(), frame.depth.depth.end(),
                                  [](std::uint16_t depth) { return depth > 0; });
  surface.points.resize(seen, 3);
  if (frame.colour) surface.textureAt.resize(seen, 2);
  grid = {frame.depth.height, frame.depth.width, std::vector<int>(frame.depth.depth.size(), -1)};
  int next = 0;
  std::size_t pixel = 0;
  for (int v = 0; v < grid.rows; ++v)
    for (int u = 0; u < grid.columns; ++u, ++pixel) {
      if (frame.depth.depth[pixel] == 0) continue;
      const double z = frame.depth.depth[pixel] / camera.unitsPerMm;
      surface.points.row(next) << (u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z;
      if (frame.colour)
        surface.textureAt.row(next) << static_cast<float>((u + 0.5) / grid.columns),
            static_cast<float>(1 - (v + 0.5) / grid.rows);
      grid.point[pixel] = next++;
    }
}

}  // namespace

bool isDepthFrame(const fs::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".rgbd" || (extension == ".png" && isDepthImage(file));
}

DepthFrameFiles depthFrameBeside(const fs::path& depth, const fs::path& camera) {
  DepthFrameFiles files{depth, {}, camera.empty() ? cameraBeside(depth) : camera, poseBeside(depth)};
  if (lower(depth.extension().string()) == ".png") files.colour = colourBeside(depth);
  if (files.camera.empty())
    throw InputError(depth.filename().string() + " holds depths, and its camera is not known; put " +
                     depth.stem().string() +
                     R"(.json beside it: {"fx": 895.2, "fy": 893.8, "cx": 319.5, "cy": 239.5, )" +
                     R"("depth_scale": 1000})");
  return files;
}

RawSurface readDepthFrame(const DepthFrameFiles& files) {
  const std::string name = files.depth.filename().string();
  const bool packed = lower(files.depth.extension().string()) == ".rgbd";
  Frame frame = packed ? readRgbd(files.depth) : Frame{readDepthImage(files.depth), nullptr};
  if (!files.colour.empty()) {
    frame.colour = std::make_shared<const ColourImage>(readColourImage(files.colour));
    checkColour(frame, files.colour.filename().string());
  }
  const DepthCamera camera = readDepthCamera(files.camera);
  if (camera.width > 0 && camera.height > 0 &&
      (camera.width != frame.depth.width || camera.height != frame.depth.height))
    throw InputError(files.camera.filename().string() + " belongs to images of " +
                     std::to_string(camera.width) + " x " + std::to_string(camera.height) + ", and " + name +
                     " is " + std::to_string(frame.depth.width) + " x " + std::to_string(frame.depth.height) +
                     "; give the camera of this image");
  RawSurface raw;
  RangeGrid grid;
  place(frame, camera, raw.surface, grid);
  raw.space = "scanner";
  if (raw.surface.size() == 0) return raw;
  if (frame.colour) {
    raw.surface.texture = frame.colour;
    raw.surface.colours = coloursAt(*frame.colour, raw.surface.textureAt);
  }
  joinRaster(raw.surface, grid, Vector3d::Zero());
  if (!files.pose.empty()) raw.surface = transformed(raw.surface, readCameraPose(files.pose), "tracker");
  if (!files.pose.empty()) raw.space = "tracker";
  return raw;
}

}  // namespace falciform
