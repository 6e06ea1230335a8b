#pragma once
#include <vector>

#include "Logic/Core/Results.h"
#include "Widgets/Rendering/ChartArea.h"

namespace falciform {

/// RMS residual and patch weight, or where that stays the same the largest motion of a scan point, over the
/// iterations of a registration; may be shown again as it runs.
class ConvergencePresenter {
 public:
  ConvergencePresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour);

  void show(const std::vector<IterationRecord>& history);

 private:
  ChartArea area_;
  double lineWidthPx_;
};

}  // namespace falciform
