#include "Widgets/Rendering/TextPresenter.h"

#include <vtkTextProperty.h>

#include "Widgets/Rendering/OverlayShapes.h"

namespace falciform {

TextPresenter::TextPresenter(vtkRenderer* renderer, TextPlace place, int px, const Vector3d& colour,
                             int linesUp)
    : renderer_(renderer) {
  const bool top = place == TextPlace::TopCentre || place == TextPlace::TopLeft;
  const bool centre = place == TextPlace::TopCentre || place == TextPlace::BottomCentre;
  const double margin = 0.6 * px, up = 1.5 * px * linesUp;
  actor_ = textAt({centre ? 0.5 : 0.0, top ? 1.0 : 0.0, centre ? 0 : margin, top ? -margin : margin + up}, "",
                  px, colour, centre ? AlignX::Centre : AlignX::Left, top ? AlignY::Top : AlignY::Bottom);
  renderer_->AddViewProp(actor_);
}

TextPresenter::~TextPresenter() { renderer_->RemoveViewProp(actor_); }

void TextPresenter::setText(const std::string& text) { actor_->SetInput(text.c_str()); }

void TextPresenter::setBold(bool bold) { actor_->GetTextProperty()->SetBold(bold); }

}  // namespace falciform
