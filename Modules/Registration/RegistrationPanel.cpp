#include "Modules/Registration/RegistrationPanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTimer>
#include <QVBoxLayout>

#include "Modules/Registration/LiveHistory.h"
#include "Modules/Registration/ResultTable.h"
#include "Widgets/Forms/SettingsForm.h"
#include "Widgets/Views/PlotWidget.h"

namespace falciform {
namespace {

constexpr int kLiveEveryMs = 100;

/// Whether `now` still has the points that a job was started with; patches may differ.
bool sameShape(const std::shared_ptr<const Surface>& now, const std::shared_ptr<const Surface>& then) {
  return now == then || (now && then && now->points == then->points);
}

}  // namespace

RegistrationPanel::RegistrationPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench,
                  tr("Finds where the scan lies on the pre-operative liver, led by the painted patches."),
                  parent),
      logic_(document()),
      timer_(new QTimer(this)) {
  addSettings();
  addRun();
  addResult();
  timer_->setInterval(kLiveEveryMs);
  connect(timer_, &QTimer::timeout, this, &RegistrationPanel::showLive);
  connect(&bench().runner, &JobRunner::failed, this, [this] {
    if (running_) endRun();
  });
  viewChanged_ = bench().view.changed.connect(
      [this] { (bench().view.options().afterRegistration ? after_ : before_)->setChecked(true); });
  start();
}

RegistrationPanel::~RegistrationPanel() = default;

void RegistrationPanel::addSettings() {
  auto* group = addGroup(tr("Method"));
  preset_ = new QComboBox(this);
  preset_->setObjectName("preset");
  preset_->setToolTip(
      tr("Sets all settings below: the program's default, or the thesis's phantom and clinical settings"));
  for (const std::string& name : registrationPresets()) preset_->addItem(QString::fromStdString(name));
  preset_->addItem(tr("(own settings)"));
  auto* row = new QFormLayout;
  row->addRow(tr("Preset"), preset_);
  group->addLayout(row);
  form_ = new SettingsForm(logic_.settings, {"method", "start"}, {}, this);
  form_->setObjectName("registrationSettings");
  group->addWidget(form_);
  landmarks_ = new QCheckBox(tr("Start from landmarks"), this);
  landmarks_->setObjectName("startFromLandmarks");
  landmarks_->setToolTip(
      tr("Fit the landmarks of both sides first and begin there; needs 3 or more on each side"));
  group->addWidget(landmarks_);
  connect(preset_, &QComboBox::textActivated, this, &RegistrationPanel::applyPreset);
  connect(form_, &SettingsForm::edited, this, [this] {
    preset_->setCurrentIndex(preset_->count() - 1);
    refresh();
  });
  connect(landmarks_, &QCheckBox::toggled, this, [this](bool on) {
    logic_.startFromLandmarks = on;
    refresh();
  });
}

void RegistrationPanel::addRun() {
  auto* row = new QHBoxLayout;
  register_ = new QPushButton(tr("Register"), this);
  register_->setObjectName("register");
  register_->setToolTip(tr("Find the scan's place on the surface; the window stays usable meanwhile"));
  stop_ = new QPushButton(tr("Stop"), this);
  stop_->setObjectName("stop");
  stop_->setToolTip(tr("Stop now and keep the pose of the last iteration"));
  row->addWidget(register_, 1);
  row->addWidget(stop_);
  column()->addLayout(row);
  missing_ = wrappedLabel("missing", this);
  column()->addWidget(missing_);
  curves_ = new PlotWidget(this);
  curves_->setObjectName("curves");
  curves_->setTitles(tr("Iteration"), tr("RMS residual, mm"), tr("Patch weight"));
  curves_->setEmptyText(tr("Residual and patch weight appear here while the registration runs."));
  curves_->setToolTip(
      tr("RMS residual in mm (left axis) and patch weight (right axis, logarithmic) at each iteration"));
  column()->addWidget(curves_);
  connect(register_, &QPushButton::clicked, this, &RegistrationPanel::registerScan);
  connect(stop_, &QPushButton::clicked, this, [this] { bench().runner.cancel(); });
}

void RegistrationPanel::addResult() {
  auto* row = new QHBoxLayout;
  before_ = new QRadioButton(tr("Before"), this);
  before_->setObjectName("showBefore");
  before_->setToolTip(tr("Show the scan where it was before the registration"));
  after_ = new QRadioButton(tr("After"), this);
  after_->setObjectName("showAfter");
  after_->setToolTip(tr("Show the scan where the registration puts it"));
  after_->setChecked(true);
  row->addWidget(new QLabel(tr("Show the scan"), this));
  row->addWidget(before_);
  row->addWidget(after_);
  row->addStretch(1);
  column()->addLayout(row);
  stale_ = wrappedLabel("stale", this);
  stale_->setText(QString::fromUtf8("⚠ ") + tr("Surface, scan or patches changed since: register again."));
  column()->addWidget(stale_);
  table_ = new ResultTable(this);
  column()->addWidget(table_);
  warnings_ = wrappedLabel("warnings", this);
  column()->addWidget(warnings_);
  const auto show = [this](bool after) {
    bench().view.edit([&](ViewOptions& options) { options.afterRegistration = after; });
  };
  connect(before_, &QRadioButton::clicked, this, [show] { show(false); });
  connect(after_, &QRadioButton::clicked, this, [show] { show(true); });
}

void RegistrationPanel::enter() {
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::Together;
    options.distanceShown = false;
  });
}

void RegistrationPanel::applyPreset(const QString& name) {
  if (preset_->currentIndex() == preset_->count() - 1) return;  // own settings: as they are
  logic_.settings = registrationPreset(name.toStdString());
  form_->refresh();
  refresh();
}

void RegistrationPanel::caseChanged(Case::Part part) {
  if (part != Case::Part::Registration || running_) return;
  const auto& result = document().registration();
  plot(result ? result->history : std::vector<IterationRecord>{});
}

void RegistrationPanel::refresh() {
  showReadiness(register_, missing_, logic_.missingInput());
  stop_->setEnabled(running_);
  const auto& result = document().registration();
  table_->show(result.get(), document().preop().get());
  stale_->setVisible(document().registrationStale());
  before_->setEnabled(result != nullptr);
  after_->setEnabled(result != nullptr);
  showWarnings(warnings_, result ? result->warnings : std::vector<std::string>{});
}

void RegistrationPanel::registerScan() {
  live_ = std::make_shared<LiveHistory>();
  logic_.observer = LiveHistory::observerOf(live_);
  running_ = true;
  plot({});
  timer_->start();
  bench().runner.start(
      tr("Registering"), logic_.prepare(),
      [this, preop = document().preop(), scan = document().scan()](RegistrationResult result) {
        endRun();
        if (!sameShape(document().preop(), preop) || !sameShape(document().scan(), scan)) {
          bench().log.warn(
              tr("The surfaces were replaced while they were registered: the result is dropped."));
          return;
        }
        const bool repainted = document().preop() != preop || document().scan() != scan;
        for (const std::string& warning : result.warnings) bench().log.warn(QString::fromStdString(warning));
        bench().log.info(tr("Registered: RMS residual %1 mm (fit, not target error), %2 iterations, %3 s.")
                             .arg(result.rmsMm, 0, 'f', 2)
                             .arg(result.iterations)
                             .arg(result.seconds, 0, 'f', 1));
        logic_.accept(std::move(result));
        if (repainted) document().setScan(document().scan());  // the result rests on older patches: stale
        bench().view.edit([](ViewOptions& options) { options.afterRegistration = true; });
      },
      [this] { keepLastPose(); });
}

void RegistrationPanel::endRun() {
  running_ = false;
  timer_->stop();
  bench().view.edit([](ViewOptions& options) { options.livePreopFromScan.reset(); });
}

void RegistrationPanel::keepLastPose() {
  endRun();
  const std::vector<IterationRecord> records = live_->records();
  if (records.empty() || !document().scan() || !document().preop()) {
    bench().log.info(tr("Stopped before the first iteration; the case is as it was."));
    return;
  }
  bench().log.warn(tr("Stopped at iteration %1; its pose is kept.").arg(records.size()));
  logic_.accept(stoppedResult(records, document().scan()->size(), document().preop()->size()));
}

void RegistrationPanel::showLive() {
  const std::vector<IterationRecord> records = live_->records();
  if (records.empty()) return;
  plot(records);
  bench().view.edit(
      [&](ViewOptions& options) { options.livePreopFromScan = records.back().preopFromScan.matrix(); });
}

void RegistrationPanel::plot(const std::vector<IterationRecord>& records) {
  if (records.empty()) {
    curves_->clear();
    return;
  }
  PlotWidget::Curve rms{tr("RMS residual"), QColor("#0072b2"), {}, {}, false, false};
  PlotWidget::Curve weight{tr("Patch weight"), QColor("#d55e00"), {}, {}, true, true};
  for (const IterationRecord& record : records) {
    rms.x << record.iteration;
    rms.y << record.rmsMm;
    weight.x << record.iteration;
    weight.y << record.patchWeight;
  }
  curves_->setCurves({rms, weight});
}

}  // namespace falciform
