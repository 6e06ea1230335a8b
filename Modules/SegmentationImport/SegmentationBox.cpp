#include "Modules/SegmentationImport/SegmentationBox.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Forms/PanelControls.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {
namespace {

constexpr int kPollMs = 100;

QLabel* wordsOf(const char* name, QWidget* parent) {
  QLabel* label = wrappedLabel(name, parent);
  label->hide();
  return label;
}

}  // namespace

SegmentationBox::SegmentationBox(Workbench& workbench, QWidget* parent)
    : QWidget(parent), bench_(workbench), logic_(workbench.document), sketching_(workbench.runner.mode()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  addTools();
  addSeedTable();
  addRun();
  connect(&sketching_, &LatestRunner::failed, this, [this](const QString& why) { bench_.log.error(why); });
  poll_.setInterval(kPollMs);
  connect(&poll_, &QTimer::timeout, this, &SegmentationBox::showLive);
  // Whatever way it ended; before the result is put away this is too early.
  connect(&bench_.runner, &JobRunner::finished, this, [this] {
    if (live_ && !bench_.runner.busy()) endLive();
  });
  connect(&bench_.runner, &JobRunner::progressed, this, [this](double fraction, const QString&) {
    if (live_) bar_->setValue(static_cast<int>(fraction * bar_->maximum()));
  });
  viewChanged_ = bench_.view.changed.connect([this] {
    logic_.brushMm = bench_.view.options().sliceBrushMm;
    showTools();
  });
  touched_ = bench_.view.touched.connect([this](const SliceTouch& touch) {
    if (onScreen_) this->touch(touch);
  });
}

void SegmentationBox::addTools() {
  const QString how = tr("\nWhile on, Ctrl with the left button moves the cut's cursor; Esc ends it");
  seed_ = wideToolButton(
      "addSeed", tr("Add seed"),
      tr("Clicks in a slice say: here is liver. The first in plain tissue away from vessels, one "
         "in each lobe, one in a tumour that is to be taken in") +
          how,
      this);
  paint_ = wideToolButton(
      "paintLabel", tr("Paint"),
      tr("A ball-shaped brush adds to the label map: the label of the row chosen below") + how, this);
  erase_ = wideToolButton(
      "eraseLabel", tr("Not here"),
      tr("A ball-shaped brush takes away, and keeps the front out when it continues") + how, this);
  undo_ =
      wideToolButton("undoSegmentation", tr("Undo"),
                     tr("Take back the last seed, stroke or segmentation (Z in a slice); 50 steps"), this);
  redo_ = wideToolButton("redoSegmentation", tr("Redo"), tr("Bring it back (Y in a slice)"), this);
  radius_ = new NumberBox(this);
  radius_->setObjectName("labelBrushRadius");
  radius_->setRange(0.5, 60);
  radius_->setSuffix(" mm");
  radius_->setToolTip(tr(
      "Radius of the brush, a ball. Shift+wheel, + and - over a slice change it too.\nUnit: mm\nRange: 0.5 "
      "to 60\nDefault: 8"));
  auto *tools = new QHBoxLayout, *more = new QHBoxLayout;
  for (QToolButton* button : {seed_, paint_, erase_}) {
    button->setCheckable(true);
    tools->addWidget(button, 1);
  }
  more->addWidget(new QLabel(tr("Brush"), this));
  more->addWidget(radius_, 1);
  more->addWidget(undo_);
  more->addWidget(redo_);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addLayout(tools);
  column->addLayout(more);
  connect(seed_, &QToolButton::clicked, this, [this](bool on) { choose(SliceTool::Seed, on); });
  connect(paint_, &QToolButton::clicked, this, [this](bool on) { choose(SliceTool::Paint, on); });
  connect(erase_, &QToolButton::clicked, this, [this](bool on) { choose(SliceTool::Erase, on); });
  connect(undo_, &QToolButton::clicked, this, [this] { take(true); });
  connect(redo_, &QToolButton::clicked, this, [this] { take(false); });
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double mm) { bench_.view.edit([mm](ViewOptions& options) { options.sliceBrushMm = mm; }); });
}

void SegmentationBox::addSeedTable() {
  seeds_ = new QTableWidget(0, 4, this);
  seeds_->setObjectName("seedTable");
  seeds_->setToolTip(tr("Seeds in patient LPS, mm, with the CT's value in HU; choose one to go there"));
  seeds_->setHorizontalHeaderLabels({tr("x, mm"), tr("y, mm"), tr("z, mm"), tr("HU")});
  seeds_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  seeds_->setSelectionBehavior(QAbstractItemView::SelectRows);
  seeds_->setSelectionMode(QAbstractItemView::SingleSelection);
  seeds_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  removeSeed_ = new QPushButton(tr("Remove seed"), this);
  removeSeed_->setObjectName("removeSeed");
  removeSeed_->setToolTip(tr("Take the chosen seed away, or the last one"));
  clearSeeds_ = new QPushButton(tr("Remove all"), this);
  clearSeeds_->setObjectName("clearSeeds");
  clearSeeds_->setToolTip(tr("Take all seeds away"));
  auto* row = new QHBoxLayout;
  row->addWidget(removeSeed_);
  row->addWidget(clearSeeds_);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(seeds_);
  column->addLayout(row);
  connect(seeds_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int chosen = seeds_->currentRow();
    if (chosen >= 0 && chosen < logic_.seeds().rows())
      bench_.view.wanderTo.emit(logic_.seeds().row(chosen).transpose());
  });
  connect(removeSeed_, &QPushButton::clicked, this, [this] {
    const auto chosen = seeds_->selectionModel()->selectedRows();
    logic_.removeSeed(chosen.isEmpty() ? logic_.seeds().rows() - 1 : chosen.front().row());
    showSeeds();
  });
  connect(clearSeeds_, &QPushButton::clicked, this, [this] {
    logic_.clearSeeds();
    showSeeds();
  });
}

void SegmentationBox::addRun() {
  form_ = new SettingsForm(logic_.settings, {"tissueWidth"}, {}, this);
  form_->setObjectName("levelSetSettings");
  segment_ = new QPushButton(tr("Segment"), this);
  segment_->setObjectName("segment");
  segment_->setToolTip(
      tr("Grow the liver from the seeds; replaces the label map (Undo brings it back). What was erased stays "
         "out"));
  continue_ = new QPushButton(tr("Continue"), this);
  continue_->setObjectName("continueSegmentation");
  continue_->setToolTip(
      tr("Go on from the label map as it is, mended by brush: what is painted stays, what is erased stays "
         "out, new seeds grow"));
  stop_ = new QPushButton(tr("Stop"), this);
  stop_->setObjectName("stopSegmentation");
  stop_->setToolTip(tr("Stop the front and keep it as it stands"));
  save_ = new QPushButton(tr("Save labels…"), this);
  save_->setObjectName("saveLabels");
  save_->setToolTip(tr("Write the label map: .nii.gz, .nii, .nrrd or .mha"));
  bar_ = new QProgressBar(this);
  bar_->setObjectName("segmentProgress");
  bar_->setRange(0, 1000);
  bar_->setToolTip(tr("Share of the segmentation that is done, in %"));
  bar_->hide();
  missing_ = wordsOf("segmentMissing", this);
  result_ = wordsOf("segmentResult", this);
  places_ = wordsOf("segmentPlaces", this);
  places_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  warnings_ = wordsOf("segmentWarnings", this);
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {segment_, continue_, stop_}) row->addWidget(button, 1);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(form_);
  column->addLayout(row);
  for (QWidget* widget :
       {static_cast<QWidget*>(bar_), static_cast<QWidget*>(missing_), static_cast<QWidget*>(result_),
        static_cast<QWidget*>(warnings_), static_cast<QWidget*>(places_), static_cast<QWidget*>(save_)})
    column->addWidget(widget);
  connect(segment_, &QPushButton::clicked, this, [this] { segment(false); });
  connect(continue_, &QPushButton::clicked, this, [this] { segment(true); });
  connect(stop_, &QPushButton::clicked, this, [this] {
    stop_->setEnabled(false);
    bench_.runner.cancel();
  });
  connect(save_, &QPushButton::clicked, this, &SegmentationBox::saveLabels);
  connect(places_, &QLabel::linkActivated, this, [this](const QString& link) {
    const QStringList mm = link.split(',');
    if (mm.size() == 3) bench_.view.wanderTo.emit({mm[0].toDouble(), mm[1].toDouble(), mm[2].toDouble()});
  });
}

}  // namespace falciform
