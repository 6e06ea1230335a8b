#pragma once
#include <QWidget>

class QSlider;

namespace falciform {

class NumberBox;

/// A slider with a number box beside it, both for one value; announces every step while it is dragged.
class SliderBox : public QWidget {
  Q_OBJECT

 public:
  /// The slider runs from `low` to `high` in steps of `step`; the box takes any value of [boxLow, boxHigh].
  struct Span {
    double low, high, step, boxLow, boxHigh;
  };
  SliderBox(const QString& name, const Span& span, const QString& suffix, QWidget* parent = nullptr);

  [[nodiscard]] double value() const;
  /// Without announcing.
  void setValue(double value);
  void setTip(const QString& tip);

 Q_SIGNALS:
  void moved(double value);

 private:
  Span span_;
  QSlider* slider_;
  NumberBox* box_;
};

}  // namespace falciform
