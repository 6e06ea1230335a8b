#include "Widgets/Rendering/ScalarMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace falciform {

namespace {

/// ColorBrewer RdYlBu, 11 classes, low to high (C. Brewer, Apache 2.0).
const std::array<Vector3d, 11>& divergingColours() {
  static const std::array<Vector3d, 11> colours{
      Vector3d(49, 54, 149),   Vector3d(69, 117, 180),  Vector3d(116, 173, 209), Vector3d(171, 217, 233),
      Vector3d(224, 243, 248), Vector3d(255, 255, 191), Vector3d(254, 224, 144), Vector3d(253, 174, 97),
      Vector3d(244, 109, 67),  Vector3d(215, 48, 39),   Vector3d(165, 0, 38)};
  return colours;
}

/// Matplotlib's viridis, 10 of its 256 colours (S. van der Walt, N. Smith, CC0).
const std::array<Vector3d, 10>& sequentialColours() {
  static const std::array<Vector3d, 10> colours{
      Vector3d(68, 1, 84),    Vector3d(72, 40, 120),  Vector3d(62, 74, 137),  Vector3d(49, 104, 142),
      Vector3d(38, 130, 142), Vector3d(31, 158, 137), Vector3d(53, 183, 121), Vector3d(109, 205, 89),
      Vector3d(180, 222, 44), Vector3d(253, 231, 37)};
  return colours;
}

std::span<const Vector3d> coloursOf(Palette palette) {
  if (palette == Palette::Sequential) return sequentialColours();
  return divergingColours();
}

double roundUp(double value) {
  if (!(value > 0)) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= step * decade * (1 + 1e-9)) return step * decade;
  return 10 * decade;
}

}  // namespace

Vector3d colourOf(const ScalarMap& map, double value) {
  if (std::isnan(value)) return kNoValueColour;
  if (std::abs(value) < map.threshold) return kBelowThresholdColour;
  const std::span<const Vector3d> colours = coloursOf(map.palette);
  if (value < map.low || value > map.high) {
    if (map.outOfRange == OutOfRange::Grey) return kOffScaleColour;
    return (value < map.low ? colours.front() : colours.back()) / 255.0 * 0.45;
  }
  const bool diverging = map.palette == Palette::Diverging;
  const double high = diverging ? std::max(std::abs(map.low), std::abs(map.high)) : map.high;
  const double low = diverging ? -high : map.low;
  const double span = high > low ? high - low : 1;
  const double at = (value - low) / span * static_cast<double>(colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), colours.size() - 2);
  const double share = at - static_cast<double>(below);
  return ((1 - share) * colours[below] + share * colours[below + 1]) / 255.0;
}

ScalarMap symmetricMap(const std::string& array, const std::string& title, const std::string& unit,
                       const std::vector<const Surface*>& surfaces) {
  double largest = 0;
  for (const Surface* surface : surfaces)
    if (const auto found = surface->arrays.find(array); found != surface->arrays.end())
      for (const double value : found->second)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  const double end = roundUp(largest);
  return {array, title, unit, -end, end, OutOfRange::Grey};
}

double symmetricEnd(const VectorXd& values, double share) {
  std::vector<double> sizes;
  for (const double value : values)
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  if (sizes.empty()) return 1;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(sizes.size()))) - 1;
  const auto place = sizes.begin() + std::max<std::ptrdiff_t>(0, rank);
  std::nth_element(sizes.begin(), place, sizes.end());
  return roundUp(*place);
}

ScalarMap magnitudeMap(const std::string& array, const std::string& title, const std::string& unit,
                       double largest) {
  return {array, title, unit, 0, roundUp(largest), OutOfRange::Ends, Palette::Sequential};
}

std::vector<double> tickValues(double low, double high, int atMost) {
  if (!(high > low) || !std::isfinite(high - low)) return {low};
  const double decade = std::pow(10.0, std::floor(std::log10((high - low) / atMost)));
  double step = decade;
  for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0, 20.0}) {
    step = factor * decade;
    if (std::floor(high / step + 1e-9) - std::ceil(low / step - 1e-9) + 1 <= atMost) break;
  }
  std::vector<double> ticks;
  // Counted in whole steps, so that 0 is exactly 0; + 0.0 turns -0 into 0.
  for (double k = std::ceil(low / step - 1e-9); k <= std::floor(high / step + 1e-9); ++k)
    ticks.push_back(k * step + 0.0);
  return ticks;
}

}  // namespace falciform
