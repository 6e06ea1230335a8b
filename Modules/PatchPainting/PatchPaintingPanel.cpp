#include "Modules/PatchPainting/PatchPaintingPanel.h"

#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Patches/CrestStrength.h"
#include "Logic/Patches/PatchStatistics.h"
#include "Logic/Patches/PatchTransfer.h"
#include "Modules/PatchPainting/BrushControls.h"
#include "Modules/PatchPainting/PatchList.h"
#include "Modules/PatchPainting/PatchOperations.h"
#include "Modules/PatchPainting/SuggestionBox.h"
#include "Widgets/Forms/NumberBox.h"

namespace falciform {

PatchPaintingPanel::PatchPaintingPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(
          workbench,
          tr("Marks the same features on the pre-operative liver and on the scan: the falciform ligament's "
             "groove and the inferior ridge."),
          parent),
      brush_(new BrushControls(workbench.painting, this)),
      list_(new PatchList(workbench, this)),
      operations_(new PatchOperations(workbench, this)),
      suggestions_(new SuggestionBox(workbench, this)) {
  addTarget();
  addPatches();
  addGroup(tr("Suggest"))->addWidget(suggestions_);
  addTools();
  warnings_ = wrappedLabel("warnings", this);
  column()->addWidget(warnings_);
  addGroup(tr("Whole patch"))->addWidget(operations_);
  addTransfer();
  brushChanged_ = bench().view.brushChanged.connect([this] { refresh(); });
  viewChanged_ = bench().view.changed.connect([this] { refresh(); });
  connect(brush_, &BrushControls::changed, this, [this] {
    measureCrests();
    bench().view.brushChanged.emit();
  });
  connect(operations_, &PatchOperations::changed, this, [this] { refresh(); });
  connect(suggestions_, &SuggestionBox::accepted, this, [this](int label) { choosePatch(label); });
  start();
}

void PatchPaintingPanel::addTarget() {
  auto* group = addGroup(tr("Paint on"));
  auto* row = new QHBoxLayout;
  preop_ = new QRadioButton(tr("&Pre-op liver"), this);
  preop_->setObjectName("paintOnPreop");
  preop_->setToolTip(tr("Paint on the pre-operative surface"));
  scan_ = new QRadioButton(tr("S&can"), this);
  scan_->setObjectName("paintOnScan");
  scan_->setToolTip(tr("Paint on the intra-operative scan"));
  row->addWidget(preop_);
  row->addWidget(scan_);
  group->addLayout(row);
  connect(preop_, &QRadioButton::clicked, this, [this] { setTarget(PaintTarget::Preop); });
  connect(scan_, &QRadioButton::clicked, this, [this] { setTarget(PaintTarget::Scan); });
}

void PatchPaintingPanel::addPatches() {
  column()->addWidget(list_);  // without a frame: names need the room
  newPatch_ = new QPushButton(tr("&New…"), this);
  newPatch_->setObjectName("newPatch");
  newPatch_->setToolTip(
      tr("Name another patch, for example the gallbladder fossa; it is there for both surfaces"));
  colour_ = new QPushButton(tr("C&olour…"), this);
  colour_->setObjectName("patchColour");
  colour_->setToolTip(tr("Choose the marked patch's colour, on both surfaces"));
  clear_ = new QPushButton(tr("Clear patch"), this);
  clear_->setObjectName("clearPatch");
  clear_->setToolTip(tr("Remove the marked patch from the chosen surface; can be undone"));
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {newPatch_, colour_, clear_}) row->addWidget(button);
  column()->addLayout(row);
  connect(list_, &PatchList::picked, this, &PatchPaintingPanel::choosePatch);
  connect(list_, &PatchList::edited, this, [this] { refresh(); });
  connect(colour_, &QPushButton::clicked, list_, &PatchList::askColour);
  connect(clear_, &QPushButton::clicked, this,
          [this] { (void)bench().painting.clearPatch(list_->chosen()), refresh(); });
  connect(newPatch_, &QPushButton::clicked, this, [this] {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("New patch"), tr("Name of the patch:"),
                                               QLineEdit::Normal, {}, &accepted);
    if (!accepted || name.trimmed().isEmpty()) return;
    if (const int label = list_->addNamed(name.trimmed())) choosePatch(label);
  });
}

// Choosing a patch means to paint it.
void PatchPaintingPanel::choosePatch(int label) {
  bench().painting.label = chosen_ = label;
  bench().view.brushChanged.emit();
}

void PatchPaintingPanel::addTools() {
  auto* group = addGroup(tr("Paint"));
  group->addWidget(brush_);
  paint_ = new QPushButton(tr("Paint"), this);
  paint_->setObjectName("paint");
  paint_->setCheckable(true);
  paint_->setToolTip(
      tr("While on, dragging with the left button paints; Ctrl, Shift or Alt with the mouse turns the view;\n"
         "Esc ends painting"));
  undo_ = new QPushButton(tr("Undo"), this);
  undo_->setObjectName("undo");
  undo_->setToolTip(tr("Take the last stroke back (Z); up to 200 strokes"));
  redo_ = new QPushButton(tr("Redo"), this);
  redo_->setObjectName("redo");
  redo_->setToolTip(tr("Bring the stroke back (Y)"));
  auto* row = new QHBoxLayout;
  for (QPushButton* button : {undo_, redo_}) row->addWidget(button);
  group->addWidget(paint_);
  group->addLayout(row);
  missing_ = wrappedLabel("missing", this);
  group->addWidget(missing_);
  connect(paint_, &QPushButton::toggled, this,
          [this](bool on) { bench().view.edit([&](ViewOptions& options) { options.painting = on; }); });
  connect(undo_, &QPushButton::clicked, this, [this] { (void)bench().painting.undo(), refresh(); });
  connect(redo_, &QPushButton::clicked, this, [this] { (void)bench().painting.redo(), refresh(); });
}

void PatchPaintingPanel::addTransfer() {
  auto* group = addGroup(tr("Take patches from another surface"));
  auto* row = new QHBoxLayout;
  auto* radius = new NumberBox(this);
  radius->setObjectName("transferRadius");
  radius->setRange(0.1, 50);
  radius->setSuffix(" mm");
  radius->setValue(transferRadiusMm_);
  radius->setToolTip(
      tr("A point takes the patch of the nearest painted point of the other surface within this distance.\n"
         "Unit: mm\nRange: 0.1 to 50\nDefault: 3"));
  transfer_ = new QPushButton(tr("Transfer…"), this);
  transfer_->setObjectName("transfer");
  transfer_->setToolTip(
      tr("Choose a painted surface file in the same frame; its patches are laid onto the chosen surface"));
  row->addWidget(new QLabel(tr("Within"), this));
  row->addWidget(radius, 1);
  row->addWidget(transfer_);
  group->addLayout(row);
  connect(radius, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double mm) { transferRadiusMm_ = mm; });
  connect(transfer_, &QPushButton::clicked, this, [this] {
    const QString file = askForFile(tr("Open painted surface"), tr("Painted surfaces (*.vtp *.vtk *.ply)"));
    if (!file.isEmpty()) transferFrom(file);
  });
}

std::shared_ptr<const Surface> PatchPaintingPanel::targetSurface() {
  return bench().painting.target == PaintTarget::Preop ? document().preop() : document().scan();
}

void PatchPaintingPanel::enter() {
  bench().painting.tool = tool_;
  bench().painting.replaces = replaces_;
  applyArrangement();
  refresh();
}

// Other steps paint with the brush alone.
void PatchPaintingPanel::leave() {
  tool_ = std::exchange(bench().painting.tool, PaintTool::Brush);
  replaces_ = bench().painting.replaces;
  bench().view.edit([](ViewOptions& options) {
    options.painting = false;
    options.suggestedLine.reset();
  });
}

void PatchPaintingPanel::setTarget(PaintTarget target) {
  bench().painting.target = target;
  applyArrangement();
  refresh();
}

void PatchPaintingPanel::applyArrangement() {
  const bool onScan = bench().painting.target == PaintTarget::Scan;
  bench().view.edit([&](ViewOptions& options) {
    options.arrangement = onScan ? Arrangement::ScanOnly : Arrangement::PreopOnly;
    options.distanceShown = false;
  });
}

void PatchPaintingPanel::refresh() {
  const bool onScan = bench().painting.target == PaintTarget::Scan;
  (onScan ? scan_ : preop_)->setChecked(true);
  if (bench().painting.target != PaintTarget::Supports && bench().painting.label > 0)
    chosen_ = bench().painting.label;
  list_->follow(targetSurface(), chosen_);
  brush_->refresh(chosen_);
  showReadiness(paint_, missing_, bench().painting.missingInput());
  // A job works on its own snapshot, so painting may go on; only what is missing stops it.
  const bool canPaint = bench().painting.missingInput().empty();
  paint_->setEnabled(canPaint);
  {
    const QSignalBlocker quiet(paint_);
    paint_->setChecked(bench().view.options().painting);
  }
  paint_->setText(bench().view.options().painting ? tr("Stop painting (Esc)") : tr("Paint"));
  if (canPaint) {
    const PartLook look = bench().view.look(onScan ? part::kScan : part::kPreop);
    missing_->setText(!look.visible
                          ? tr("The surface is hidden: tick it in the case tree to see what you paint.")
                      : !bench().view.patchLook(chosen_).visible
                          ? tr("The marked patch is hidden: tick it in the list to see what you paint.")
                          : QString::fromStdString(bench().painting.refusal()));
    missing_->setVisible(!missing_->text().isEmpty());
  }
  undo_->setEnabled(bench().painting.canUndo());
  redo_->setEnabled(bench().painting.canRedo());
  clear_->setEnabled(canPaint && !bench().painting.locked().count(chosen_));
  newPatch_->setEnabled(document().preop() || document().scan());
  operations_->refresh(chosen_);
  suggestions_->refresh();
  transfer_->setEnabled(targetSurface() != nullptr && !bench().runner.busy());
  if (document().preop() && document().scan())
    showWarnings(warnings_, patchWarnings(*document().preop(), *document().scan()));
  else
    showWarnings(warnings_, {});
}

void PatchPaintingPanel::measureCrests() {
  PatchPaintingLogic& painting = bench().painting;
  const auto surface = targetSurface();
  if (painting.tool != PaintTool::Line || painting.snap == PathSnap::None || painting.pathCost() || !surface)
    return;
  bench().runner.start(
      tr("Measuring how sharp the surface is"),
      [surface, snap = painting.snap](const Progress& progress) {
        progress.report(0, "fitting the surface around each point");
        return std::make_shared<const VectorXd>(
            crestCost(*surface, snap == PathSnap::Ridge ? CrestKind::Ridge : CrestKind::Valley));
      },
      [this, surface, snap = painting.snap](const std::shared_ptr<const VectorXd>& cost) {
        bench().painting.setPathCost(surface, snap, cost);
      });
}

void PatchPaintingPanel::transferFrom(const QString& file) {
  const auto onto = targetSurface();
  const PaintTarget target = bench().painting.target;
  bench().runner.start(
      tr("Transferring patches"),
      [onto, path = file.toStdString(), radius = transferRadiusMm_](const Progress& progress) {
        progress.report(0, "reading the painted surface");
        const Surface from = readSurface(path).value;
        if (patchLabels(from).empty())
          throw InputError(path + " has no painted patch; choose a surface with a Patch array");
        progress.report(0.5, "finding nearest painted points");
        auto painted = std::make_shared<Surface>(*onto);
        painted->patch = transferPatches(from, *onto, radius, true);
        painted->patchNames.insert(from.patchNames.begin(), from.patchNames.end());
        return std::shared_ptr<const Surface>(painted);
      },
      [this, target](const std::shared_ptr<const Surface>& painted) {
        if (target == PaintTarget::Preop)
          document().setPreop(painted);
        else
          document().setScan(painted);
        bench().log.info(tr("Transferred patches."));
      });
}

}  // namespace falciform
