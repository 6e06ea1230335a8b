#include "Modules/AtlasUpdate/LiveDeformation.h"

#include <algorithm>

#include "Logic/Core/Results.h"
#include "Widgets/Rendering/ScalarMap.h"

namespace falciform {

LiveDeformation::LiveDeformation(const SupportLogic& logic, ViewState& view, JobRunner::Mode mode,
                                 QObject* parent)
    : QObject(parent), logic_(logic), view_(view), runner_(mode) {
  connect(&runner_, &LatestRunner::failed, this, &LiveDeformation::showAtRest);
}

void LiveDeformation::update() {
  if (!logic_.model()) {
    runner_.drop();
    known_.reset();
    showAtRest({});
    return;
  }
  runner_.submit(logic_.deform(known_), [this](SupportLogic::Answer answer) { take(std::move(answer)); });
}

void LiveDeformation::hide() {
  runner_.drop();
  showAtRest({});
}

void LiveDeformation::take(SupportLogic::Answer answer) {
  if (!answer.missing.empty()) {
    showAtRest(QString::fromStdString(answer.missing));
    return;
  }
  const bool other = !known_ || known_->response != answer.response;
  known_ = shown_ = std::make_shared<const SupportLogic::Answer>(std::move(answer));
  missing_.clear();
  const double end = magnitudeMap(kDisplacement, "", "mm", shown_->liver.largestMm).high;
  view_.edit([&](ViewOptions& options) {
    options.liveDeformed = shown_->liver.surface;
    options.deformedCaption = "Computed from the painted supports; not measured";
    // While a slider moves the scale only grows, so that a colour keeps its meaning.
    options.displacementLimitMm = other ? end : std::max(options.displacementLimitMm, end);
  });
  Q_EMIT changed();
}

void LiveDeformation::showAtRest(const QString& missing) {
  shown_.reset();
  missing_ = missing;
  view_.edit([](ViewOptions& options) { options.liveDeformed.reset(); });
  Q_EMIT changed();
}

}  // namespace falciform
