#include "Modules/ScanPreparation/ScanPreparationPanel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "Modules/ScanPreparation/ScanBrush.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {

namespace {

constexpr ScanMark kGoing[] = {ScanMark::Outlier, ScanMark::Grazing, ScanMark::SmallPiece,
                               ScanMark::OtherTissue, ScanMark::ByHand};

QString number(Index count) { return QString("%L1").arg(static_cast<qlonglong>(count)); }

}  // namespace

ScanPreparationPanel::ScanPreparationPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(
          workbench,
          tr("Turns a raw range scan into the liver's surface: false returns and all that is not liver "
             "are marked, mended by hand, and taken out. A scan that shows nothing but liver needs no "
             "preparation."),
          parent),
      logic_(document()),
      preview_(workbench.runner.mode()) {
  addOpen();
  addSettings();
  addMending();
  addFinish();
  connect(&preview_, &LatestRunner::failed, this, [this](const QString& message) {
    bench().log.error(message);
    showWarnings(warnings_, {message.toStdString()});
  });
  viewChanged_ = bench().view.changed.connect([this] { brush_->refresh(document().scan() != nullptr); });
  brushChanged_ = bench().view.brushChanged.connect([this] {
    brush_->refresh(document().scan() != nullptr);
    showCounts();
  });
  start();
}

ScanPreparationPanel::~ScanPreparationPanel() = default;

void ScanPreparationPanel::addOpen() {
  auto* open = new QPushButton(tr("Open scan…"), this);
  open->setObjectName("openScan");
  open->setToolTip(tr(
      "PLY, OBJ, VTK or VTP with colours or texture, PCD, XYZ or CSV, also as a raster, .rgbd, or a 16-bit "
      "PNG of depths with its camera beside it"));
  facts_ = wrappedLabel("scanFacts", this);
  unit_ = wrappedLabel("unitWords", this);
  column()->addWidget(open);
  column()->addWidget(facts_);
  column()->addWidget(unit_);
  connect(open, &QPushButton::clicked, this, [this] {
    const QString file = askForFile(
        tr("Open scan"), tr("Range scans (*.ply *.obj *.vtk *.vtp *.stl *.pcd *.xyz *.csv *.rgbd *.png)"));
    if (!file.isEmpty()) bench().files.open(file.toStdString(), FileRole::Scan);
  });
}

void ScanPreparationPanel::addSettings() {
  auto* group = addGroup(tr("What goes"));
  form_ =
      new SettingsForm(logic_.settings, {"unit", "extract", "colourLimit", "smooth", "spacingMm"}, {}, this);
  form_->setObjectName("scanSettings");
  group->addWidget(form_);
  auto* row = new QHBoxLayout;
  mark_ = new QPushButton(tr("Mark"), this);
  mark_->setObjectName("markScan");
  mark_->setToolTip(tr("Colour what goes by these settings; nothing is taken out yet"));
  live_ = new QCheckBox(tr("as settings change"), this);
  live_->setObjectName("markLive");
  live_->setToolTip(tr("Mark anew whenever a setting changes; the window stays usable meanwhile"));
  live_->setChecked(true);
  row->addWidget(mark_, 1);
  row->addWidget(live_);
  group->addLayout(row);
  missing_ = wrappedLabel("missing", this);
  group->addWidget(missing_);
  counts_ = wrappedLabel("markCounts", this);
  group->addWidget(counts_);
  connect(mark_, &QPushButton::clicked, this, &ScanPreparationPanel::mark);
  connect(form_, &SettingsForm::edited, this, &ScanPreparationPanel::settingsEdited);
}

void ScanPreparationPanel::addMending() {
  auto* group = addGroup(tr("Mend by hand"));
  brush_ = new ScanBrush(bench(), this);
  group->addWidget(brush_);
  connect(brush_, &ScanBrush::changed, this, [this] { refresh(); });
}

void ScanPreparationPanel::addFinish() {
  auto* row = new QHBoxLayout;
  apply_ = new QPushButton(tr("Take out what is marked"), this);
  apply_->setObjectName("applyScan");
  apply_->setToolTip(tr("Replace the case's scan by what stays of it, smoothed and thinned as set"));
  restore_ = new QPushButton(tr("Back to raw scan"), this);
  restore_->setObjectName("restoreScan");
  restore_->setToolTip(tr("The scan as it was opened; marks and strokes made here are forgotten"));
  row->addWidget(apply_, 1);
  row->addWidget(restore_);
  column()->addLayout(row);
  warnings_ = wrappedLabel("warnings", this);
  column()->addWidget(warnings_);
  showWarnings(warnings_, {});
  connect(apply_, &QPushButton::clicked, this, &ScanPreparationPanel::apply);
  connect(restore_, &QPushButton::clicked, this, [this] {
    preview_.drop();
    logic_.restoreRaw();
    showWarnings(warnings_, {});
  });
}

void ScanPreparationPanel::enter() {
  logic_.showMarks();
  targetBefore_ = bench().painting.target;
  labelBefore_ = bench().painting.label;
  bench().painting.target = PaintTarget::Scan;
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::ScanOnly;
    options.distanceShown = false;
  });
}

void ScanPreparationPanel::leave() {
  preview_.drop();
  bench().view.edit([](ViewOptions& options) { options.painting = false; });
  bench().painting.target = targetBefore_;
  bench().painting.label = labelBefore_;
  if (logic_.marked() && logic_.count(ScanMark::Kept) > 0 &&
      logic_.count(ScanMark::Kept) < (document().scan() ? document().scan()->size() : 0))
    bench().log.warn(tr("What was marked on the scan is still in it: take it out in Scan preparation."));
  logic_.hideMarks();
}

void ScanPreparationPanel::mark() {
  if (!logic_.missingInput().empty()) return;
  preview_.submit([job = logic_.prepareMarks()] { return job(Progress{}); },
                  [this](MarkedScan marked) {
                    showWarnings(warnings_, marked.warnings);
                    for (const std::string& warning : marked.warnings)
                      bench().log.warn(QString::fromStdString(warning));
                    logic_.acceptMarks(std::move(marked));
                    refresh();
                  });
  refresh();
}

void ScanPreparationPanel::settingsEdited() {
  // A finished scan is not marked again by a stray click: the raw one is a button away.
  const bool marking = logic_.marked() && logic_.count(ScanMark::Kept) > 0;
  if (live_->isChecked() && marking) mark();
  refresh();
}

void ScanPreparationPanel::apply() {
  preview_.drop();
  const auto scan = document().scan();
  bench().runner.start(tr("Preparing the scan"), logic_.prepareFinish(), [this, scan](Surface prepared) {
    if (document().scan() != scan) {
      bench().log.warn(tr("The scan was changed while it was prepared: the result is dropped."));
      return;
    }
    const Index before = scan->size();
    logic_.acceptFinish(std::move(prepared));
    bench().view.edit([](ViewOptions& options) { options.painting = false; });
    bench().log.info(tr("Prepared the scan: %1 of %2 points are left.")
                         .arg(number(document().scan()->size()), number(before)));
  });
}

void ScanPreparationPanel::showFacts() {
  const auto& scan = document().scan();
  unit_->setVisible(false);
  if (!scan) return facts_->setText(tr("No scan is open."));
  facts_->setText(tr("%1 points, %2 triangles, %3")
                      .arg(number(scan->size()), number(scan->triangles.rows()),
                           scan->texture              ? tr("with a photograph")
                           : scan->colours.rows() > 0 ? tr("with colours")
                                                      : tr("without colours")));
  const UnitGuess guess = logic_.unitGuess();
  if (guess.unit == LengthUnit::Millimetres) return;
  unit_->setVisible(true);
  const QString size = tr("The scan is %1 units long: ").arg(guess.extent, 0, 'g', 3);
  const QString unit = QString::fromStdString(enumToString(guess.unit));
  unit_->setText(QString::fromUtf8("⚠ ") + size +
                 (guess.certain ? tr("it is taken for %1 and scaled to mm when it is marked. Choose the unit "
                                     "below if that is wrong.")
                                : tr("is it in %1? Choose the unit below."))
                     .arg(unit));
}

void ScanPreparationPanel::showCounts() {
  if (preview_.busy()) return counts_->setText(tr("Marking…"));
  if (!logic_.marked() || logic_.count(ScanMark::Kept) == 0) return counts_->clear();
  QStringList parts{tr("%1 points stay").arg(number(logic_.count(ScanMark::Kept)))};
  for (const ScanMark mark : kGoing)
    if (const Index count = logic_.count(mark); count > 0)
      parts << QString("%1: %2").arg(QString::fromStdString(enumToString(mark)), number(count));
  counts_->setText(parts.join("\n"));
}

void ScanPreparationPanel::refresh() {
  showFacts();
  showCounts();
  showReadiness(mark_, missing_, logic_.missingInput());
  const bool marked = logic_.marked() && logic_.count(ScanMark::Kept) > 0;
  apply_->setEnabled(marked && !preview_.busy() && !bench().runner.busy());
  restore_->setEnabled(logic_.canRestore() && !bench().runner.busy());
  brush_->refresh(document().scan() != nullptr);
}

}  // namespace falciform
