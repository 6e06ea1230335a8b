#include "Modules/Registration/RegistrationPanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTimer>
#include <QVBoxLayout>

#include "Logic/Geometry/RigidSteps.h"
#include "Modules/Registration/BasinTable.h"
#include "Modules/Registration/ConvergenceReplay.h"
#include "Modules/Registration/HandPoseControls.h"
#include "Modules/Registration/LandmarkStart.h"
#include "Modules/Registration/LiveHistory.h"
#include "Modules/Registration/ResultTable.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {
namespace {

constexpr int kLiveEveryMs = 33;  // as often as the eye can follow

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
      preview_(workbench.view),
      timer_(new QTimer(this)) {
  addSettings();
  addStart();
  addRun();
  addResult();
  addBasins();
  timer_->setInterval(kLiveEveryMs);
  connect(timer_, &QTimer::timeout, this, &RegistrationPanel::showLive);
  connect(&bench().runner, &JobRunner::failed, this, [this] {
    if (running_) endRun();
  });
  viewChanged_ = bench().view.changed.connect([this] { viewChanged(); });
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
  connect(preset_, &QComboBox::textActivated, this, &RegistrationPanel::applyPreset);
  connect(form_, &SettingsForm::edited, this, [this] {
    preset_->setCurrentIndex(preset_->count() - 1);
    refresh();
  });
}

void RegistrationPanel::addStart() {
  auto* group = addGroup(tr("Start pose"));
  landmarks_ = new LandmarkStart(this);
  handControls_ = new HandPoseControls(this);
  group->addWidget(landmarks_);
  group->addWidget(handControls_);
  connect(landmarks_, &LandmarkStart::toggled, this, [this](bool on) {
    logic_.startFromLandmarks = on;
    refresh();
  });
  const auto base = [this] { return hand_.value_or(startPreopFromScan()); };
  connect(handControls_, &HandPoseControls::toggled, this, &RegistrationPanel::moveByHand);
  connect(handControls_, &HandPoseControls::shiftWanted, this, [this, base](int axis, int sign) {
    setHandPose(shifted(base(), sign * handControls_->stepMm() * Vector3d::Unit(axis)));
  });
  connect(handControls_, &HandPoseControls::turnWanted, this, [this, base](int axis, int sign) {
    const Vector3d middle = document().scan()->points.colwise().mean();
    setHandPose(
        turned(base(), middle, Vector3d::Unit(axis), sign * handControls_->stepDeg() * EIGEN_PI / 180));
  });
  connect(handControls_, &HandPoseControls::stepsChanged, this, [this] {
    bench().view.edit([this](ViewOptions& options) {
      options.moveStepMm = handControls_->stepMm();
      options.moveStepDeg = handControls_->stepDeg();
    });
  });
  connect(handControls_, &HandPoseControls::registerWanted, this, [this] {
    if (!hand_) return;
    runStart_ = hand_->inverse();
    registerScan([this] { return logic_.prepareFrom(runStart_); });
  });
  connect(handControls_, &HandPoseControls::resetWanted, this, [this] {
    hand_.reset();
    preview_.endIf(PosePreview::Reason::Hand);
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
  convergence_ = new ConvergenceReplay(this);
  column()->addWidget(convergence_);
  connect(register_, &QPushButton::clicked, this, [this] {
    const std::optional<PointRegistrationResult> fit =
        logic_.startFromLandmarks ? logic_.landmarkFit() : std::nullopt;
    runStart_ = fit ? fit->targetFromSource : Isometry3d::Identity();
    registerScan([this] { return logic_.prepare(); });
  });
  connect(convergence_, &ConvergenceReplay::frameShown, this, &RegistrationPanel::showReplay);
  connect(convergence_, &ConvergenceReplay::ended, this,
          [this] { preview_.endIf(PosePreview::Reason::Replay); });
  connect(stop_, &QPushButton::clicked, this, [this] { bench().runner.cancel(); });
}

void RegistrationPanel::addResult() {
  beforeAfter_ = new QWidget(this);
  beforeAfter_->setObjectName("beforeAfter");
  auto* row = new QHBoxLayout(beforeAfter_);
  row->setContentsMargins(0, 0, 0, 0);
  before_ = new QRadioButton(tr("Before"), this);
  before_->setObjectName("showBefore");
  before_->setToolTip(
      tr("Show the scan at the start pose: as stored, as the landmarks give it, or as set by hand"));
  after_ = new QRadioButton(tr("After"), this);
  after_->setObjectName("showAfter");
  after_->setToolTip(tr("Show the scan where the registration puts it"));
  after_->setChecked(true);
  row->addWidget(new QLabel(tr("Show the scan"), this));
  row->addWidget(before_);
  row->addWidget(after_);
  row->addStretch(1);
  column()->addWidget(beforeAfter_);
  stale_ = wrappedLabel("stale", this);
  stale_->setText(QString::fromUtf8("⚠ ") + tr("Surface, scan or patches changed since: register again."));
  column()->addWidget(stale_);
  table_ = new ResultTable(this);
  column()->addWidget(table_);
  warnings_ = wrappedLabel("warnings", this);
  column()->addWidget(warnings_);
  const auto show = [this](bool after) {
    preview_.end();
    convergence_->stop();
    bench().view.edit([&](ViewOptions& options) { options.afterRegistration = after; });
    refresh();
  };
  connect(before_, &QRadioButton::clicked, this, [show] { show(false); });
  connect(after_, &QRadioButton::clicked, this, [show] { show(true); });
}

void RegistrationPanel::addBasins() {
  QVBoxLayout* group = addGroup(tr("Poses found"));
  basinGroup_ = qobject_cast<QGroupBox*>(group->parentWidget());
  basinGroup_->setObjectName("basinGroup");
  basins_ = new BasinTable(this);
  useBasin_ = new QPushButton(tr("Use this pose"), this);
  useBasin_->setObjectName("useBasin");
  useBasin_->setToolTip(tr("Make the selected pose the result, with figures of its own and a note"));
  backToBest_ = new QPushButton(tr("Back to best"), this);
  backToBest_->setObjectName("backToBest");
  backToBest_->setToolTip(tr("Make the pose with the lowest score the result again"));
  basinWords_ = wrappedLabel("basinWords", this);
  group->addWidget(basinWords_);
  group->addWidget(basins_);
  auto* row = new QHBoxLayout;
  row->addWidget(useBasin_, 1);
  row->addWidget(backToBest_, 1);
  group->addLayout(row);
  connect(basins_, &BasinTable::choiceChanged, this, &RegistrationPanel::showBasin);
  connect(useBasin_, &QPushButton::clicked, this, [this] {
    if (basins_->chosen() >= 0) useBasin(static_cast<std::size_t>(basins_->chosen()));
  });
  connect(backToBest_, &QPushButton::clicked, this, [this] { useBasin(bestBasin()); });
}

void RegistrationPanel::enter() {
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::Together;
    options.distanceShown = false;
  });
}

void RegistrationPanel::leave() {
  convergence_->stop();
  if (!running_) preview_.end();
  refresh();
}

void RegistrationPanel::applyPreset(const QString& name) {
  if (preset_->currentIndex() == preset_->count() - 1) return;  // own settings: as they are
  logic_.settings = registrationPreset(name.toStdString());
  form_->refresh();
  refresh();
}

void RegistrationPanel::caseChanged(Case::Part part) {
  // A pose placed by hand belongs to the scan it was placed for.
  if (part == Case::Part::Scan && (!document().scan() || !sameShape(document().scan(), handScan_))) {
    hand_.reset();
    handScan_ = document().scan();
    preview_.endIf(PosePreview::Reason::Hand);
  }
  if (part != Case::Part::Registration || running_) return;
  const auto& result = document().registration();
  if (!choosing_) found_ = result;
  preview_.end();
  convergence_->show(result ? result->history : std::vector<IterationRecord>{}, false);
}

void RegistrationPanel::refresh() {
  const bool busy = bench().runner.busy();
  showReadiness(register_, missing_, logic_.missingInput());
  stop_->setEnabled(running_);
  const std::string missingLandmarks = logic_.missingLandmarks();
  landmarks_->show(document().preopLandmarks(), logic_.landmarkFit(), missingLandmarks);
  handControls_->show(preview_.reason() == PosePreview::Reason::Hand, hand_.has_value(),
                      QString::fromStdString(logic_.missingSurfaces()), busy);
  const auto& result = document().registration();
  table_->show(document());
  stale_->setVisible(document().registrationStale());
  beforeAfter_->setVisible(result != nullptr);
  before_->setEnabled(result != nullptr);
  after_->setEnabled(result != nullptr);
  showWarnings(warnings_, result ? result->warnings : std::vector<std::string>{});
  refreshBasins();
  bench().view.edit(
      [this](ViewOptions& options) { options.startPreopFromScan = startPreopFromScan().matrix(); });
}

void RegistrationPanel::viewChanged() {
  const ViewOptions& options = bench().view.options();
  (options.afterRegistration ? after_ : before_)->setChecked(true);
  if (preview_.reason() != PosePreview::Reason::Hand) return;
  // The view's handles moved the scan, or Esc left them.
  if (options.moving && options.livePreopFromScan) {
    const bool first = !hand_;
    hand_ = Isometry3d(*options.livePreopFromScan);
    if (first) refresh();
  } else if (!options.moving) {
    preview_.end();
    refresh();
  }
}

void RegistrationPanel::registerScan(const std::function<RegistrationLogic::Job()>& prepare) {
  live_ = std::make_shared<LiveHistory>();
  liveShown_ = 0;
  logic_.observer = LiveHistory::observerOf(live_);
  running_ = true;
  preview_.end();
  convergence_->show({}, true);
  timer_->start();
  bench().runner.start(
      tr("Registering"), prepare(),
      [this, preop = document().preop(), scan = document().scan()](RegistrationResult result) {
        registered(std::move(result), preop, scan);
      },
      [this] { keepLastPose(); });
}

void RegistrationPanel::registered(RegistrationResult result, const std::shared_ptr<const Surface>& preop,
                                   const std::shared_ptr<const Surface>& scan) {
  endRun();
  if (!sameShape(document().preop(), preop) || !sameShape(document().scan(), scan)) {
    bench().log.warn(tr("The surfaces were replaced while they were registered: the result is dropped."));
    return;
  }
  const bool repainted = document().preop() != preop || document().scan() != scan;
  for (const std::string& warning : result.warnings) bench().log.warn(QString::fromStdString(warning));
  bench().log.info(tr("Registered: RMS residual %1 mm (fit, not target error), %2 iterations, %3 s.")
                       .arg(result.rmsMm, 0, 'f', 2)
                       .arg(result.iterations)
                       .arg(result.seconds, 0, 'f', 2));
  logic_.accept(std::move(result));
  if (repainted) document().setScan(document().scan());  // the result rests on older patches: stale
  bench().view.edit([](ViewOptions& options) { options.afterRegistration = true; });
}

void RegistrationPanel::endRun() {
  running_ = false;
  timer_->stop();
  preview_.endIf(PosePreview::Reason::Running);
}

void RegistrationPanel::keepLastPose() {
  endRun();
  const std::vector<IterationRecord> records = live_->records();
  if (records.empty() || !document().scan() || !document().preop()) {
    bench().log.info(tr("Stopped before the first iteration; the case is as it was."));
    return;
  }
  bench().log.warn(tr("Stopped at iteration %1; its pose is kept.").arg(records.size()));
  const RegistrationResult pose =
      stoppedResult(records, document().scan()->size(), document().preop()->size());
  logic_.accept(pose);
  bench().view.edit([](ViewOptions& options) { options.afterRegistration = true; });
  // The runner is still ending the stopped job.
  QTimer::singleShot(0, this, [this, pose] { evaluate(pose); });
}

void RegistrationPanel::evaluate(RegistrationResult pose) {
  const auto preop = document().preop(), scan = document().scan();
  const auto before = document().registration();
  if (!preop || !scan) return;
  bench().runner.start(
      tr("Figures of the pose"), logic_.prepareEvaluation(std::move(pose), runStart_),
      [this, preop, scan, before](RegistrationResult result) {
        if (document().preop() != preop || document().scan() != scan || document().registration() != before)
          return;  // of something that is no longer there
        choosing_ = true;
        logic_.accept(std::move(result));
        choosing_ = false;
        bench().view.edit([](ViewOptions& options) { options.afterRegistration = true; });
      });
}

void RegistrationPanel::showLive() {
  if (live_->size() == liveShown_) return;
  const std::vector<IterationRecord> records = live_->records();
  liveShown_ = records.size();
  if (records.empty()) return;
  convergence_->show(records, true);
  preview_.show(PosePreview::Reason::Running, records.back().preopFromScan, tr("Registering"));
}

}  // namespace falciform
