#include "Modules/SegmentationImport/LabelTable.h"

#include <QComboBox>
#include <QHeaderView>
#include <QPainter>
#include <QPixmap>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "Widgets/Views/SliceOptions.h"

namespace falciform {
namespace {

enum Column { kLabel, kName, kVolume, kRole, kColumns };
constexpr int kMostRows = 8;

QTableWidgetItem* fixedItem(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
  return item;
}

bool has(const QString& name, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return name.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

LabelTable::LabelTable(QWidget* parent) : QWidget(parent), table_(new QTableWidget(0, kColumns, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(table_);
  table_->setObjectName("labelTable");
  table_->setHorizontalHeaderLabels({tr("Liver"), tr("Name"), tr("ml"), tr("Also as")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  table_->setToolTip(tr(
      "Values found in the label map, with their volume in ml. Tick those that are liver, and what lies in "
      "it; none ticked means all. Range: 1 to 65535\n"
      "Also as: comes into the case as a vessel or tumour of its own, under its name\n"
      "The chosen row is what the brush paints; a double click on the colour changes it"));
  connect(table_, &QTableWidget::itemChanged, this, &LabelTable::read);
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { Q_EMIT paintLabelChanged(paintLabel()); });
  connect(table_, &QTableWidget::cellDoubleClicked, this, [this](int row, int of) {
    if (of == kLabel) Q_EMIT colourWanted(table_->item(row, kLabel)->data(Qt::UserRole).toInt());
  });
  setCounts({}, 0, {});
}

void LabelTable::setCounts(const Counts& counts, double voxelMl, const std::map<int, std::string>& names) {
  const QSignalBlocker quiet(table_);
  const int chosen = paintLabel();
  table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(counts.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& [label, voxels] = counts[static_cast<std::size_t>(row)];
    if (!known_.contains(label)) {
      Known fresh;
      if (const auto name = names.find(label); name != names.end())
        fresh.name = QString::fromStdString(name->second);
      if (has(fresh.name, {"tumour", "tumor", "cyst", "lesion", "metast"}))
        fresh.role = Role::Tumour;
      else if (has(fresh.name, {"vein", "vena", "venous", "portal", "arter", "vessel"}))
        fresh.role = Role::Vessel;
      known_[label] = fresh;
    }
    addRow(row, label, voxels, static_cast<double>(voxels) * voxelMl);
    if (label == chosen) table_->selectRow(row);
  }
  paintSwatches();
  const int rows = std::clamp(table_->rowCount(), 1, kMostRows);
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth() +
                         rows * table_->verticalHeader()->defaultSectionSize());
}

void LabelTable::addRow(int row, int label, std::size_t voxels, double ml) {
  const Known& known = known_[label];
  auto* tick = new QTableWidgetItem(QString::number(label));
  tick->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
  tick->setCheckState(known.liver ? Qt::Checked : Qt::Unchecked);
  tick->setData(Qt::UserRole, label);
  table_->setItem(row, kLabel, tick);
  table_->setItem(row, kName, new QTableWidgetItem(known.name));
  auto* volume = fixedItem(QString::number(ml, 'f', 1));
  volume->setToolTip(tr("%L1 voxels").arg(voxels));
  table_->setItem(row, kVolume, volume);
  auto* role = new QComboBox(table_);
  role->setObjectName(QString("labelRole%1").arg(label));
  role->setToolTip(tr("Comes into the case as a surface of its own as well: a vessel or a tumour"));
  role->addItems({QString::fromUtf8("–"), tr("vessel"), tr("tumour")});
  role->setCurrentIndex(static_cast<int>(known.role));
  table_->setCellWidget(row, kRole, role);
  connect(role, qOverload<int>(&QComboBox::currentIndexChanged), this, &LabelTable::read);
}

void LabelTable::forget() { known_.clear(); }

void LabelTable::read() {
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto* role = static_cast<QComboBox*>(table_->cellWidget(row, kRole));
    if (!role) return;  // being filled
    known_[table_->item(row, kLabel)->data(Qt::UserRole).toInt()] = {
        table_->item(row, kLabel)->checkState() == Qt::Checked, static_cast<Role>(role->currentIndex()),
        table_->item(row, kName)->text().trimmed()};
  }
  Q_EMIT edited();
}

void LabelTable::setColours(const std::map<int, std::array<double, 3>>& colours) {
  if (colours == colours_) return;
  colours_ = colours;
  paintSwatches();
}

void LabelTable::paintSwatches() {
  const QSignalBlocker quiet(table_);
  for (int row = 0; row < table_->rowCount(); ++row) {
    QTableWidgetItem* item = table_->item(row, kLabel);
    const int label = item->data(Qt::UserRole).toInt();
    const auto own = colours_.find(label);
    const auto rgb = own == colours_.end() ? labelColour(label) : own->second;
    QPixmap swatch(12, 12);
    swatch.fill(QColor::fromRgbF(rgb[0], rgb[1], rgb[2]));
    item->setIcon(QIcon(swatch));
  }
}

std::vector<int> LabelTable::liverLabels() const {
  std::vector<int> ticked;
  for (int row = 0; row < table_->rowCount(); ++row)
    if (table_->item(row, kLabel)->checkState() == Qt::Checked)
      ticked.push_back(table_->item(row, kLabel)->data(Qt::UserRole).toInt());
  // All is said by an empty list, which also holds for the next label map.
  return static_cast<int>(ticked.size()) == table_->rowCount() ? std::vector<int>{} : ticked;
}

std::map<int, std::string> LabelTable::structures() const {
  std::map<int, std::string> named;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const int label = table_->item(row, kLabel)->data(Qt::UserRole).toInt();
    const auto known = known_.find(label);
    if (known == known_.end() || known->second.role == Role::None) continue;
    QString name = known->second.name;
    if (name.isEmpty())
      name = QString(known->second.role == Role::Vessel ? "vessel %1" : "tumour %1").arg(label);
    named[label] = name.toStdString();
  }
  return named;
}

int LabelTable::paintLabel() const {
  const auto chosen = table_->selectionModel()->selectedRows();
  return chosen.isEmpty() ? 1 : table_->item(chosen.front().row(), kLabel)->data(Qt::UserRole).toInt();
}

}  // namespace falciform
