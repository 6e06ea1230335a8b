#include "Widgets/Views/StandardViewBar.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace falciform {

StandardViewBar::StandardViewBar(std::function<void(std::optional<StandardView>)> turn, QWidget* parent)
    : QWidget(parent) {
  auto* bar = new QHBoxLayout(this);
  bar->setContentsMargins(4, 2, 4, 2);
  bar->setSpacing(2);
  const auto view = [&](const char* name, const QString& label, const QString& tip,
                        std::optional<StandardView> where) {
    connect(add(name, label, tip), &QToolButton::clicked, this, [turn, where] { turn(where); });
  };
  view("viewAnterior", tr("Anterior"), tr("From the patient's front (Shift+A)"), StandardView::Anterior);
  view("viewPosterior", tr("Posterior"), tr("From the patient's back (Shift+P)"), StandardView::Posterior);
  view("viewRight", tr("Right"), tr("From the patient's right (Shift+R)"), StandardView::Right);
  view("viewLeft", tr("Left"), tr("From the patient's left (Shift+L)"), StandardView::Left);
  view("viewSuperior", tr("Superior"), tr("From the head (Shift+S)"), StandardView::Superior);
  view("viewInferior", tr("Inferior"), tr("From the feet (Shift+I)"), StandardView::Inferior);
  view("viewReset", tr("Fit"), tr("Show everything, direction kept (R)"), {});
  bar->addStretch(1);
}

QToolButton* StandardViewBar::addAtEnd(const QString& name, const QString& label, const QString& tip) {
  return add(name, label, tip);
}

QToolButton* StandardViewBar::add(const QString& name, const QString& label, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(label);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  layout()->addWidget(button);
  return button;
}

}  // namespace falciform
