#include "Widgets/Jobs/JobBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "Widgets/Jobs/JobRunner.h"

namespace falciform {

JobBar::JobBar(JobRunner& runner, QWidget* parent)
    : QWidget(parent),
      text_(new QLabel(this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  text_->setObjectName("jobText");
  text_->setMinimumWidth(260);
  text_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar_->setObjectName("jobProgress");
  bar_->setRange(0, 1000);
  bar_->setFixedWidth(220);
  bar_->setToolTip(tr("Share of the running job that is done, in %"));
  cancel_->setObjectName("jobCancel");
  cancel_->setToolTip(tr("Stop the running job at its next step; the case stays as it was"));

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->addWidget(text_, 1);
  row->addWidget(bar_);
  row->addWidget(cancel_);
  showIdle(tr("Ready"));

  connect(&runner, &JobRunner::started, this, [this](const QString& title) {
    text_->setText(title + QString::fromUtf8(" …"));
    bar_->setValue(0);
    bar_->setVisible(true);
    cancel_->setEnabled(true);
    cancel_->setVisible(true);
  });
  connect(&runner, &JobRunner::progressed, this, [this, &runner](double fraction, const QString& stage) {
    if (!runner.busy()) return;
    bar_->setValue(static_cast<int>(fraction * bar_->maximum()));
    if (!stage.isEmpty()) text_->setText(runner.title() + ": " + stage);
  });
  connect(&runner, &JobRunner::failed, this,
          [this, &runner] { showIdle(runner.title() + tr(" failed; see the log")); });
  connect(&runner, &JobRunner::cancelled, this,
          [this, &runner] { showIdle(runner.title() + tr(" stopped")); });
  connect(&runner, &JobRunner::finished, this, [this, &runner] {
    if (runner.busy()) return;                           // the next job has begun already
    if (bar_->isVisibleTo(this)) showIdle(tr("Ready"));  // neither failed nor stopped
  });
  connect(cancel_, &QPushButton::clicked, this, [this, &runner] {
    cancel_->setEnabled(false);
    text_->setText(runner.title() + tr(": stopping"));
    runner.cancel();
  });
}

void JobBar::showIdle(const QString& text) {
  text_->setText(text);
  bar_->setVisible(false);
  cancel_->setVisible(false);
}

}  // namespace falciform
