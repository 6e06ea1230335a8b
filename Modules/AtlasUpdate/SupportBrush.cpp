#include "Modules/AtlasUpdate/SupportBrush.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "Widgets/Forms/NumberBox.h"

namespace falciform {

SupportBrush::SupportBrush(Workbench& workbench, QWidget* parent)
    : QWidget(parent), bench_(workbench), erase_(new QToolButton(this)), radius_(new NumberBox(this)) {
  const auto button = [this](const char* name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(name);
    made->setToolTip(tip);
    return made;
  };
  paint_ =
      button("paintSupport", tr("Paint"),
             tr("While on, dragging with the left button paints the chosen support; the liver is shown at "
                "rest.\nCtrl, Shift or Alt with the mouse turns the view; Esc ends painting"));
  paint_->setCheckable(true);
  erase_->setObjectName("eraseSupport");
  erase_->setText(tr("Erase"));
  erase_->setCheckable(true);
  erase_->setToolTip(tr("The brush sets the surface free"));
  radius_->setObjectName("supportRadius");
  radius_->setRange(0.5, 60);
  radius_->setSuffix(" mm");
  radius_->setToolTip(
      tr("Brush radius along the surface. Shift+wheel or + and - over the view change it too.\n"
         "Unit: mm\nRange: 0.5 to 60\nDefault: 6"));
  undo_ = button("undoSupport", tr("Undo"), tr("Take the last stroke or template back (Z); up to 200"));
  redo_ = button("redoSupport", tr("Redo"), tr("Bring it back (Y)"));
  clear_ = button("clearSupport", tr("Clear"), tr("Remove the chosen support's paint; can be undone"));
  add_ = button("newSupport", tr("New…"), tr("Name another support, for example the right kidney"));
  auto* modes = new QHBoxLayout;
  modes->addWidget(paint_, 1);
  modes->addWidget(erase_);
  modes->addWidget(radius_);
  auto* steps = new QGridLayout;
  steps->addWidget(undo_, 0, 0);
  steps->addWidget(redo_, 0, 1);
  steps->addWidget(clear_, 1, 0);
  steps->addWidget(add_, 1, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(modes);
  column->addLayout(steps);

  connect(paint_, &QPushButton::toggled, this,
          [this](bool on) { bench_.view.edit([&](ViewOptions& options) { options.painting = on; }); });
  connect(erase_, &QToolButton::toggled, this, [this](bool on) {
    bench_.painting.label = on ? support_label::kFree : label_;
    Q_EMIT changed();
  });
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this](double mm) { bench_.painting.radiusMm = mm; });
  connect(undo_, &QPushButton::clicked, this, [this] { (void)bench_.painting.undo(), Q_EMIT changed(); });
  connect(redo_, &QPushButton::clicked, this, [this] { (void)bench_.painting.redo(), Q_EMIT changed(); });
  connect(clear_, &QPushButton::clicked, this,
          [this] { (void)bench_.painting.clearPatch(label_), Q_EMIT changed(); });
  connect(add_, &QPushButton::clicked, this, &SupportBrush::newRegionWanted);
}

void SupportBrush::refresh(int label) {
  label_ = label;
  const bool canPaint = bench_.painting.missingInput().empty(), on = bench_.view.options().painting;
  const QSignalBlocker quietPaint(paint_), quietErase(erase_), quietRadius(radius_);
  paint_->setEnabled(canPaint && label > 0);
  paint_->setChecked(on);
  paint_->setText(on ? tr("Stop painting (Esc)") : tr("Paint"));
  erase_->setEnabled(canPaint);
  erase_->setChecked(bench_.painting.label == support_label::kFree);
  radius_->setEnabled(canPaint);
  radius_->setValue(bench_.painting.radiusMm);
  undo_->setEnabled(bench_.painting.canUndo());
  redo_->setEnabled(bench_.painting.canRedo());
  clear_->setEnabled(canPaint && label > 0);
  add_->setEnabled(canPaint);
}

}  // namespace falciform
