#include "Modules/Registration/LandmarkStart.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {

LandmarkStart::LandmarkStart(QWidget* parent)
    : QWidget(parent),
      wanted_(new QCheckBox(tr("Start from landmarks"), this)),
      words_(new QLabel(this)),
      table_(new QTableWidget(0, 2, this)) {
  wanted_->setObjectName("startFromLandmarks");
  wanted_->setToolTip(
      tr("Fit the landmarks of both sides first and begin there; needs 3 or more on each side"));
  words_->setObjectName("landmarkFit");
  words_->setWordWrap(true);
  table_->setObjectName("landmarkErrors");
  table_->setToolTip(tr(
      "Fiducial registration error (FRE) of each landmark in mm, worst first: how far the pair stays apart "
      "after the best rigid fit.\nA point far above the rest was placed wrongly. FRE is fit, not target "
      "error"));
  table_->setHorizontalHeaderLabels({tr("Landmark"), tr("FRE, mm")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(wanted_);
  column->addWidget(words_);
  column->addWidget(table_);
  connect(wanted_, &QCheckBox::toggled, this, &LandmarkStart::toggled);
}

void LandmarkStart::show(const Landmarks& preop, const std::optional<PointRegistrationResult>& fit,
                         const std::string& missing) {
  table_->setRowCount(0);
  table_->setVisible(fit.has_value() && wanted_->isChecked());
  words_->setText(QString::fromStdString(missing));
  // Who has placed no landmark and wants none need not hear that there is none.
  words_->setVisible(fit.has_value() || wanted_->isChecked() || !preop.points.empty());
  if (!fit) return;
  std::vector<Index> order(preop.points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return fit->freByPointMm[a] > fit->freByPointMm[b]; });
  const auto nameOf = [&](Index point) {
    const std::string& name = preop.points[static_cast<std::size_t>(point)].name;
    return name.empty() ? tr("point %1").arg(point + 1) : QString::fromStdString(name);
  };
  QString words = tr("Landmarks fit with an FRE of %1 mm; worst is %2 with %3 mm.")
                      .arg(fit->freMm, 0, 'f', 2)
                      .arg(nameOf(order.front()))
                      .arg(fit->freByPointMm[order.front()], 0, 'f', 2);
  for (const std::string& warning : fit->warnings)
    words += QString::fromUtf8("\n⚠ ") + QString::fromStdString(warning);
  words_->setText(words);
  for (const Index point : order) {
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* left = new QTableWidgetItem(nameOf(point));
    auto* right = new QTableWidgetItem(QString::number(fit->freByPointMm[point], 'f', 2));
    right->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QTableWidgetItem* item : {left, right}) {
      QFont font = item->font();
      font.setBold(row == 0);
      item->setFont(font);
    }
    table_->setItem(row, 0, left);
    table_->setItem(row, 1, right);
  }
  showAllRows(table_);
}

}  // namespace falciform
