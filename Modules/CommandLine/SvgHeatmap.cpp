#include "Modules/CommandLine/SvgHeatmap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/SlicerXml.h"

namespace falciform::commandline {

namespace {

constexpr double kCell = 46, kLeft = 96, kTop = 64, kFoot = 56, kBar = 240;

constexpr char kStyle[] = R"(
.cohort-matrix { --ink: #1c2126; --soft: #57606a; --ground: #ffffff; }
@media (prefers-color-scheme: dark) { .cohort-matrix { --ink: #e6e9ec; --soft: #9aa5b1; --ground: #15191d; } }
@media print { .cohort-matrix { --ink: #000; --soft: #444; --ground: #fff; } }
.cohort-matrix text { font: 13px system-ui, "Segoe UI", "DejaVu Sans", sans-serif; fill: var(--ink); text-anchor: middle; }
.cohort-matrix .soft { fill: var(--soft); font-size: 12px; } .cohort-matrix .left { text-anchor: end; }
.cohort-matrix .group { font-weight: 600; } .cohort-matrix .dark { fill: #1c2126; } .cohort-matrix .light { fill: #fff; }
.cohort-matrix .ground { fill: var(--ground); } .cohort-matrix .frame { fill: none; stroke: var(--ink); stroke-width: 2; }
)";

using Colour = std::array<double, 3>;
constexpr Colour kBlue{0, 114, 178}, kWhite{255, 255, 255}, kOrange{213, 94, 0};  // Okabe and Ito

std::string colourOf(double value) {
  const Colour& end = value < 0 ? kBlue : kOrange;
  const double share = std::clamp(std::abs(value), 0.0, 1.0);
  std::string text = "rgb(";
  for (std::size_t k = 0; k < 3; ++k)
    text += fixed(kWhite[k] + share * (end[k] - kWhite[k]), 0) + (k < 2 ? "," : ")");
  return text;
}

std::string number(double value) { return fixed(value, 1); }

std::string text(double x, double y, const std::string& style, const std::string& words) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" class=\"" + style + "\">" + escaped(words) +
         "</text>\n";
}

std::string square(double x, double y, double width, double height, const std::string& paint) {
  return "<rect x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\"" + number(width) + "\" height=\"" +
         number(height) + "\" " + paint + "/>\n";
}

/// Cases by group, those in none last.
std::vector<Index> byGroup(const Cohort& cohort) {
  std::vector<Index> order(cohort.cases.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto group = [&](Index i) {
    const int g = cohort.groupOf[static_cast<std::size_t>(i)];
    return g < 0 ? static_cast<int>(cohort.groups.size()) : g;
  };
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return group(a) < group(b); });
  return order;
}

std::string cellsSvg(const Cohort& cohort, const std::vector<Index>& order) {
  std::string svg;
  for (std::size_t r = 0; r < order.size(); ++r)
    for (std::size_t c = 0; c < order.size(); ++c) {
      const double value = cohort.correlation(order[r], order[c]);
      const double x = kLeft + kCell * static_cast<double>(c), y = kTop + kCell * static_cast<double>(r);
      svg += square(x, y, kCell - 1, kCell - 1, "fill=\"" + colourOf(value) + "\"");
      if (r != c)
        svg += text(x + kCell / 2, y + kCell / 2 + 4, value < -0.6 ? "light" : "dark", fixed(value, 2));
    }
  return svg;
}

std::string namesSvg(const Cohort& cohort, const std::vector<Index>& order) {
  std::string svg;
  for (std::size_t r = 0; r < order.size(); ++r) {
    const std::string& name = cohort.cases[static_cast<std::size_t>(order[r])];
    const double middle = kCell * (static_cast<double>(r) + 0.5);
    const auto shown = [&](std::size_t most) {
      return name.size() <= most ? name : name.substr(0, most - 2) + "..";
    };
    svg +=
        text(kLeft - 8, kTop + middle + 4, "left", shown(11)) + text(kLeft + middle, kTop - 8, "", shown(6));
  }
  return svg;
}

std::string framesSvg(const Cohort& cohort, const std::vector<Index>& order) {
  std::string svg;
  std::size_t begin = 0;
  while (begin < order.size()) {
    const int group = cohort.groupOf[static_cast<std::size_t>(order[begin])];
    std::size_t end = begin;
    while (end < order.size() && cohort.groupOf[static_cast<std::size_t>(order[end])] == group) ++end;
    const double at = kCell * static_cast<double>(begin), size = kCell * static_cast<double>(end - begin);
    if (group >= 0) svg += square(kLeft + at - 0.5, kTop + at - 0.5, size, size, "class=\"frame\"");
    svg += text(kLeft + at + size / 2, kTop - 30, group < 0 ? "soft" : "group",
                group < 0 ? "no group" : cohort.groups[static_cast<std::size_t>(group)]);
    begin = end;
  }
  return svg;
}

std::string barSvg(double top) {
  constexpr int steps = 41;
  std::string svg;
  for (int i = 0; i < steps; ++i)
    svg += square(kLeft + kBar * i / steps, top, kBar / steps + 0.5, 12,
                  "fill=\"" + colourOf(2.0 * i / (steps - 1) - 1) + "\"");
  for (int i = -1; i <= 1; ++i) svg += text(kLeft + kBar * (i + 1) / 2, top + 27, "soft", std::to_string(i));
  return svg + text(kLeft + kBar + 80, top + 11, "soft", "correlation");
}

}  // namespace

std::string correlationSvg(const Cohort& cohort) {
  const std::vector<Index> order = byGroup(cohort);
  const double size = kCell * static_cast<double>(order.size());
  const double width = kLeft + std::max(size, kBar + 130) + 16, height = kTop + size + kFoot;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cohort-matrix\" viewBox=\"0 0 " + number(width) +
         " " + number(height) + "\" style=\"max-width: " + number(1.2 * width) +
         "px\" role=\"img\" aria-label=\"Correlation of the cases\">\n<style>" + kStyle + "</style>\n" +
         square(0, 0, width, height, "class=\"ground\"") + cellsSvg(cohort, order) + namesSvg(cohort, order) +
         framesSvg(cohort, order) + barSvg(kTop + size + 16) + "</svg>\n";
}

}  // namespace falciform::commandline
