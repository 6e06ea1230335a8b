#include "Modules/ScanPreparation/ScanBrush.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "Logic/Acquisition/ScanPreparationLogic.h"
#include "Widgets/Forms/NumberBox.h"

namespace falciform {

ScanBrush::ScanBrush(Workbench& workbench, QWidget* parent)
    : QWidget(parent), bench_(workbench), radius_(new NumberBox(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* modes = new QHBoxLayout;
  auto* steps = new QHBoxLayout;
  column->addLayout(modes);
  column->addLayout(steps);
  const auto button = [this](QHBoxLayout* row, const char* name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(name);
    made->setToolTip(tip);
    row->addWidget(made);
    return made;
  };
  const QString how =
      tr("\nWhile on, the left button paints. Ctrl, Shift or Alt with the mouse turns the view; Esc ends it");
  keep_ = button(modes, "paintKeep", tr("Keep"),
                 tr("Brush: what is painted stays, whatever the marks say") + how);
  remove_ = button(modes, "paintRemove", tr("Remove"), tr("Brush: what is painted goes") + how);
  liver_ = button(
      modes, "paintLiver", tr("Here is liver"),
      tr("Brush: a dab on the liver tells its colour; others on the ligament or a pale spot bring these "
         "in. Mark again afterwards") +
          how);
  for (const auto& [made, label] : {std::pair(keep_, patch::kNone), std::pair(remove_, scan_label::kByHand),
                                    std::pair(liver_, scan_label::kSeed)}) {
    made->setCheckable(true);
    connect(made, &QPushButton::clicked, this, [this, of = label](bool on) { choose(of, on); });
  }
  radius_->setObjectName("scanBrushRadius");
  radius_->setRange(0.5, 60);
  radius_->setSuffix(" mm");
  radius_->setToolTip(
      tr("Brush radius along the scan. Shift+wheel or + and - over the view change it too.\nUnit: mm\nRange: "
         "0.5 to 60\nDefault: 6"));
  steps->addWidget(radius_);
  undo_ = button(steps, "undoScan", tr("Undo"),
                 tr("Take the last stroke back (Z); up to 200 since the last marks"));
  redo_ = button(steps, "redoScan", tr("Redo"), tr("Bring it back (Y)"));
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double mm) { bench_.painting.radiusMm = mm; });
  connect(undo_, &QPushButton::clicked, this, [this] { (void)bench_.painting.undo(), Q_EMIT changed(); });
  connect(redo_, &QPushButton::clicked, this, [this] { (void)bench_.painting.redo(), Q_EMIT changed(); });
}

void ScanBrush::choose(int label, bool on) {
  bench_.painting.target = PaintTarget::Scan;
  bench_.painting.label = label;
  bench_.painting.tool = PaintTool::Brush;
  bench_.painting.replaces = true;  // over whatever is marked
  bench_.view.edit([&](ViewOptions& options) { options.painting = on; });
  refresh(true);
}

void ScanBrush::refresh(bool ready) {
  const bool on = bench_.view.options().painting && bench_.painting.target == PaintTarget::Scan;
  const int label = bench_.painting.label;
  for (const auto& [made, own] : {std::pair(keep_, patch::kNone), std::pair(remove_, scan_label::kByHand),
                                  std::pair(liver_, scan_label::kSeed)}) {
    made->setEnabled(ready);
    made->setChecked(on && label == own);
  }
  const QSignalBlocker quiet(radius_);
  radius_->setEnabled(ready);
  radius_->setValue(bench_.painting.radiusMm);
  undo_->setEnabled(ready && bench_.painting.canUndo());
  redo_->setEnabled(ready && bench_.painting.canRedo());
}

}  // namespace falciform
