#pragma once
#include <QDoubleSpinBox>

namespace falciform {

/// A spin box for a double over any span of magnitudes: shows six significant digits ("0.0001", "1e-09"),
/// takes exponents, steps by a tenth of the value's magnitude, and ignores the wheel until it has been
/// clicked.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit NumberBox(QWidget* parent = nullptr);

  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& position) const override;

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  QString bare(QString text) const;
};

}  // namespace falciform
