#include "Modules/Registration/ResultTable.h"

#include <QHeaderView>
#include <cmath>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

QString figure(double value, int decimals, const char* unit) {
  return std::isfinite(value) ? QString::number(value, 'f', decimals) + QString::fromUtf8(unit)
                              : QString::fromUtf8("–");
}

QString mm(double value) { return figure(value, 2, " mm"); }

QString basinText(const std::vector<RegistrationBasin>& basins) {
  if (basins.empty()) return QString::fromUtf8("–");
  if (basins.size() == 1) return QObject::tr("1 (unique)");
  return QObject::tr("%1 (score %2, next %3)")
      .arg(basins.size())
      .arg(basins[0].score, 0, 'f', 3)
      .arg(basins[1].score, 0, 'f', 3);
}

}  // namespace

ResultTable::ResultTable(QWidget* parent) : QTableWidget(0, 2, parent) {
  setObjectName("registrationResult");
  setHorizontalHeaderLabels({tr("Fit, not target error"), tr("Value")});
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setToolTip(tr(
      "How well the scan fits the surface. A small residual does not prove that targets inside are right."));
}

void ResultTable::addFigure(const QString& name, const QString& value, const QString& meaning) {
  const int row = rowCount();
  insertRow(row);
  auto* left = new QTableWidgetItem(name);
  auto* right = new QTableWidgetItem(value);
  left->setToolTip(meaning);
  right->setToolTip(meaning);
  setItem(row, 0, left);
  setItem(row, 1, right);
}

void ResultTable::show(const RegistrationResult* result, const Surface* preop) {
  setRowCount(0);
  setVisible(result != nullptr);
  if (!result) return;
  addFigure(tr("RMS residual"), mm(result->rmsMm),
            tr("Root mean square distance of all scan points to the surface, unweighted"));
  addFigure(tr("RMS residual, weighted"), mm(result->weightedRmsMm),
            tr("The same with the patch weights of the last iteration"));
  addFigure(tr("Mean residual"), mm(result->meanMm), tr("Mean distance of the scan points to the surface"));
  addFigure(tr("95th percentile"), mm(result->p95Mm), tr("95 % of the scan points lie nearer than this"));
  for (const auto& [label, rms] : result->patchRmsMm)
    addFigure(
        tr("RMS of %1")
            .arg(QString::fromStdString(preop ? patchName(*preop, label) : "patch " + std::to_string(label))),
        mm(rms), tr("Scan points of this patch to the same patch of the surface"));
  addFigure(tr("Coverage"), figure(100 * result->coverage, 1, " %"),
            tr("Share of the surface's area within reach of the scan"));
  addFigure(tr("Rotation from the start"), figure(result->rotationDeg, 1, "°"),
            tr("Turn of the pose against the start"));
  addFigure(tr("Translation from the start"), figure(result->translationMm, 1, " mm"),
            tr("Motion of the scan's centroid against the start"));
  addFigure(tr("Scan points"), QString("%L1").arg(result->scanPoints), tr("Points that were registered"));
  addFigure(tr("Surface points"), QString("%L1").arg(result->preopPoints),
            tr("Points of the pre-operative surface"));
  addFigure(tr("Iterations"), QString::number(result->iterations), tr("Of the start that won"));
  addFigure(tr("Stopped because"), QString::fromStdString(result->stopReason),
            QString::fromStdString(result->stopReason));
  addFigure(tr("Converged"), result->converged ? tr("yes") : tr("no"), tr("Whether the stop rule was met"));
  addFigure(tr("Basins"), basinText(result->basins),
            tr("Distinct poses that starts led to, with the robust residual (0 to 1, lower is better) of the "
               "best two; "
               "close scores mean that the pose is not certain"));
  addFigure(tr("Time"), figure(result->seconds, 1, " s"), tr("Computing time"));
  showAllRows(this);
}

QString ResultTable::value(const QString& name) const {
  for (int row = 0; row < rowCount(); ++row)
    if (item(row, 0)->text() == name) return item(row, 1)->text();
  return {};
}

}  // namespace falciform
