#include "Logic/IO/DicomStack.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "Logic/Core/Median.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

constexpr double kSpacingShare = 0.02,
                 kSpacingMm = 0.02;  ///< positions are written with two and more decimals
constexpr double kShiftMm = 0.1;     ///< of slices sideways from the line through them
constexpr double kLongestGapMm = 10, kLongestGapSpacings = 4, kMostMadeUp = 0.2;
constexpr std::size_t kGapsNamed = 5;
constexpr double kMostSlicesPerFrame = 64;  ///< of a segmentation: bounds what a small file can ask for

std::string mm(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

struct Line {
  std::vector<double> along;  ///< mm along the normal, of the sorted slices
  Vector3d step;              ///< from the first slice to the last, for each mm along the normal
  double farthestMm = 0;      ///< of a slice from that line
};

Line lineThrough(const std::vector<Vector3d>& positions, const std::vector<std::size_t>& order,
                 const Vector3d& normal) {
  Line line;
  for (const std::size_t i : order) line.along.push_back(positions[i].dot(normal));
  const Vector3d& first = positions[order.front()];
  const double length = line.along.back() - line.along.front();
  line.step = length > 0 ? Vector3d((positions[order.back()] - first) / length) : normal;
  for (std::size_t s = 0; s < order.size(); ++s) {
    const Vector3d onLine = first + line.step * (line.along[s] - line.along.front());
    line.farthestMm = std::max(line.farthestMm, (positions[order[s]] - onLine).norm());
  }
  return line;
}

std::vector<std::size_t> sortedAlong(const std::vector<Vector3d>& positions, const Vector3d& normal) {
  std::vector<std::size_t> order(positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return positions[a].dot(normal) < positions[b].dot(normal);
  });
  return order;
}

void setGrid(DicomStack& stack, const Vector3d& origin, const Eigen::Matrix<double, 3, 2>& axes,
             const Eigen::Vector2d& spacingMm, const Vector3d& step) {
  stack.worldFromIndex.block<3, 1>(0, 0) = axes.col(0) * spacingMm.x();
  stack.worldFromIndex.block<3, 1>(0, 1) = axes.col(1) * spacingMm.y();
  stack.worldFromIndex.block<3, 1>(0, 2) = step;
  stack.worldFromIndex.block<3, 1>(0, 3) = origin;
}

bool linesUp(DicomStack& stack, const Line& line, const Vector3d& normal) {
  if (line.farthestMm > kShiftMm) {
    stack.refusal = "its slices are shifted sideways against each other by up to " + mm(line.farthestMm) +
                    " mm, and not evenly; they are no one volume: export the series again";
    return false;
  }
  const double tilt = std::acos(std::clamp(line.step.normalized().dot(normal), -1.0, 1.0)) * 180 / EIGEN_PI;
  if (tilt > 0.05)
    stack.warnings.push_back(
        "the gantry was tilted by " + mm(tilt) +
        " degrees: the volume is sheared as its slices lie in the patient, and not resampled");
  return true;
}

/// Warns of, or refuses, distances between slices that differ from `spacing`.
void judgeGaps(DicomStack& stack, const Line& line, double spacing) {
  std::string places;
  std::size_t gaps = 0, missing = 0;
  double longest = 0;
  for (std::size_t s = 0; s + 1 < line.along.size(); ++s) {
    const double gap = line.along[s + 1] - line.along[s];
    if (std::abs(gap - spacing) <= std::max(kSpacingShare * spacing, kSpacingMm)) continue;
    longest = std::max(longest, gap);
    missing += static_cast<std::size_t>(std::max(0.0, std::round(gap / spacing) - 1));
    if (++gaps <= kGapsNamed)
      places += (places.empty() ? "" : ", ") + mm(gap) + " mm after slice " + std::to_string(s + 1);
  }
  if (gaps == 0) return;
  stack.resampled = true;
  if (gaps > kGapsNamed) places += " and " + std::to_string(gaps - kGapsNamed) + " more";
  const std::string found =
      "its slices are not evenly spaced: " + mm(spacing) + " mm apart, but " + places +
      (missing > 0 ? " (" + std::to_string(missing) + " slices seem to be missing)" : "");
  const double madeUp = static_cast<double>(missing) / static_cast<double>(line.along.size() + missing);
  if (longest > std::max(kLongestGapMm, spacing) || longest > kLongestGapSpacings * spacing ||
      madeUp > kMostMadeUp)
    stack.refusal = found + "; too much would have to be made up: export the whole series again";
  else
    stack.warnings.push_back(found + "; what lies between them was interpolated on an even grid");
}

}  // namespace

DicomStack stackSlices(const std::vector<Vector3d>& positions, const Eigen::Matrix<double, 3, 2>& axes,
                       const Eigen::Vector2d& spacingMm) {
  DicomStack stack;
  const Vector3d normal = axes.col(0).cross(axes.col(1));
  for (const std::size_t i : sortedAlong(positions, normal))
    if (stack.order.empty() || (positions[i] - positions[stack.order.back()]).dot(normal) > kSamePlaceMm)
      stack.order.push_back(i);
  stack.count = static_cast<int>(stack.order.size());
  if (stack.order.size() < 2) {
    stack.refusal = "it is a single slice; a volume needs two and more (their thickness is no spacing)";
    return stack;
  }
  const Line line = lineThrough(positions, stack.order, normal);
  if (!linesUp(stack, line, normal)) return stack;
  std::vector<double> gaps;
  for (std::size_t s = 0; s + 1 < line.along.size(); ++s) gaps.push_back(line.along[s + 1] - line.along[s]);
  const double length = line.along.back() - line.along.front();
  const double spacing = medianInPlace(gaps);
  judgeGaps(stack, line, spacing);
  if (!stack.refusal.empty()) return stack;
  if (stack.resampled) stack.count = static_cast<int>(std::round(length / spacing)) + 1;
  const double step = length / (stack.count - 1);
  for (std::size_t s = 0; s < line.along.size(); ++s) {
    const double exact = (line.along[s] - line.along.front()) / step;
    stack.index.push_back(stack.resampled ? exact : static_cast<double>(s));
  }
  setGrid(stack, positions[stack.order.front()], axes, spacingMm, line.step * step);
  return stack;
}

DicomStack stackSegments(const std::vector<Vector3d>& positions, const Eigen::Matrix<double, 3, 2>& axes,
                         const Eigen::Vector2d& spacingMm, double betweenSlicesMm) {
  DicomStack stack;
  const Vector3d normal = axes.col(0).cross(axes.col(1));
  stack.order = sortedAlong(positions, normal);
  const Line line = lineThrough(positions, stack.order, normal);
  if (!linesUp(stack, line, normal)) return stack;
  const double length = line.along.back() - line.along.front();
  double smallest = length;
  for (std::size_t s = 0; s + 1 < line.along.size(); ++s)
    if (const double gap = line.along[s + 1] - line.along[s]; gap > kSamePlaceMm)
      smallest = std::min(smallest, gap);
  double spacing = betweenSlicesMm > kSamePlaceMm ? betweenSlicesMm : smallest;
  if (!(spacing > kSamePlaceMm)) {
    stack.refusal =
        "its segments lie in one slice, and it does not say how far apart slices are; export it again "
        "with SpacingBetweenSlices";
    return stack;
  }
  if (length / spacing > kMostSlicesPerFrame * static_cast<double>(positions.size())) {
    stack.refusal = "the number of its slices would be " + shortText(length / spacing) +
                    ", which cannot be; export it again";
    return stack;
  }
  stack.count = static_cast<int>(std::round(length / spacing)) + 1;
  if (stack.count > 1) spacing = length / (stack.count - 1);
  for (const double along : line.along) {
    const double exact = (along - line.along.front()) / spacing, nearest = std::round(exact);
    if (std::abs(exact - nearest) * spacing > std::max(kSpacingShare * spacing, kSpacingMm)) {
      stack.refusal = "its frames do not lie on an even grid of " + mm(spacing) + " mm; export it again";
      return stack;
    }
    stack.index.push_back(nearest);
  }
  setGrid(stack, positions[stack.order.front()], axes, spacingMm, line.step * spacing);
  return stack;
}

}  // namespace falciform
