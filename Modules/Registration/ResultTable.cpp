#include "Modules/Registration/ResultTable.h"

#include <QHeaderView>
#include <QResizeEvent>
#include <cmath>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

QString figure(double value, int decimals, const char* unit) {
  return std::isfinite(value) ? QString::number(value, 'f', decimals) + QString::fromUtf8(unit)
                              : QString::fromUtf8("–");
}

QString mm(double value) { return figure(value, 2, " mm"); }

}  // namespace

ResultTable::ResultTable(QWidget* parent) : QTableWidget(0, 2, parent) {
  setObjectName("registrationResult");
  setHorizontalHeaderLabels({tr("Fit, not target error"), tr("Value")});
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  verticalHeader()->hide();
  verticalHeader()->setMinimumSectionSize(fontMetrics().height() + 6);
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

void ResultTable::addHeading(const QString& text, const QString& meaning) {
  const int row = rowCount();
  insertRow(row);
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(meaning);
  item->setTextAlignment(Qt::AlignCenter);
  item->setBackground(palette().button());
  setItem(row, 0, item);
  setSpan(row, 0, 1, 2);
}

void ResultTable::addTargetErrors(const RegistrationResult& result, const Case& document) {
  const QString meaning =
      tr("Estimated from how far the liver bent and how well the scan holds it, if this is the right pose: a "
         "wrong pose is not seen in it. A residual is fit, not target error: the one may be small where the "
         "other is not.");
  addHeading(tr("Target error, as expected"), meaning);
  if (!(result.expectedErrorMeanMm > 0) && !result.expectedTargetErrorMm) {
    addFigure(
        tr("Expected target error"), tr("not known"),
        meaning +
            tr(" This pose has none: it was not found by the elastic finish, or was read from a file."));
    return;
  }
  addFigure(tr("Expected target error"), mm(result.expectedErrorMeanMm),
            meaning + tr(" Root mean square over the whole liver."));
  if (!result.expectedTargetErrorMm) return;
  for (const auto& [name, surface] : document.structures()) {
    if (surface->size() == 0) continue;
    const Vector3d middle = surface->points.colwise().mean();
    addFigure(QString::fromUtf8("… at %1").arg(QString::fromStdString(name)),
              mm(result.expectedTargetErrorMm(middle)), meaning + tr(" At the middle of this structure."));
  }
}

void ResultTable::show(const Case& document) {
  const RegistrationResult* result = document.registration().get();
  const Surface* preop = document.preop().get();
  clearSpans();
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
  addFigure(
      tr("Basins"),
      result->basins.empty() ? QString::fromUtf8("–")
      : result->basins.size() == 1
          ? tr("1 (unique)")
          : tr("%1, next score %2").arg(result->basins.size()).arg(result->basins[1].score, 0, 'f', 3),
      tr("Distinct poses that starts led to. Score: robust residual, 0 to 1, lower is better; this pose "
         "has %1. Close scores mean that the pose is not certain")
          .arg(result->basins.empty() ? QString::fromUtf8("–")
                                      : QString::number(result->basins[0].score, 'f', 3)));
  addFigure(tr("Time"), figure(result->seconds, 2, " s"), tr("Computing time"));
  addTargetErrors(*result, document);
  resizeRowsToContents();
  showAllRows(this);
}

// Long words, such as why it stopped, take as many lines as the panel's width asks for.
void ResultTable::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  if (event->oldSize().width() == event->size().width()) return;
  resizeRowsToContents();
  showAllRows(this);
}

QString ResultTable::value(const QString& name) const {
  for (int row = 0; row < rowCount(); ++row)
    if (item(row, 0)->text() == name) return item(row, 1)->text();
  return {};
}

}  // namespace falciform
