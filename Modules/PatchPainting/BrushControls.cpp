#include "Modules/PatchPainting/BrushControls.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Forms/PanelControls.h"

namespace falciform {
namespace {

enum Mode { kAdd, kReplace, kErase };

void addButton(QButtonGroup* group, QHBoxLayout* row, int id, const char* name, const QString& text,
               const QString& tip, QWidget* parent) {
  QToolButton* button = wideToolButton(name, text, tip, parent);
  button->setCheckable(true);
  group->addButton(button, id);
  row->addWidget(button);
}

QString hintOf(PaintTool tool) {
  switch (tool) {
    case PaintTool::Brush:
      return BrushControls::tr("Drag to paint. Shift+wheel, + and - change the radius.");
    case PaintTool::Line:
      return BrushControls::tr(
          "Click along the feature; Enter or a double click paints the line, Backspace takes the last point "
          "back, Esc drops it.");
    case PaintTool::Lasso:
      return BrushControls::tr("Drag around what is to be painted: all that is seen inside is taken.");
    case PaintTool::Fill:
      return BrushControls::tr("Click into a part that a closed border of paint surrounds.");
  }
  return {};
}

}  // namespace

BrushControls::BrushControls(PatchPaintingLogic& painting, QWidget* parent)
    : QWidget(parent),
      painting_(painting),
      tools_(new QButtonGroup(this)),
      modes_(new QButtonGroup(this)),
      radius_(new NumberBox(this)),
      snap_(new QComboBox(this)),
      hint_(new QLabel(this)) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  auto* toolRow = new QHBoxLayout;
  addButton(tools_, toolRow, static_cast<int>(PaintTool::Brush), "toolBrush", tr("&Brush"),
            tr("Paints where the mouse is dragged (Alt+B)"), this);
  addButton(
      tools_, toolRow, static_cast<int>(PaintTool::Line), "toolLine", tr("&Line"),
      tr("Lays a line over the surface from click to click, the shortest way, and paints along it (Alt+L)"),
      this);
  addButton(tools_, toolRow, static_cast<int>(PaintTool::Lasso), "toolLasso", tr("La&sso"),
            tr("Paints all that is seen inside a line drawn around it (Alt+S)"), this);
  addButton(tools_, toolRow, static_cast<int>(PaintTool::Fill), "toolFill", tr("F&ill"),
            tr("Paints the whole part that is clicked, up to where other paint begins (Alt+I)"), this);
  form->addRow(tr("Tool"), toolRow);
  auto* modeRow = new QHBoxLayout;
  addButton(modes_, modeRow, kAdd, "brushAdd", tr("A&dd"),
            tr("Paints where nothing is painted; other patches are left alone (Alt+D)"), this);
  addButton(modes_, modeRow, kReplace, "brushReplace", tr("&Replace"),
            tr("Paints over other patches too, unless they are locked (Alt+R)"), this);
  addButton(modes_, modeRow, kErase, "brushErase", tr("Er&ase"),
            tr("Removes any patch that is not locked (Alt+A; key 0 over the view)"), this);
  form->addRow(tr("Mode"), modeRow);

  radius_->setObjectName("brushRadius");
  radius_->setRange(0.5, 60);
  radius_->setSuffix(" mm");
  radius_->setToolTip(tr(
      "Radius of the brush along the surface, and half of the width of a line. Shift+wheel or + and - over "
      "the view change it too.\nUnit: mm\nRange: 0.5 to 60\nDefault: 6"));
  form->addRow(tr("Radius"), radius_);
  snap_->setObjectName("pathSnap");
  snap_->addItems({tr("nothing: the shortest way"), tr("the ridge"), tr("the groove")});
  snap_->setToolTip(tr(
      "What a line is drawn to between two clicks: the edge (sharp outwards) or the groove (sharp inwards).\n"
      "How sharp the surface is is measured once, which takes a second or so"));
  form->addRow(tr("Snap to"), snap_);
  hint_->setObjectName("toolHint");
  hint_->setWordWrap(true);
  form->addRow(hint_);

  for (QButtonGroup* group : {tools_, modes_})
    connect(group, qOverload<QAbstractButton*>(&QButtonGroup::buttonClicked), this, &BrushControls::apply);
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &BrushControls::apply);
  connect(snap_, qOverload<int>(&QComboBox::activated), this, &BrushControls::apply);
  refresh(chosen_);
}

void BrushControls::apply() {
  painting_.tool = static_cast<PaintTool>(tools_->checkedId());
  painting_.label = modes_->checkedId() == kErase ? patch::kNone : chosen_;
  painting_.replaces = modes_->checkedId() == kReplace;
  painting_.radiusMm = radius_->value();
  painting_.snap = static_cast<PathSnap>(snap_->currentIndex());
  Q_EMIT changed();
}

void BrushControls::refresh(int chosen) {
  const QSignalBlocker quietRadius(radius_);
  chosen_ = chosen;
  tools_->button(static_cast<int>(painting_.tool))->setChecked(true);
  modes_->button(painting_.label == patch::kNone ? kErase
                 : painting_.replaces            ? kReplace
                                                 : kAdd)
      ->setChecked(true);
  radius_->setValue(painting_.radiusMm);
  snap_->setCurrentIndex(static_cast<int>(painting_.snap));
  const bool line = painting_.tool == PaintTool::Line;
  auto* form = qobject_cast<QFormLayout*>(layout());
  for (QWidget* only : {static_cast<QWidget*>(snap_), form->labelForField(snap_)}) only->setVisible(line);
  radius_->setEnabled(painting_.tool == PaintTool::Brush || line);
  hint_->setText(hintOf(painting_.tool));
}

}  // namespace falciform
