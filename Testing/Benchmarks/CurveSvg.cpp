#include "Testing/Benchmarks/CurveSvg.h"

#include <array>
#include <cstdio>

namespace falciform::bench {

namespace {

constexpr double kPanelWidth = 400, kPanelHeight = 250, kLeft = 54, kRight = 14, kTop = 34, kBottom = 44,
                 kLegend = 52;
// Colours that the colour-blind tell apart (Okabe and Ito).
constexpr std::array<const char*, 3> kColours{"#0072b2", "#d55e00", "#009e73"};
constexpr std::array<double, 3> kWidths{7, 4, 1.5};

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + words +
         "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& style) {
  return "<line x1=\"" + number(x1) + "\" y1=\"" + number(y1) + "\" x2=\"" + number(x2) + "\" y2=\"" +
         number(y2) + "\" " + style + "/>\n";
}

/// Each method's line is thinner than the one before, which it is drawn on, so that curves that coincide are
/// seen.
std::string stroke(std::size_t method, bool dashed) {
  const double width = dashed ? 1.5 : kWidths[method % kWidths.size()];
  return std::string("fill=\"none\" stroke=\"") + kColours[method % kColours.size()] + "\" stroke-width=\"" +
         number(width) + "\"" + (dashed ? " stroke-dasharray=\"5 4\"" : "");
}

/// Where a panel's values lie on the page.
struct Frame {
  double left, top, low, high;
  [[nodiscard]] double x(double value) const {
    return left + kLeft + (value - low) / (high - low) * (kPanelWidth - kLeft - kRight);
  }
  [[nodiscard]] double y(double share) const {
    return top + kTop + (1 - share) * (kPanelHeight - kTop - kBottom);
  }
};

std::string polyline(const Frame& f, const Curve& curve, const std::vector<double>& shares,
                     std::size_t method, bool dashed) {
  std::string points, dots;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const std::string x = number(f.x(curve.x[i])), y = number(f.y(shares[i]));
    points += x + "," + y + " ";
    dots += "<circle cx=\"" + x + "\" cy=\"" + y + "\" r=\"3\" fill=\"" + kColours[method % kColours.size()] +
            "\"/>\n";
  }
  return "<polyline points=\"" + points + "\" " + stroke(method, dashed) + "/>\n" + (dashed ? "" : dots);
}

std::string panelSvg(const CurvePanel& panel, double left, double top) {
  const Frame f{left, top, panel.curves.front().x.front(), panel.curves.front().x.back()};
  std::string svg =
      text(left + kLeft, top + 20, "start", "<tspan font-weight=\"600\">" + panel.title + "</tspan>");
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    svg += line(f.x(f.low), f.y(share), f.x(f.high), f.y(share), "stroke=\"#d8dee4\"") +
           text(f.x(f.low) - 6, f.y(share) + 4, "end", number(100 * share) + " %");
  for (const double x : panel.curves.front().x)
    svg += line(f.x(x), f.y(0), f.x(x), f.y(0) + 4, "stroke=\"#57606a\"") +
           text(f.x(x), f.y(0) + 17, "middle", number(x));
  svg += text(0.5 * (f.x(f.low) + f.x(f.high)), f.y(0) + 35, "middle", panel.axis);
  for (const bool dashed : {false, true})
    for (std::size_t m = 0; m < panel.curves.size(); ++m)
      svg += polyline(f, panel.curves[m], dashed ? panel.curves[m].dashed : panel.curves[m].solid, m, dashed);
  return svg;
}

}  // namespace

std::string curvesSvg(const std::vector<CurvePanel>& panels, const std::string& solidMeans,
                      const std::string& dashedMeans) {
  const double width = 2 * kPanelWidth,
               height = kLegend + kPanelHeight * static_cast<double>((panels.size() + 1) / 2);
  std::string svg =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width) + " " + number(height) +
      "\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"12\" fill=\"#1c2126\">\n<rect width=\"" +
      number(width) + "\" height=\"" + number(height) + "\" fill=\"#ffffff\"/>\n";
  double x = kLeft;
  for (std::size_t m = 0; m < panels.front().curves.size(); ++m, x += 165)
    svg +=
        line(x, 16, x + 24, 16, stroke(m, false)) + text(x + 30, 20, "start", panels.front().curves[m].name);
  svg += line(kLeft, 38, kLeft + 24, 38, "stroke=\"#1c2126\" stroke-width=\"2\"") +
         text(kLeft + 30, 42, "start", solidMeans) +
         line(kLeft + 330, 38, kLeft + 354, 38,
              "stroke=\"#1c2126\" stroke-width=\"2\" stroke-dasharray=\"5 4\"") +
         text(kLeft + 360, 42, "start", dashedMeans);
  for (std::size_t p = 0; p < panels.size(); ++p)
    svg += panelSvg(panels[p], p % 2 == 0 ? 0 : kPanelWidth,
                    kLegend + kPanelHeight * static_cast<double>(p / 2));
  return svg + "</svg>\n";
}

}  // namespace falciform::bench
