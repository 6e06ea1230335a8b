#include "Modules/PatchPainting/BrushControls.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <set>

#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Rendering/PatchColours.h"

namespace falciform {
namespace {

QIcon swatch(int label) {
  const Vector3d colour = patchColour(label);
  QPixmap picture(14, 14);
  picture.fill(QColor::fromRgbF(colour.x(), colour.y(), colour.z()));
  return picture;
}

}  // namespace

BrushControls::BrushControls(PatchPaintingLogic& painting, Case& document, QWidget* parent)
    : QWidget(parent),
      painting_(painting),
      case_(document),
      patch_(new QComboBox(this)),
      newPatch_(new QPushButton(tr("New…"), this)),
      add_(new QToolButton(this)),
      erase_(new QToolButton(this)),
      radius_(new NumberBox(this)) {
  patch_->setObjectName("brushPatch");
  patch_->setToolTip(
      tr("The patch that the brush paints. Keys 1 to 9. Range: labels 1 to %1").arg(patch::kMax));
  newPatch_->setObjectName("newPatch");
  newPatch_->setToolTip(tr("Name another patch, for example the gallbladder fossa"));
  add_->setObjectName("brushAdd");
  add_->setText(tr("Add"));
  add_->setToolTip(tr("The brush adds to the chosen patch"));
  erase_->setObjectName("brushErase");
  erase_->setText(tr("Erase"));
  erase_->setToolTip(tr("The brush removes any patch under it"));
  auto* modes = new QButtonGroup(this);
  for (QToolButton* button : {add_, erase_}) {
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    modes->addButton(button);
  }
  radius_->setObjectName("brushRadius");
  radius_->setRange(0.5, 60);
  radius_->setSuffix(" mm");
  radius_->setToolTip(
      tr("Brush radius along the surface. Shift+wheel or + and - over the view change it too.\n"
         "Unit: mm\nRange: 0.5 to 60\nDefault: 6"));

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  auto* patchRow = new QHBoxLayout;
  patchRow->addWidget(patch_, 1);
  patchRow->addWidget(newPatch_);
  form->addRow(tr("Patch"), patchRow);
  auto* modeRow = new QHBoxLayout;
  modeRow->addWidget(add_);
  modeRow->addWidget(erase_);
  form->addRow(tr("Brush"), modeRow);
  form->addRow(tr("Radius"), radius_);

  connect(patch_, qOverload<int>(&QComboBox::activated), this, [this] {
    add_->setChecked(true);  // choosing a patch means to paint it
    apply();
  });
  connect(modes, qOverload<QAbstractButton*>(&QButtonGroup::buttonClicked), this, &BrushControls::apply);
  connect(radius_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &BrushControls::apply);
  connect(newPatch_, &QPushButton::clicked, this, [this] {
    bool accepted = false;
    const QString name = QInputDialog::getText(this, tr("New patch"), tr("Name of the patch:"),
                                               QLineEdit::Normal, {}, &accepted);
    if (accepted && !name.trimmed().isEmpty()) addNamedPatch(name.trimmed());
  });
  refresh();
}

int BrushControls::chosenPatch() const { return patch_->currentData().toInt(); }

void BrushControls::apply() {
  painting_.label = erase_->isChecked() ? patch::kNone : chosenPatch();
  painting_.radiusMm = radius_->value();
  Q_EMIT changed();
}

void BrushControls::refresh() {
  const QSignalBlocker quietPatch(patch_), quietRadius(radius_);
  const int chosen = painting_.label > 0   ? painting_.label
                     : patch_->count() > 0 ? chosenPatch()
                                           : patch::kFalciform;
  std::set<int> labels{patch::kFalciform, patch::kInferiorRidge, chosen};
  std::map<int, std::string> names;
  for (const auto& surface : {case_.preop(), case_.scan()}) {
    if (!surface) continue;
    for (const int label : patchLabels(*surface)) labels.insert(label);
    for (const auto& [label, name] : surface->patchNames) labels.insert(label);
    for (const int label : labels)
      if (!names.count(label) || surface->patchNames.count(label)) names[label] = patchName(*surface, label);
  }
  patch_->clear();
  for (const int label : labels)
    patch_->addItem(swatch(label),
                    QString::fromStdString(names.count(label) ? names[label] : patchName({}, label)), label);
  patch_->setCurrentIndex(patch_->findData(chosen));
  (painting_.label > 0 ? add_ : erase_)->setChecked(true);
  radius_->setValue(painting_.radiusMm);
  newPatch_->setEnabled(case_.preop() || case_.scan());
}

void BrushControls::addNamedPatch(const QString& name) {
  int next = patch::kFirstNamed;
  while (next <= patch::kMax && patch_->findData(next) >= 0) ++next;
  if (next > patch::kMax) return;
  painting_.label = next;
  // The name goes with both sides, since a patch serves registration only if both have it.
  const auto named = [&](const std::shared_ptr<const Surface>& surface) {
    auto copy = std::make_shared<Surface>(*surface);
    copy->patchNames[next] = name.toStdString();
    return copy;
  };
  if (case_.preop()) case_.setPreop(named(case_.preop()));
  if (case_.scan()) case_.setScan(named(case_.scan()));
  refresh();
  Q_EMIT changed();
}

}  // namespace falciform
