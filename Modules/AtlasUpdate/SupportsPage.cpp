#include "Modules/AtlasUpdate/SupportsPage.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "Modules/AtlasUpdate/LiveDeformation.h"
#include "Modules/AtlasUpdate/SliderBox.h"
#include "Modules/AtlasUpdate/SupportBrush.h"
#include "Modules/AtlasUpdate/SupportTable.h"
#include "Modules/AtlasUpdate/SupportWords.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {

SupportsPage::SupportsPage(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench,
                  tr("How the liver deforms when it is packed, held or turned: paint what holds it, and move "
                     "the sliders. Computed, not measured: the scan has no part in it."),
                  parent),
      logic_(document()),
      live_(new LiveDeformation(logic_, workbench.view, workbench.runner.mode(), this)) {
  addModel();
  addSupports();
  addLive();
  viewChanged_ = bench().view.changed.connect([this] {
    if (entered_) refresh();
  });
  brushChanged_ = bench().view.brushChanged.connect([this] {
    if (entered_ && bench().painting.label > 0) chosen_ = bench().painting.label;
    if (entered_) refresh();
  });
  connect(live_, &LiveDeformation::changed, this, &SupportsPage::showLiver);
  start();
  showLiver();
}

SupportsPage::~SupportsPage() = default;

void SupportsPage::addModel() {
  auto* group = addGroup(tr("Model of the liver"));
  modelForm_ =
      new SettingsForm(logic_.settings, {"edgeLengthMm", "youngsModulusKPa", "poissonsRatio"}, {}, this);
  modelForm_->setObjectName("modelSettings");
  group->addWidget(modelForm_);
  prepare_ = new QPushButton(tr("Prepare the model"), this);
  prepare_->setObjectName("prepareModel");
  prepare_->setToolTip(
      tr("Fills the liver with elements and factorises their stiffness, once; takes seconds, more for a "
         "shorter edge length (mm)"));
  group->addWidget(prepare_);
  missing_ = wrappedLabel("missing", this);
  group->addWidget(missing_);
  facts_ = wrappedLabel("modelFacts", this);
  group->addWidget(facts_);
  connect(prepare_, &QPushButton::clicked, this, &SupportsPage::prepareModel);
  connect(modelForm_, &SettingsForm::edited, this, [this] { refresh(); });
}

void SupportsPage::addSupports() {
  auto* group = addGroup(tr("Supports"));
  templateForm_ =
      new SettingsForm(logic_.templateSettings, {"posture", "extentMm"}, {"pushMm", "turnDeg"}, this);
  templateForm_->setObjectName("templateSettings");
  group->addWidget(templateForm_);
  fill_ = new QPushButton(tr("Fill from template"), this);
  fill_->setObjectName("fillTemplate");
  fill_->setToolTip(
      tr("Paints the template's supports, placed by the falciform patch and the liver's shape, in place of "
         "what is painted; can be undone and edited"));
  group->addWidget(fill_);
  table_ = new SupportTable(this);
  group->addWidget(table_);
  push_ = new SliderBox("pushMm", {0, 45, 0.5, -kMaxPushMm, kMaxPushMm}, " mm", this);
  push_->setTip(
      tr("How far the chosen support is pushed into the liver, along the surface's normal; below 0 it is "
         "pulled.\nUnit: mm\nRange: -60 to 60 (slider 0 to 45)\nDefault: 20"));
  auto* pushRow = new QFormLayout;
  pushRow->addRow(tr("Push"), push_);
  group->addLayout(pushRow);
  brush_ = new SupportBrush(bench(), this);
  group->addWidget(brush_);
  connect(fill_, &QPushButton::clicked, this, &SupportsPage::fillTemplate);
  connect(table_, &SupportTable::kindChosen, this, [this](int label, SupportRegionKind kind) {
    edit([&](SupportPainting& painting) { painting.regions[label].kind = kind; });
  });
  connect(push_, &SliderBox::moved, this, [this](double mm) {
    edit([&](SupportPainting& painting) { painting.regions[chosen_].pushMm = mm; });
  });
  connect(table_, &SupportTable::choiceMade, this, &SupportsPage::choose);
  connect(brush_, &SupportBrush::changed, this, [this] { refresh(); });
  connect(brush_, &SupportBrush::newRegionWanted, this, [this] {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("New support"), tr("Name of the support:"),
                                               QLineEdit::Normal, {}, &accepted);
    if (accepted && !name.trimmed().isEmpty()) addRegion(name.trimmed());
  });
}

void SupportsPage::addLive() {
  auto* group = addGroup(tr("The liver as it is held"));
  auto* form = new QFormLayout;
  turn_ = new SliderBox("turnDeg", {-45, 45, 1, -90, 90}, QString::fromUtf8("°"), this);
  turn_->setTip(
      tr("Patient and table turned onto the left side since the CT, below 0 onto the right: gravity "
         "pulls the other way.\nUnit: degrees\nRange: -90 to 90 (slider -45 to 45)\nDefault: 0"));
  form->addRow(tr("Turn to the left"), turn_);
  group->addLayout(form);
  colours_ = new QCheckBox(tr("Colour by displacement"), this);
  colours_->setObjectName("displacementColours");
  colours_->setToolTip(
      tr("How far each place has moved, in mm; off: the painted supports on the moved liver"));
  group->addWidget(colours_);
  liveMissing_ = wrappedLabel("liveMissing", this);
  figures_ = wrappedLabel("deformationFigures", this);
  warnings_ = wrappedLabel("deformationWarnings", this);
  for (QLabel* words : {liveMissing_, figures_, warnings_}) group->addWidget(words);
  connect(turn_, &SliderBox::moved, this,
          [this](double degrees) { edit([&](SupportPainting& painting) { painting.turnDeg = degrees; }); });
  connect(colours_, &QCheckBox::toggled, this, [this](bool on) {
    bench().view.edit([&](ViewOptions& options) { options.displacementColours = on; });
  });
}

void SupportsPage::enter() {
  entered_ = true;
  targetBefore_ = bench().painting.target;
  labelBefore_ = bench().painting.label;
  bench().painting.target = PaintTarget::Supports;
  bench().painting.label = chosen_;
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::PreopOnly;
    options.distanceShown = false;
    options.supportsShown = true;
  });
  live_->update();
  refresh();
}

void SupportsPage::leave() {
  entered_ = false;
  bench().view.edit([](ViewOptions& options) { options.painting = options.supportsShown = false; });
  live_->hide();
  bench().painting.target = targetBefore_;
  bench().painting.label = labelBefore_;
}

void SupportsPage::caseChanged(Case::Part part) {
  if (entered_ && (part == Case::Part::Supports || part == Case::Part::Preop)) live_->update();
}

void SupportsPage::prepareModel() {
  bench().runner.start(
      tr("Preparing the model"), logic_.prepare(), [this](std::shared_ptr<const SupportModel> model) {
        if (!logic_.accept(std::move(model))) {
          bench().log.warn(tr("The liver changed while its model was prepared: it is dropped."));
          return;
        }
        bench().log.info(tr("Model ready: %1").arg(modelWords(*logic_.model())));
        for (const std::string& warning : modelWarnings(*logic_.model()))
          bench().log.warn(QString::fromStdString(warning));
        if (entered_) live_->update();
      });
}

void SupportsPage::fillTemplate() {
  if (!logic_.model() || bench().painting.inStroke()) return;
  SupportPainting filled = logic_.templatePainting();
  const std::vector<int> labels = filled.labels;
  // Kinds and distances first, labels then as one step of the brush, which undo takes back.
  filled.labels = logic_.supports()->labels;
  document().setSupports(std::make_shared<const SupportPainting>(std::move(filled)));
  (void)bench().painting.replaceLabels(labels);
  refresh();
}

void SupportsPage::choose(int label) {
  chosen_ = label;
  if (entered_) bench().painting.label = label;
  refresh();
}

void SupportsPage::addRegion(const QString& name) {
  if (!logic_.supports()) return;
  int next = support_label::kFirstNamed;
  while (logic_.supports()->regions.contains(next)) ++next;
  if (next > support_label::kMax) return;
  edit([&](SupportPainting& painting) {
    painting.regions[next] = {name.toStdString(), SupportRegionKind::Fixed, 0};
  });
  choose(next);
}

void SupportsPage::edit(const std::function<void(SupportPainting&)>& change) {
  if (!logic_.supports()) return;
  SupportPainting painting = *logic_.supports();
  change(painting);
  document().setSupports(std::make_shared<const SupportPainting>(std::move(painting)));
}

void SupportsPage::refresh() {
  showReadiness(prepare_, missing_, logic_.missingInput());
  facts_->setText(modelState(logic_));
  facts_->setVisible(logic_.missingInput().empty());
  const auto supports = logic_.supports();
  fill_->setEnabled(logic_.model() != nullptr);
  table_->show(supports);
  table_->setEnabled(supports != nullptr);
  {
    const QSignalBlocker quiet(table_);
    table_->choose(chosen_);
  }
  brush_->refresh(supports ? chosen_ : 0);
  const auto region =
      supports ? supports->regions.find(chosen_) : std::map<int, SupportRegion>::const_iterator{};
  const bool pushed =
      supports && region != supports->regions.end() && region->second.kind == SupportRegionKind::Pushed;
  push_->setEnabled(pushed);
  push_->setValue(pushed ? region->second.pushMm : 0);
  turn_->setEnabled(supports != nullptr);
  turn_->setValue(supports ? supports->turnDeg : 0);
  {
    const QSignalBlocker quiet(colours_);
    colours_->setChecked(bench().view.options().displacementColours);
  }
}

void SupportsPage::showLiver() {
  const SupportLogic::Answer* shown = live_->shown();
  liveMissing_->setText(shown ? QString() : !live_->missing().isEmpty() ? live_->missing() : tr("At rest."));
  liveMissing_->setVisible(!shown);
  figures_->setText(shown ? deformationWords(shown->liver) : QString());
  figures_->setVisible(shown != nullptr);
  showWarnings(warnings_, shown ? deformationWarnings(*shown) : std::vector<std::string>{});
}

}  // namespace falciform
