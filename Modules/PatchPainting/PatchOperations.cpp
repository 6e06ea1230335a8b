#include "Modules/PatchPainting/PatchOperations.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "Widgets/Forms/NumberBox.h"

namespace falciform {

PatchOperations::PatchOperations(Workbench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  auto* mm = new NumberBox(this);
  mm->setObjectName("patchStep");
  mm->setRange(0.5, 20);
  mm->setSuffix(" mm");
  mm->setValue(mm_);
  mm->setToolTip(
      tr("How far the border moves, and over what length it is smoothed, along the surface.\nUnit: mm\n"
         "Range: 0.5 to 20\nDefault: 2"));
  connect(mm, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) { mm_ = value; });
  add("growPatch", tr("Grow"), tr("Moves the patch's border outwards"),
      [this](const auto& surface, const auto& labels) { return grownPatch(surface, labels, chosen_, mm_); });
  add("shrinkPatch", tr("Shrink"), tr("Moves the patch's border inwards"),
      [this](const auto& surface, const auto& labels) { return shrunkPatch(surface, labels, chosen_, mm_); });
  add("smoothPatch", tr("Smooth border"), tr("Rounds a ragged border off; the area stays"),
      [this](const auto& surface, const auto& labels) {
        return smoothedPatch(surface, labels, chosen_, mm_);
      });
  add("fillHoles", tr("Fill holes"), tr("Paints holes of up to a quarter of the patch"),
      [this](const auto& surface, const auto& labels) { return filledHoles(surface, labels, chosen_); });
  add("largestPiece", tr("Largest piece"), tr("Keeps the patch's largest connected piece alone"),
      [this](const auto& surface, const auto& labels) {
        return largestPieceOfPatch(surface, labels, chosen_);
      });
  auto* by = new QLabel(tr("By"), this);
  by->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  grid->addWidget(buttons_[0], 0, 0);
  grid->addWidget(buttons_[1], 0, 1);
  auto* distance = new QHBoxLayout;
  distance->addWidget(by);
  distance->addWidget(mm, 1);
  grid->addLayout(distance, 0, 2);
  for (int k = 2; k < 5; ++k) grid->addWidget(buttons_[static_cast<std::size_t>(k)], 1, k - 2);
  for (int column = 0; column < 3; ++column) grid->setColumnStretch(column, 1);
  for (QPushButton* button : buttons_) setTabOrder(button, mm);
}

void PatchOperations::add(
    const char* name, const QString& text, const QString& tip,
    std::function<PatchChange(const BrushSurface&, const std::vector<int>&)> operation) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(name);
  button->setToolTip(tip + tr("; of the marked patch on the chosen surface; can be undone"));
  button->setMinimumWidth(0);
  buttons_.push_back(button);
  connect(button, &QPushButton::clicked, this, [this, text, operation = std::move(operation)] {
    const BrushSurface* surface = bench_.painting.surface();
    if (surface == nullptr) return;
    const PatchEdit edit = bench_.painting.apply(operation(*surface, bench_.painting.labels()), chosen_);
    if (edit.empty()) bench_.log.info(tr("%1: nothing to change.").arg(text));
    Q_EMIT changed();
  });
}

void PatchOperations::refresh(int chosen) {
  chosen_ = chosen;
  const std::vector<int>& labels = bench_.painting.labels();
  const bool painted = std::find(labels.begin(), labels.end(), chosen) != labels.end();
  const bool locked = bench_.painting.locked().count(chosen) > 0;
  for (QPushButton* button : buttons_) button->setEnabled(painted && !locked);
}

}  // namespace falciform
