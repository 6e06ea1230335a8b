#pragma once
#include <string>
#include <vector>

namespace falciform::commandline {

/// The values of one method, each a success or a failure.
struct HistogramStrip {
  std::string name, note;      ///< left and right above the bars
  std::vector<double> values;  ///< mm
  std::vector<bool> success;
};

/// Histograms one above the other on a common logarithmic axis in mm, successes and failures in two colours,
/// counts on the left of each, a dashed line at `thresholdMm` (0: none). One SVG document that is also fit to
/// stand in a page; follows the reader's light or dark scheme. Texts are escaped.
[[nodiscard]] std::string histogramSvg(const std::string& axis, const std::vector<HistogramStrip>& strips,
                                       double thresholdMm);

}  // namespace falciform::commandline
