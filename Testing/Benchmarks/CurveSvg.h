#pragma once
#include <string>
#include <vector>

namespace falciform::bench {

/// One method in one panel.
struct Curve {
  std::string name;
  std::vector<double> x;       ///< ascending
  std::vector<double> solid;   ///< shares in [0, 1] at x, drawn solid with dots
  std::vector<double> dashed;  ///< the same, dashed
};
struct CurvePanel {
  std::string title, axis;
  std::vector<Curve> curves;
};

/// Panels two abreast on a common axis from 0 to 100 %, the legend on top. `solidMeans`, `dashedMeans`: for
/// the legend.
[[nodiscard]] std::string curvesSvg(const std::vector<CurvePanel>& panels, const std::string& solidMeans,
                                    const std::string& dashedMeans);

}  // namespace falciform::bench
