#include "Widgets/Rendering/ConvergencePresenter.h"

#include <algorithm>

namespace falciform {

ConvergencePresenter::ConvergencePresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour)
    : area_(renderer, textPx, textColour), lineWidthPx_(std::max(1.0, 0.14 * textPx)) {
  area_.setTitle("Registration: residual and patch weight (fit, not target error)");
  area_.setAxisTitle(vtkAxis::BOTTOM, "Iteration");
  area_.setAxisTitle(vtkAxis::LEFT, "RMS residual (mm)");
  area_.setAxisTitle(vtkAxis::RIGHT, "Patch weight");
}

void ConvergencePresenter::show(const std::vector<IterationRecord>& history) {
  area_.chart()->ClearPlots();
  if (history.empty()) return;
  std::vector<std::pair<double, double>> residual, weight;
  double highest = 0, largest = 1;
  for (const IterationRecord& record : history) {
    residual.emplace_back(record.iteration, record.rmsMm);
    weight.emplace_back(record.iteration, std::max(record.patchWeight, 1e-6));
    highest = std::max(highest, record.rmsMm);
    largest = std::max(largest, record.patchWeight);
  }
  // One iteration is drawn as a short level line.
  if (history.size() == 1) {
    residual.emplace_back(residual.front().first + 1, residual.front().second);
    weight.emplace_back(weight.front().first + 1, weight.front().second);
  }
  area_.addLine("RMS residual (mm)", residual, {0.0, 0.45, 0.70}, lineWidthPx_);
  area_.addLine("patch weight (right)", weight, {0.84, 0.37, 0.0}, lineWidthPx_, true);
  area_.setRange(vtkAxis::BOTTOM, residual.front().first, residual.back().first);
  area_.setRange(vtkAxis::LEFT, 0, highest > 0 ? 1.25 * highest : 1);
  area_.setRange(vtkAxis::RIGHT, 0, 1.25 * largest);
}

}  // namespace falciform
