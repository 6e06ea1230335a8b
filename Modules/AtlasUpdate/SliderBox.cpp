#include "Modules/AtlasUpdate/SliderBox.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "Widgets/Forms/NumberBox.h"

namespace falciform {

SliderBox::SliderBox(const QString& name, const Span& span, const QString& suffix, QWidget* parent)
    : QWidget(parent), span_(span), slider_(new QSlider(Qt::Horizontal, this)), box_(new NumberBox(this)) {
  slider_->setObjectName(name + "Slider");
  slider_->setRange(static_cast<int>(std::lround(span.low / span.step)),
                    static_cast<int>(std::lround(span.high / span.step)));
  slider_->setMinimumWidth(60);
  box_->setObjectName(name);
  box_->setRange(span.boxLow, span.boxHigh);
  box_->setSuffix(suffix);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(box_);
  connect(slider_, &QSlider::valueChanged, this, [this](int step) {
    const QSignalBlocker quiet(box_);
    box_->setValue(step * span_.step);
    Q_EMIT moved(box_->value());
  });
  connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    setValue(value);
    Q_EMIT moved(value);
  });
}

double SliderBox::value() const { return box_->value(); }

void SliderBox::setValue(double value) {
  const QSignalBlocker quietSlider(slider_), quietBox(box_);
  slider_->setValue(static_cast<int>(std::lround(value / span_.step)));
  if (box_->value() != value) box_->setValue(value);
}

void SliderBox::setTip(const QString& tip) {
  slider_->setToolTip(tip);
  box_->setToolTip(tip);
}

}  // namespace falciform
