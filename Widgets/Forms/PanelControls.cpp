#include "Widgets/Forms/PanelControls.h"

#include <QLabel>
#include <QToolButton>

namespace falciform {

QLabel* wrappedLabel(const QString& name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
  return label;
}

QToolButton* wideToolButton(const QString& name, const QString& text, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setText(text);
  button->setToolTip(tip);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  button->setFocusPolicy(Qt::StrongFocus);
  // Pressed is hard to tell in the dark theme.
  button->setStyleSheet(
      "QToolButton:checked { background: palette(highlight); color: palette(highlighted-text); border: 1px "
      "solid palette(shadow); border-radius: 2px; padding: 3px; }");
  return button;
}

}  // namespace falciform
