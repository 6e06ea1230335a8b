#include "Modules/Registration/ConvergenceReplay.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "Widgets/Views/PlotWidget.h"

namespace falciform {
namespace {

constexpr int kFrameMs = 33, kLongestFrames = 90;  // some three seconds, however many iterations there were

}  // namespace

ConvergenceReplay::ConvergenceReplay(QWidget* parent)
    : QWidget(parent),
      curves_(new PlotWidget(this)),
      row_(new QWidget(this)),
      replay_(new QPushButton(tr("Replay"), this)),
      slider_(new QSlider(Qt::Horizontal, this)),
      words_(new QLabel(this)),
      timer_(new QTimer(this)) {
  curves_->setObjectName("curves");
  curves_->setEmptyText(tr("Residual and patch weight appear here while the registration runs."));
  curves_->setToolTip(
      tr("At each iteration: RMS residual in mm (left axis), in the elastic finish that which its bending "
         "leaves; patch weight, or where it stays the same the "
         "largest motion of a scan point in mm (right axis, logarithmic)"));
  replay_->setObjectName("replay");
  replay_->setToolTip(tr("Show the scan moving once more as it did, from the start to the result"));
  slider_->setObjectName("replayIteration");
  slider_->setToolTip(tr("Iteration whose pose is shown. Range: 0 (the start) to the last"));
  words_->setObjectName("replayWords");
  auto* line = new QHBoxLayout(row_);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(replay_);
  line->addWidget(slider_, 1);
  line->addWidget(words_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(curves_);
  column->addWidget(row_);
  timer_->setInterval(kFrameMs);
  connect(replay_, &QPushButton::clicked, this, &ConvergenceReplay::play);
  connect(slider_, &QSlider::valueChanged, this, &ConvergenceReplay::showFrame);
  connect(slider_, &QSlider::sliderPressed, timer_, &QTimer::stop);
  connect(timer_, &QTimer::timeout, this, [this] {
    const int last = slider_->maximum();
    slider_->setValue(std::min(last, slider_->value() + std::max(1, last / kLongestFrames)));
  });
  show({}, false);
}

void ConvergenceReplay::show(const std::vector<IterationRecord>& records, bool running) {
  records_ = records;
  row_->setVisible(!running && !records.empty());
  stop();
  if (records.empty()) return curves_->clear();
  const bool weighted = std::any_of(records.begin(), records.end(), [&](const IterationRecord& record) {
    return record.patchWeight != records.front().patchWeight;
  });
  curves_->setTitles(tr("Iteration"), tr("RMS residual, mm"),
                     weighted ? tr("Patch weight") : tr("Largest motion, mm"));
  PlotWidget::Curve rms{{}, QColor("#0072b2"), {}, {}, false, false};
  PlotWidget::Curve other{{}, QColor("#d55e00"), {}, {}, true, true};
  for (const IterationRecord& record : records) {
    rms.x << record.iteration;
    rms.y << record.rmsMm;
    other.x << record.iteration;
    other.y << (weighted ? record.patchWeight : record.motionMm);
  }
  curves_->setCurves({rms, other});
}

void ConvergenceReplay::stop() {
  timer_->stop();
  const QSignalBlocker quiet(slider_);
  slider_->setRange(0, static_cast<int>(records_.size()));
  slider_->setValue(slider_->maximum());
  words_->setText(tr("%1 of %1").arg(records_.size()));
  // The words must not jump while they count.
  words_->setMinimumWidth(words_->fontMetrics().horizontalAdvance(words_->text()) + 4);
  curves_->setMarkers({});
}

void ConvergenceReplay::play() {
  slider_->setValue(0);
  timer_->start();
}

void ConvergenceReplay::showFrame(int frame) {
  words_->setText(tr("%1 of %2").arg(frame).arg(records_.size()));
  if (frame >= slider_->maximum()) {
    stop();
    Q_EMIT ended();
    return;
  }
  curves_->setMarkers(frame == 0
                          ? QVector<double>{}
                          : QVector<double>{double(records_[static_cast<std::size_t>(frame - 1)].iteration)});
  Q_EMIT frameShown(frame);
}

}  // namespace falciform
