#include "Modules/CommandLine/SvgHistogram.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/SlicerXml.h"

namespace falciform::commandline {

namespace {

constexpr double kWidth = 860, kLeft = 56, kRight = 16, kTop = 30, kStrip = 108, kBars = 72, kFoot = 46;
constexpr int kBinsADecade = 20;

// Colours that the colour-blind tell apart (Okabe and Ito).
constexpr char kStyle[] = R"(
.trial-histogram { --ink: #1c2126; --soft: #57606a; --line: #d8dee4; --good: #0072b2; --bad: #d55e00; --ground: #ffffff; }
@media (prefers-color-scheme: dark) { .trial-histogram { --ink: #e6e9ec; --soft: #9aa5b1; --line: #343c44; --good: #56b4e9;
  --bad: #e69f00; --ground: #15191d; } }
@media print { .trial-histogram { --ink: #000; --soft: #444; --line: #bbb; --good: #0072b2; --bad: #d55e00; --ground: #fff; } }
.trial-histogram text { font: 13px system-ui, "Segoe UI", "DejaVu Sans", sans-serif; fill: var(--ink); }
.trial-histogram .soft { fill: var(--soft); font-size: 12px; } .trial-histogram .name { font-weight: 600; }
.trial-histogram .good { fill: var(--good); } .trial-histogram .bad { fill: var(--bad); } .trial-histogram .ground { fill: var(--ground); }
.trial-histogram line { stroke: var(--line); } .trial-histogram .limit { stroke: var(--soft); stroke-dasharray: 5 4; }
)";

/// The common axis: whole decades that hold all values.
struct LogAxis {
  double low = 0, high = 1;  ///< log10 of mm

  explicit LogAxis(const std::vector<HistogramStrip>& strips, double thresholdMm) {
    double least = thresholdMm > 0 ? thresholdMm : 1, most = least;
    for (const HistogramStrip& strip : strips)
      for (const double value : strip.values) {
        least = std::min(least, std::max(value, 1e-3));  // nothing finer is of interest
        most = std::max(most, value);
      }
    low = std::floor(std::log10(least));
    high = std::max(low + 1, std::ceil(std::log10(most) + 1e-9));
  }
  [[nodiscard]] double x(double mm) const {
    const double at = (std::log10(std::max(mm, 1e-9)) - low) / (high - low);
    return kLeft + std::clamp(at, 0.0, 1.0) * (kWidth - kLeft - kRight);
  }
  [[nodiscard]] int bins() const { return static_cast<int>(std::lround((high - low) * kBinsADecade)); }
  [[nodiscard]] int binOf(double mm) const {
    const double at = (std::log10(std::max(mm, 1e-9)) - low) * kBinsADecade;
    return std::clamp(static_cast<int>(std::floor(at)), 0, bins() - 1);
  }
};

std::string number(double value) { return fixed(value, 1); }

std::string text(double x, double y, const char* anchor, const char* style, const std::string& words) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\" class=\"" +
         style + "\">" + escaped(words) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* style = "") {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" +
         number(y2) + "\" class=\"" + style + "\"/>\n";
}

std::string bar(double x, double width, double from, double to, const char* style) {
  if (to <= from) return "";
  return "<rect x=\"" + number(x) + "\" y=\"" + number(from) + "\" width=\"" + number(width) +
         "\" height=\"" + number(to - from) + "\" class=\"" + style + "\"/>\n";
}

std::string stripSvg(const HistogramStrip& strip, const LogAxis& axis, double base) {
  std::vector<std::array<int, 2>> counts(static_cast<std::size_t>(axis.bins()), {0, 0});
  for (std::size_t i = 0; i < strip.values.size(); ++i)
    if (std::isfinite(strip.values[i]))
      ++counts[static_cast<std::size_t>(axis.binOf(strip.values[i]))][strip.success[i] ? 0 : 1];
  int most = 1;
  for (const auto& [good, bad] : counts) most = std::max(most, good + bad);
  const double unit = kBars / most, width = (kWidth - kLeft - kRight) / axis.bins();
  std::string svg = text(kLeft, base - kBars - 9, "start", "name", strip.name) +
                    text(kWidth - kRight, base - kBars - 9, "end", "soft", strip.note) +
                    text(kLeft - 7, base - kBars + 9, "end", "soft", std::to_string(most)) +
                    text(kLeft - 7, base, "end", "soft", "0");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double x = kLeft + static_cast<double>(i) * width, top = base - counts[i][0] * unit;
    svg += bar(x + 0.5, width - 1, top, base, "good") +
           bar(x + 0.5, width - 1, top - counts[i][1] * unit, top, "bad");
  }
  return svg + line(kLeft, base, kWidth - kRight, base);
}

std::string ticks(const LogAxis& axis, double top, double bottom) {
  std::string svg;
  for (double decade = axis.low; decade <= axis.high; ++decade)
    for (const double step : {1.0, 2.0, 5.0}) {
      const double mm = step * std::pow(10.0, decade);
      if (std::log10(mm) > axis.high + 1e-9) continue;
      if (step == 1) svg += line(axis.x(mm), top, axis.x(mm), bottom);
      svg +=
          line(axis.x(mm), bottom, axis.x(mm), bottom + 5) + text(axis.x(mm), bottom + 18, "middle", "soft",
                                                                  fixed(mm, mm < 0.01  ? 3
                                                                            : mm < 0.1 ? 2
                                                                            : mm < 1   ? 1
                                                                                       : 0));
    }
  return svg;
}

}  // namespace

std::string histogramSvg(const std::string& axisTitle, const std::vector<HistogramStrip>& strips,
                         double thresholdMm) {
  const LogAxis axis(strips, thresholdMm);
  const double bottom = kTop + kStrip * static_cast<double>(strips.size()), height = bottom + kFoot;
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"trial-histogram\" viewBox=\"0 0 " +
                    number(kWidth) + " " + number(height) + "\" role=\"img\" aria-label=\"" +
                    escaped("Histogram: " + axisTitle) + "\">\n<style>" + kStyle + "</style>\n" +
                    bar(0, kWidth, 0, height, "ground");
  svg += bar(kLeft, 12, 8, 20, "good") + text(kLeft + 18, 19, "start", "soft", "success") +
         bar(kLeft + 90, 12, 8, 20, "bad") + text(kLeft + 108, 19, "start", "soft", "failure");
  svg += ticks(axis, kTop, bottom);
  if (thresholdMm > 0)
    svg += line(axis.x(thresholdMm), kTop, axis.x(thresholdMm), bottom, "limit") +
           line(kLeft + 180, 14, kLeft + 200, 14, "limit") +
           text(kLeft + 206, 19, "start", "soft", "limit of success, " + fixed(thresholdMm, 1) + " mm");
  for (std::size_t i = 0; i < strips.size(); ++i)
    svg += stripSvg(strips[i], axis, kTop + kStrip * static_cast<double>(i + 1));
  return svg + text((kLeft + kWidth - kRight) / 2, bottom + 37, "middle", "", axisTitle) + "</svg>\n";
}

}  // namespace falciform::commandline
