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
    // A dark rim keeps light colours visible on a light background. Of two shapes on one spot the first stays
    // on top.
    parts_.push_back(rectangleAt({0, 1, 0.8 * textPx_, -down}, textPx_, textPx_, entry.colour));
    parts_.push_back(
        rectangleAt({0, 1, 0.8 * textPx_ - 1, -down - 1}, textPx_ + 2, textPx_ + 2, textColour_));
    parts_.push_back(textAt({0, 1, 2.3 * textPx_, -down + 0.5 * textPx_}, entry.text, textPx_, textColour_,
                            AlignX::Left, AlignY::Centre));
    down += 1.5 * textPx_;
  }
  for (const auto& part : parts_) renderer_->AddViewProp(part);
}

}  // namespace falciform
