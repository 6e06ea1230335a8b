#include "Testing/Rendering/Baseline.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace falciform::test {

namespace {

std::filesystem::path baselineFolder() {
  return std::filesystem::path(FALCIFORM_SOURCE_DIR) / "Testing" / "Rendering" / "Baselines";
}

std::filesystem::path savedForReview(const RenderedImage& image, const std::string& name) {
  const auto folder = std::filesystem::temp_directory_path() / "falciform-rendering";
  std::filesystem::create_directories(folder);
  savePng(image, folder / (name + ".png"), Overwrite::Replace);
  return folder / (name + ".png");
}

}  // namespace

testing::AssertionResult matchesBaseline(const RenderedImage& image, const std::string& name) {
  const auto file = baselineFolder() / (name + ".png");
  if (const char* update = std::getenv("FALCIFORM_UPDATE_BASELINES"); update && std::string(update) == "1") {
    savePng(image, file, Overwrite::Replace);
    return testing::AssertionSuccess();
  }
  if (!std::filesystem::exists(file))
    return testing::AssertionFailure()
           << "no baseline " << file << "; the picture is " << savedForReview(image, name)
           << ": if it is right, run again with FALCIFORM_UPDATE_BASELINES=1";
  const RenderedImage wanted = readPng(file);
  if (wanted.width != image.width || wanted.height != image.height)
    return testing::AssertionFailure() << file << " is " << wanted.width << " x " << wanted.height
                                       << ", the picture " << image.width << " x " << image.height;
  double sum = 0;
  std::size_t off = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    int worst = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int difference = std::abs(static_cast<int>(image.rgb[c]) - static_cast<int>(wanted.rgb[c]));
      sum += difference;
      worst = std::max(worst, difference);
    }
    off += worst > 40;
  }
  const double mean = sum / static_cast<double>(image.rgb.size());
  const double share = 3.0 * static_cast<double>(off) / static_cast<double>(image.rgb.size());
  if (mean < 2 && share < 0.02) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "differs from " << file << ": mean " << mean << " of 255, "
                                     << 100 * share << " % of pixels by more than 40. The picture is "
                                     << savedForReview(image, name);
}

int countColour(const RenderedImage& image, const Eigen::Vector3d& colour, int tolerance) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    bool near = true;
    for (int c = 0; c < 3; ++c)
      near = near && std::abs(image.rgb[i + static_cast<std::size_t>(c)] - 255 * colour[c]) <= tolerance;
    count += near;
  }
  return count;
}

}  // namespace falciform::test
