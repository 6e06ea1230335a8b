#include "Widgets/Forms/NumberBox.h"

#include <QLocale>
#include <QWheelEvent>

namespace falciform {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setLocale(QLocale::c());
  setDecimals(12);  // the box rounds its value to this; what is shown is textFromValue's business
  setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  setFocusPolicy(Qt::StrongFocus);
  setKeyboardTracking(false);
}

QString NumberBox::bare(QString text) const {
  if (!suffix().isEmpty() && text.endsWith(suffix())) text.chop(suffix().size());
  return text.trimmed();
}

QString NumberBox::textFromValue(double value) const { return QString::number(value, 'g', 6); }

double NumberBox::valueFromText(const QString& text) const { return QLocale::c().toDouble(bare(text)); }

QValidator::State NumberBox::validate(QString& text, int&) const {
  bool isNumber = false;
  const QString number = bare(text);
  const double value = QLocale::c().toDouble(number, &isNumber);
  if (isNumber)
    return value >= minimum() && value <= maximum() ? QValidator::Acceptable : QValidator::Intermediate;
  for (const QChar c : number)
    if (!c.isDigit() && !QString("+-.eE").contains(c)) return QValidator::Invalid;
  return QValidator::Intermediate;
}

void NumberBox::wheelEvent(QWheelEvent* event) {
  // Scrolling the panel must not change settings under the pointer.
  if (hasFocus())
    QDoubleSpinBox::wheelEvent(event);
  else
    event->ignore();
}

}  // namespace falciform
