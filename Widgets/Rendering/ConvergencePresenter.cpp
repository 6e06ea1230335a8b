#include "Widgets/Rendering/ConvergencePresenter.h"

#include <algorithm>

namespace falciform {

ConvergencePresenter::ConvergencePresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour)
    : area_(renderer, textPx, textColour), lineWidthPx_(std::max(1.0, 0.14 * textPx)) {
  area_.setTitle("Registration: convergence (fit, not target error)");
  area_.setAxisTitle(vtkAxis::BOTTOM, "Iteration");
  area_.setAxisTitle(vtkAxis::LEFT, "RMS residual (mm)");
}

void ConvergencePresenter::show(const std::vector<IterationRecord>& history) {
  area_.chart()->ClearPlots();
  if (history.empty()) return;
  // A weight that stays the same says nothing; how far the scan still moves does.
  const bool weighted = std::any_of(history.begin(), history.end(), [&](const IterationRecord& record) {
    return record.patchWeight != history.front().patchWeight;
  });
  area_.setAxisTitle(vtkAxis::RIGHT, weighted ? "Patch weight" : "Largest motion (mm)");
  std::vector<std::pair<double, double>> residual, other;
  double highest = 0, largest = 1e-3;
  for (const IterationRecord& record : history) {
    const double value = weighted ? record.patchWeight : record.motionMm;
    residual.emplace_back(record.iteration, record.rmsMm);
    other.emplace_back(record.iteration, value);
    highest = std::max(highest, record.rmsMm);
    largest = std::max(largest, value);
  }
  // One iteration is drawn as a short level line.
  if (history.size() == 1) {
    residual.emplace_back(residual.front().first + 1, residual.front().second);
    other.emplace_back(other.front().first + 1, other.front().second);
  }
  area_.addLine("RMS residual (mm)", residual, {0.0, 0.45, 0.70}, lineWidthPx_);
  area_.addLine(weighted ? "patch weight (right)" : "largest motion, mm (right)", other, {0.84, 0.37, 0.0},
                lineWidthPx_, true);
  area_.setRange(vtkAxis::BOTTOM, residual.front().first, residual.back().first);
  area_.setRange(vtkAxis::LEFT, 0, highest > 0 ? 1.25 * highest : 1);
  area_.setRange(vtkAxis::RIGHT, 0, 1.25 * largest);
}

}  // namespace falciform
