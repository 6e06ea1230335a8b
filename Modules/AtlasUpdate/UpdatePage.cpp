#include "Modules/AtlasUpdate/UpdatePage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QTimer>
#include <QVBoxLayout>

#include "Modules/AtlasUpdate/SliderBox.h"
#include "Modules/AtlasUpdate/TargetTable.h"
#include "Widgets/Forms/SettingsForm.h"
#include "Widgets/Views/PlotWidget.h"

namespace falciform {
namespace {

constexpr int kLiveEveryMs = 50;

QPushButton* button(const QString& name, const QString& text, const QString& tip, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

QCheckBox* box(const QString& name, const QString& text, const QString& tip, QWidget* parent) {
  auto* made = new QCheckBox(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

}  // namespace

UpdatePage::UpdatePage(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench,
                  tr("Finds from the registered scan how the liver has bent, and moves tumours and vessels "
                     "along. Nothing need be said of supports or packs."),
                  parent),
      logic_(document()),
      timer_(new QTimer(this)) {
  addModel();
  addRun();
  addConfidence();
  addLook();
  addExport();
  addTargets();
  timer_->setInterval(kLiveEveryMs);
  connect(timer_, &QTimer::timeout, this, &UpdatePage::showLive);
  connect(&bench().runner, &JobRunner::failed, this, &UpdatePage::endRun);
  start();
}

UpdatePage::~UpdatePage() = default;

void UpdatePage::addModel() {
  auto* group = addGroup(tr("Model of the liver"));
  meshForm_ = new SettingsForm(logic_.mesh, {"edgeLengthMm"}, {"largestPiece", "tumourEdgeLengthMm"}, this);
  meshForm_->setObjectName("updateMeshSettings");
  group->addWidget(meshForm_);
  auto* row = new QHBoxLayout;
  prepare_ =
      button("prepareUpdate", tr("Prepare the model"),
             tr("Fills the liver with elements and solves how it answers to loads on its surface; takes "
                "seconds, more for a shorter edge length (mm), and needs no scan"),
             this);
  cancel_ = button("cancelPrepare", tr("Cancel"), tr("Stop preparing; nothing is kept"), this);
  open_ = button("openAtlas", tr("Open…"),
                 tr("Open an atlas of this liver (.h5) that was built before the operation: one of surface "
                    "loads is ready at once, of one of deformations the mesh is used"),
                 this);
  row->addWidget(prepare_, 1);
  row->addWidget(open_);
  row->addWidget(cancel_);
  group->addLayout(row);
  modelMissing_ = wrappedLabel("updateModelMissing", this);
  modelFacts_ = wrappedLabel("updateModelFacts", this);
  group->addWidget(modelMissing_);
  group->addWidget(modelFacts_);
  connect(prepare_, &QPushButton::clicked, this, &UpdatePage::prepareModel);
  connect(open_, &QPushButton::clicked, this, &UpdatePage::openAtlas);
  connect(cancel_, &QPushButton::clicked, this, [this] { bench().runner.cancel(); });
  connect(meshForm_, &SettingsForm::edited, this, [this] { refresh(); });
}

void UpdatePage::addRun() {
  auto* group = addGroup(tr("Update"));
  fitForm_ = new SettingsForm(logic_.settings, {"maxIterations"}, {}, this);
  fitForm_->setObjectName("updateSettings");
  group->addWidget(fitForm_);
  auto* row = new QHBoxLayout;
  update_ = button(
      "updateModel", tr("Update the model"),
      tr("Bends the liver to fit the scan, from the registration's pose; about a second (Ctrl+U)"), this);
  stop_ = button("stopUpdate", tr("Stop"), tr("Stop now and keep what the last iteration has come to"), this);
  row->addWidget(update_, 1);
  row->addWidget(stop_);
  group->addLayout(row);
  missing_ = wrappedLabel("updateMissing", this);
  group->addWidget(missing_);
  curves_ = new PlotWidget(this);
  curves_->setObjectName("updateCurves");
  curves_->setTitles(tr("Iteration"), tr("mm"));
  curves_->setEmptyText(tr("Residual, bending and expected error appear here while the model is updated."));
  curves_->setToolTip(
      tr("At each iteration, in mm: RMS residual (fit), RMS bending as learnt so far, and the error to be "
         "expected over the surface"));
  group->addWidget(curves_);
  liveWords_ = wrappedLabel("updateLive", this);
  figures_ = wrappedLabel("updateFigures", this);
  group->addWidget(liveWords_);
  group->addWidget(figures_);
  update_->setShortcut(QKeySequence("Ctrl+U"));
  connect(update_, &QPushButton::clicked, this, &UpdatePage::runUpdate);
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (watch_) watch_->stop();
    stop_->setEnabled(false);
  });
  connect(fitForm_, &SettingsForm::edited, this, [this] { refresh(); });
}

void UpdatePage::addConfidence() {
  auto* group = addGroup(tr("How far to trust it"));
  confidence_ = wrappedLabel("confidence", this);
  stale_ = wrappedLabel("updateStale", this);
  warnings_ = wrappedLabel("updateWarnings", this);
  for (QLabel* words : {stale_, confidence_, warnings_}) group->addWidget(words);
}

void UpdatePage::addLook() {
  auto* group = addGroup(tr("Rigid and updated"));
  share_ = new SliderBox("updateShare", {0, 1, 0.05, 0, 1}, {}, this);
  share_->setTip(
      tr("0: the liver as the rigid registration leaves it; 1: as the update moves it.\nUnit: share of the "
         "way\nRange: 0 to 1\nDefault: 1"));
  rigid_ = button("showRigid", tr("Rigid"),
                  tr("The liver where the rigid registration puts it (Ctrl+T: to and fro)"), this);
  updated_ =
      button("showUpdated", tr("Updated"), tr("The liver as the update moves it (Ctrl+T: to and fro)"), this);
  auto* row = new QHBoxLayout;
  row->addWidget(rigid_);
  row->addWidget(share_, 1);
  row->addWidget(updated_);
  group->addLayout(row);
  colours_ = new QComboBox(this);
  colours_->setObjectName("updateColours");
  colours_->setToolTip(tr("What the liver's colours stand for, all in mm"));
  colours_->addItems({tr("none"), tr("motion against rigid"), tr("residual (fit)"), tr("expected error"),
                      tr("scan here next")});
  auto* form = new QFormLayout;
  form->addRow(tr("Colours"), colours_);
  group->addLayout(form);
  meaning_ = wrappedLabel("coloursMeaning", this);
  group->addWidget(meaning_);
  compare_ = box("compareViews", tr("Two views side by side"),
                 tr("Left as registered, right as updated, both seen from the same place"), this);
  before_ = box("structuresBefore", tr("Tumours and vessels also where they were"),
                tr("Orange, see-through: where the rigid registration puts them"), this);
  inside_ = box("seeInside", tr("See inside"), tr("Makes liver and scan see-through: opacity 35 %"), this);
  slices_ =
      box("ctSlices", tr("Slices of the CT"),
          tr("Three cuts through the CT, or the label map, with the outlines before and after; mm"), this);
  for (QCheckBox* one : {compare_, inside_, before_, slices_}) group->addWidget(one);
  looks_ = {rigid_, updated_, share_, colours_, compare_, inside_, before_, slices_};
  connect(share_, &SliderBox::moved, this,
          [this](double share) { look([&](UpdateLook& now) { now.share = share; }); });
  connect(rigid_, &QPushButton::clicked, this, [this] { look([](UpdateLook& now) { now.share = 0; }); });
  connect(updated_, &QPushButton::clicked, this, [this] { look([](UpdateLook& now) { now.share = 1; }); });
  connect(colours_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    look([&](UpdateLook& now) { now.colours = static_cast<UpdateColours>(index); });
  });
  connect(compare_, &QCheckBox::toggled, this,
          [this](bool on) { look([&](UpdateLook& now) { now.compare = on; }); });
  connect(before_, &QCheckBox::toggled, this,
          [this](bool on) { look([&](UpdateLook& now) { now.before = on; }); });
  connect(slices_, &QCheckBox::toggled, this,
          [this](bool on) { look([&](UpdateLook& now) { now.slices = on; }); });
  connect(inside_, &QCheckBox::toggled, this, &UpdatePage::seeInside);
  auto* toAndFro = new QShortcut(QKeySequence("Ctrl+T"), this);
  connect(toAndFro, &QShortcut::activated, this, [this] {
    if (rigid_->isEnabled()) look([](UpdateLook& now) { now.share = now.share > 0.5 ? 0 : 1; });
  });
}

void UpdatePage::addTargets() {
  auto* group = addGroup(tr("Targets, mm"));
  table_ = new TargetTable(this);
  group->addWidget(table_);
  targets_ = button("openTargets", tr("Targets…"),
                    tr("Open points inside the liver (.mrk.json, .fcsv), mm in the CT's frame"), this);
  truth_ = button(
      "openTruth", tr("True places…"),
      tr("Open where the targets truly are (.mrk.json, .fcsv), mm in the scan's frame: for trials"), this);
  auto* row = new QHBoxLayout;
  row->addWidget(targets_);
  row->addWidget(truth_);
  group->addLayout(row);
  connect(targets_, &QPushButton::clicked, this,
          [this] { openTargets(FileRole::Targets, tr("Open targets")); });
  connect(truth_, &QPushButton::clicked, this,
          [this] { openTargets(FileRole::TruthTargets, tr("Open true places of the targets")); });
}

void UpdatePage::addExport() {
  auto* row = new QHBoxLayout;
  saveSurface_ = button("saveUpdated", tr("Surface…"),
                        tr("Save the updated surface in the scan's frame, mm, with displacement and expected "
                           "error at every vertex"),
                        this);
  saveTargets_ = button("saveUpdatedTargets", tr("Targets…"),
                        tr("Save the targets where they are now, in the scan's frame, mm"), this);
  savePicture_ = button("saveUpdatePicture", tr("Picture…"), tr("Save the 3D view as a picture"), this);
  row->addWidget(new QLabel(tr("Save"), this));
  for (QPushButton* one : {saveSurface_, saveTargets_, savePicture_}) row->addWidget(one, 1);
  column()->addLayout(row);
  connect(saveSurface_, &QPushButton::clicked, this, &UpdatePage::saveSurface);
  connect(saveTargets_, &QPushButton::clicked, this, &UpdatePage::saveTargets);
  connect(savePicture_, &QPushButton::clicked, this, [this] { Q_EMIT pictureWanted("update.png"); });
}

void UpdatePage::enter() {
  entered_ = true;
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::Together;
    options.afterRegistration = true;
    options.distanceShown = false;
  });
  showInViews();
  refresh();
}

void UpdatePage::leave() {
  inside_->setChecked(false);
  entered_ = false;
  hideUpdate(bench().view);
}

void UpdatePage::look(const std::function<void(UpdateLook&)>& change) {
  change(look_);
  showInViews();
  refresh();
}

void UpdatePage::showInViews() {
  if (entered_) showUpdate(bench().view, maps_.get(), look_);
}

// The tree's opacities of liver and scan, kept and given back.
void UpdatePage::seeInside(bool on) {
  if (on == seeThrough_) return;
  seeThrough_ = on;
  for (const char* outer : {part::kPreop, part::kScan}) {
    PartLook shell = bench().view.look(outer);
    if (on) opacityBefore_[outer] = shell.opacity;
    shell.opacity = on ? 0.35 : opacityBefore_[outer];
    bench().view.setLook(outer, shell);
  }
}

void UpdatePage::refresh() {
  if (maps_ && maps_->of != logic_.result()) {  // the liver is another one
    maps_.reset();
    showInViews();
  }
  showKept();
  const bool busy = bench().runner.busy();
  showReadiness(prepare_, modelMissing_, logic_.missingForModel());
  open_->setEnabled(prepare_->isEnabled());
  cancel_->setEnabled(preparing_ && busy);
  modelFacts_->setText(updateModelState(logic_));
  modelFacts_->setVisible(logic_.missingForModel().empty());
  showReadiness(update_, missing_, logic_.missingInput());
  stop_->setEnabled(running_ && busy && !watch_->stopping());
  liveWords_->setVisible(running_);

  const UpdatedCase* made = maps_ ? maps_->of.get() : nullptr;
  figures_->setText(made ? updateFigures(made->update) : QString());
  figures_->setVisible(made && !running_);
  confidence_->setText(made ? confidenceWords(*made) : tr("Nothing has been updated yet."));
  const std::string stale = logic_.staleReason();
  stale_->setText(stale.empty() ? QString() : QString::fromUtf8("⚠ ") + QString::fromStdString(stale));
  stale_->setVisible(!stale.empty());
  showWarnings(warnings_, made ? updateWarnings(*made) : std::vector<std::string>{});

  for (QWidget* one : looks_) one->setEnabled(made && !running_);
  share_->setValue(look_.share);
  meaning_->setText(meaningOf(look_.colours));
  meaning_->setMinimumHeight(0);  // a longer text is not cut off, a shorter one takes no more than it needs
  if (meaning_->isVisible()) meaning_->setMinimumHeight(meaning_->heightForWidth(meaning_->width()));
  {
    const QSignalBlocker quietCompare(compare_), quietSlices(slices_), quietBefore(before_);
    colours_->setCurrentIndex(static_cast<int>(look_.colours));
    compare_->setChecked(look_.compare);
    slices_->setChecked(look_.slices);
    before_->setChecked(look_.before);
  }
  table_->show(made, document());
  targets_->setEnabled(!busy);
  truth_->setEnabled(!busy);
  saveSurface_->setEnabled(made && !busy);
  saveTargets_->setEnabled(made && !busy && !document().targets().points.empty());
  savePicture_->setEnabled(made && !busy);
}

}  // namespace falciform
