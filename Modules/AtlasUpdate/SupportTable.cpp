#include "Modules/AtlasUpdate/SupportTable.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSignalBlocker>

#include "Logic/Core/Settings.h"
#include "Widgets/Forms/TableHeight.h"
#include "Widgets/Rendering/PatchColours.h"

namespace falciform {
namespace {

enum Column { kName, kKind, kPush };
constexpr int kLabel = Qt::UserRole;

QIcon swatch(const SupportRegion& region, int label) {
  const Vector3d rgb = supportColour(region.kind, label);
  QPixmap picture(12, 12);
  picture.fill(QColor::fromRgbF(rgb.x(), rgb.y(), rgb.z()));
  QIcon icon(picture);
  icon.addPixmap(picture, QIcon::Selected);  // else Qt tints it where the row is chosen
  return icon;
}

std::map<int, SupportRegion> withoutDistances(std::map<int, SupportRegion> regions) {
  for (auto& [label, region] : regions) region.pushMm = 0;
  return regions;
}

}  // namespace

SupportTable::SupportTable(QWidget* parent) : QTableWidget(0, 3, parent) {
  setObjectName("supportTable");
  setHorizontalHeaderLabels({tr("Support"), tr("Kind"), tr("Push")});
  horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(kKind, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kPush, QHeaderView::ResizeToContents);
  verticalHeader()->hide();
  setSelectionMode(QAbstractItemView::SingleSelection);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setWordWrap(true);
  setToolTip(
      tr("What holds and pushes the liver. The chosen row is what the brush paints.\n"
         "Fixed: does not move. Sliding: stays on its surface. Pushed: moved inwards by a distance in mm."));
  showAllRows(this);
  connect(this, &QTableWidget::itemSelectionChanged, this, [this] {
    if (chosen() > 0) Q_EMIT choiceMade(chosen());
  });
}

void SupportTable::show(const std::shared_ptr<const SupportPainting>& painting) {
  painting_ = painting;
  const std::map<int, SupportRegion> rows =
      painting ? withoutDistances(painting->regions) : std::map<int, SupportRegion>{};
  if (rows != rows_) {
    const QSignalBlocker quiet(this);
    const int before = chosen();
    rows_ = rows;
    // Qt deletes them later; until then nobody shall find two of one name.
    for (QComboBox* old : findChildren<QComboBox*>()) old->setObjectName({});
    setRowCount(0);
    for (const auto& [label, region] : rows_) addRow(label, region);
    choose(before);
    showAllRows(this);
  }
  for (int row = 0; row < rowCount(); ++row) {
    const SupportRegion& region = painting_->regions.at(item(row, kName)->data(kLabel).toInt());
    item(row, kPush)
        ->setText(region.kind == SupportRegionKind::Pushed ? tr("%1 mm").arg(region.pushMm, 0, 'g', 3)
                                                           : QString::fromUtf8("–"));
  }
}

void SupportTable::addRow(int label, const SupportRegion& region) {
  const int row = rowCount();
  insertRow(row);
  auto* name = new QTableWidgetItem(swatch(region, label), QString::fromStdString(region.name));
  name->setData(kLabel, label);
  name->setToolTip(name->text());
  setItem(row, kName, name);
  auto* push = new QTableWidgetItem;
  push->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setItem(row, kPush, push);
  auto* kind = new QComboBox(this);
  kind->setObjectName(QString("kind_%1").arg(label));
  for (const std::string_view word : enumNames(SupportRegionKind{}))
    kind->addItem(QString::fromUtf8(word.data(), static_cast<int>(word.size())));
  kind->setCurrentIndex(static_cast<int>(region.kind));
  kind->setToolTip(tr("How this part of the surface is held. Choose from: fixed, sliding, pushed"));
  connect(kind, qOverload<int>(&QComboBox::activated), this,
          [this, label](int index) { Q_EMIT kindChosen(label, static_cast<SupportRegionKind>(index)); });
  setCellWidget(row, kKind, kind);
}

void SupportTable::choose(int label) {
  for (int row = 0; row < rowCount(); ++row)
    if (item(row, kName)->data(kLabel).toInt() == label) setCurrentCell(row, kName);
}

int SupportTable::chosen() const {
  const QTableWidgetItem* current = item(currentRow(), kName);
  return current ? current->data(kLabel).toInt() : 0;
}

}  // namespace falciform
