#include "Widgets/Rendering/LegendPresenter.h"

#include <vtkActor2D.h>

#include "Widgets/Rendering/OverlayShapes.h"

namespace falciform {

LegendPresenter::LegendPresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour)
    : renderer_(renderer), textPx_(textPx), textColour_(textColour) {}

LegendPresenter::~LegendPresenter() { show({}); }

void LegendPresenter::show(const std::vector<LegendEntry>& entries) {
  for (const auto& part : parts_) renderer_->RemoveViewProp(part);
  parts_.clear();
  // The first line stays free for a title.
  double down = 3.2 * textPx_;
  for (const LegendEntry& entry : entries) {
    const double left = 0.8 * textPx_, side = textPx_;
    parts_.push_back(rectangleAt({0, 1, left, -down}, side, side, entry.colour));
    // A dark rim keeps light colours visible on a light background. It lies beside the square, not under it:
    // which of two shapes on one spot is seen depends on the window.
    parts_.push_back(rectangleAt({0, 1, left - 1, -down - 1}, side + 2, 1, textColour_));
    parts_.push_back(rectangleAt({0, 1, left - 1, -down + side}, side + 2, 1, textColour_));
    parts_.push_back(rectangleAt({0, 1, left - 1, -down}, 1, side, textColour_));
    parts_.push_back(rectangleAt({0, 1, left + side, -down}, 1, side, textColour_));
    parts_.push_back(textAt({0, 1, 2.3 * textPx_, -down + 0.5 * textPx_}, entry.text, textPx_, textColour_,
                            AlignX::Left, AlignY::Centre));
    down += 1.5 * textPx_;
  }
  for (const auto& part : parts_) renderer_->AddViewProp(part);
}

}  // namespace falciform
