#include "Testing/Benchmarks/PressedLiverFiles.h"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace falciform::bench {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr double kFx = 895.227, kFy = 893.826, kCx = 319.5, kCy = 239.5;
constexpr std::size_t kHead = 8, kPixel = 6, kDepthAt = 4;

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class T>
T at(const std::string& bytes, std::size_t place) {
  T value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

Isometry3d readPose(const std::filesystem::path& file) {
  const std::string text = contents(file);
  const std::size_t tag = text.find("<position_camera"), open = text.find('>', tag);
  std::array<double, 7> v{};
  std::istringstream numbers(open == std::string::npos ? "" : text.substr(open + 1));
  for (double& value : v)
    if (!(numbers >> value)) throw std::runtime_error("no camera pose in " + file.string());
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(v[3], v[0], v[1], v[2]).normalized().toRotationMatrix();
  pose.translation() << v[4], v[5], v[6];
  return pose;
}

}  // namespace

Surface readDepthFrame(const std::filesystem::path& depthFile, const std::filesystem::path& poseFile) {
  const std::string bytes = contents(depthFile);
  if (bytes.size() < kHead) throw std::runtime_error("no depth frame: " + depthFile.string());
  const auto width = at<std::int32_t>(bytes, 0), height = at<std::int32_t>(bytes, 4);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (width < 1 || height < 1 || bytes.size() != kHead + kPixel * pixels)
    throw std::runtime_error("no depth frame: " + depthFile.string());
  std::vector<double> seen;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const std::size_t pixel =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
      const double z = at<std::uint16_t>(bytes, kHead + kPixel * pixel + kDepthAt);
      if (z > 0) seen.insert(seen.end(), {(u - kCx) / kFx * z, (v - kCy) / kFy * z, z});
    }
  Surface frame;
  frame.points = transformed(Points(Eigen::Map<Points>(seen.data(), static_cast<Index>(seen.size() / 3), 3)),
                             readPose(poseFile));
  frame.frame = "scanner";
  return frame;
}

Points readNodes(const std::filesystem::path& file) {
  const std::string text = contents(file);
  const std::size_t head = text.find("POINTS ");
  std::istringstream stream(head == std::string::npos ? "" : text.substr(head));
  std::string word, type;
  Index count = 0;
  if (!(stream >> word >> count >> type) || count < 1)
    throw std::runtime_error("no nodes in " + file.string());
  Points nodes(count, 3);
  for (Index i = 0; i < nodes.size(); ++i)
    if (!(stream >> nodes.data()[i])) throw std::runtime_error("nodes are missing in " + file.string());
  return nodes;
}

}  // namespace falciform::bench
