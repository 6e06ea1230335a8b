#include "Modules/SegmentationImport/QualityTable.h"

#include <QHeaderView>
#include <cmath>

#include "Widgets/Forms/TableHeight.h"

namespace falciform {
namespace {

QString number(double value, int digits) { return QString::number(value, 'f', digits); }

}  // namespace

QualityTable::QualityTable(QWidget* parent) : QTableWidget(0, 2, parent) {
  setObjectName("qualityTable");
  setToolTip(tr(
      "The surface beside the voxels it was made of. Distances in mm, both ways between the surface and the "
      "voxels' faces; a good smooth surface has a mean of 0.1 to 0.25 voxels"));
  setHorizontalHeaderLabels({tr("Quality"), tr("Value")});
  horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(22);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionMode(QAbstractItemView::NoSelection);
  hide();
}

void QualityTable::addRow(const QString& what, const QString& value, bool good) {
  const int row = rowCount();
  insertRow(row);
  setItem(row, 0, new QTableWidgetItem(what));
  auto* item = new QTableWidgetItem(good ? value : QString::fromUtf8("⚠ ") + value);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setItem(row, 1, item);
}

void QualityTable::setResult(const SurfaceImportResult& result) {
  setRowCount(0);
  const TopologyReport& shape = result.topology;
  const SurfaceQuality& quality = result.quality;
  const bool closed = shape.closedManifold();
  addRow(tr("Closed manifold"), closed ? tr("yes") : tr("no"), closed);
  addRow(tr("Pieces"), QString::number(shape.components), shape.components == 1);
  const auto genus = shape.components - shape.eulerCharacteristic / 2;
  addRow(tr("Genus (tunnels)"), closed ? QString::number(genus) : QString::fromUtf8("–"), genus == 0);
  addRow(tr("Self-crossings, pairs"), QString::number(quality.crossings), quality.crossings == 0);
  const double off = 100 * (result.surfaceVolumeMm3 / result.voxelVolumeMm3 - 1);
  addRow(tr("Volume, ml"), number(result.surfaceVolumeMm3 / 1000, 1));
  addRow(tr("Volume of the mask, ml"),
         tr("%1 (%2 %)").arg(number(result.voxelVolumeMm3 / 1000, 1), QString::asprintf("%+.2f", off)),
         std::abs(off) <= 1);
  addRow(tr("Triangles"), QString("%L1").arg(static_cast<qlonglong>(result.surface.triangles.rows())));
  addRow(tr("Mean edge, mm"), number(quality.meanEdgeMm, 2));
  addRow(tr("To the mask: mean, mm"), number(quality.meanMm, 2));
  addRow(tr("To the mask: 95 %, mm"), number(quality.p95Mm, 2));
  addRow(tr("To the mask: at most, mm"), number(quality.maxMm, 2));
  showAllRows(this);
  show();
}

void QualityTable::clearResult() {
  setRowCount(0);
  hide();
}

}  // namespace falciform
