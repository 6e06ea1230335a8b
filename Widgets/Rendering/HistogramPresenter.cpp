#include "Widgets/Rendering/HistogramPresenter.h"

#include <algorithm>
#include <cstdio>

#include "Widgets/Rendering/Histogram.h"
#include "Widgets/Rendering/ScalarMap.h"

namespace falciform {

namespace {

/// The outline of the bars, in per cent.
std::vector<std::pair<double, double>> outline(const Histogram& histogram) {
  std::vector<std::pair<double, double>> line{{histogram.low, 0.0}};
  for (std::size_t i = 0; i < histogram.shares.size(); ++i) {
    const double left = histogram.low + static_cast<double>(i) * histogram.width;
    line.emplace_back(left, 100 * histogram.shares[i]);
    line.emplace_back(left + histogram.width, 100 * histogram.shares[i]);
  }
  line.emplace_back(line.back().first, 0.0);
  return line;
}

std::string figures(const char* side, const DistanceStatistics& statistics) {
  if (statistics.count == 0) return std::string(side) + ": no covered place";
  char text[160];
  std::snprintf(text, sizeof text, "%s: mean %+.1f mm, SD %.1f mm, 95 %% within %.1f mm", side,
                statistics.mean, statistics.sd, statistics.p95Absolute);
  return text;
}

VectorXd distancesOf(const Surface& surface) {
  const auto found = surface.arrays.find(kSignedDistance);
  return found == surface.arrays.end() ? VectorXd() : found->second;
}

}  // namespace

HistogramPresenter::HistogramPresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour)
    : area_(renderer, textPx, textColour), lineWidthPx_(std::max(1.0, 0.14 * textPx)) {}

void HistogramPresenter::show(const DistanceMap& map) {
  const Vector3d blue(0.0, 0.45, 0.70), vermilion(0.84, 0.37, 0.0), grey(0.5, 0.5, 0.5);
  const ScalarMap range = symmetricMap(kSignedDistance, "", "mm", {&map.preop, &map.scan});
  const double width = binWidth(range.low, range.high);
  const Histogram preop = histogramOf(distancesOf(map.preop), range.low, range.high, width);
  const Histogram scan = histogramOf(distancesOf(map.scan), range.low, range.high, width);
  double top = 0;
  for (const Histogram* side : {&preop, &scan}) top = std::max(top, *std::ranges::max_element(side->shares));
  top = top > 0 ? 100 * top : 1;

  area_.chart()->ClearPlots();
  area_.addLine("", {{0, 0}, {0, 1.15 * top}}, grey, 0.5 * lineWidthPx_);
  area_.addLine("pre-operative surface", outline(preop), blue, lineWidthPx_);
  area_.addLine("scan", outline(scan), vermilion, lineWidthPx_);
  area_.setTitle(figures("Pre-operative surface", map.preopAll) + "\n" + figures("Scan", map.scanAll));
  area_.setAxisTitle(vtkAxis::BOTTOM, "Signed distance (mm): positive where the scan lies outside");
  area_.setAxisTitle(vtkAxis::LEFT, "Share of covered places (%)");
  area_.setRange(vtkAxis::LEFT, 0, 1.15 * top);
  area_.setRange(vtkAxis::BOTTOM, range.low, range.high);
}

}  // namespace falciform
