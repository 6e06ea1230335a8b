#include "Modules/SegmentationImport/SegmentationImportPanel.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "Modules/SegmentationImport/SeriesChooser.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {
namespace {

enum Column { kLabel, kVoxels, kVolume };

QTableWidgetItem* numberItem(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  item->setFlags(Qt::ItemIsEnabled);
  return item;
}

}  // namespace

SegmentationImportPanel::SegmentationImportPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(
          workbench,
          tr("Turns the liver of a label map into a closed surface, or takes a surface that exists already."),
          parent),
      logic_(document()),
      table_(new QTableWidget(0, 3, this)),
      import_(new QPushButton(tr("Import"), this)) {
  addOpenButtons();

  auto* labels = addGroup(tr("Labels that are liver"));
  mapFacts_ = wrappedLabel("mapFacts", this);
  labels->addWidget(mapFacts_);
  table_->setObjectName("labelTable");
  table_->setHorizontalHeaderLabels({tr("Label"), tr("Voxels"), tr("Volume, ml")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setMinimumHeight(150);
  table_->setToolTip(
      tr("Values found in the label map with their number of voxels; tick those that are liver.\n"
         "None ticked means all. Range: 1 to 65535"));
  labels->addWidget(table_);

  auto* settings = addGroup(tr("Surface"));
  form_ = new SettingsForm(logic_.settings, {"edgeLengthMm"}, {"labels"}, this);
  form_->setObjectName("importSettings");
  settings->addWidget(form_);

  import_->setObjectName("import");
  import_->setToolTip(
      tr("Make the surface from the ticked labels; replaces the case's pre-operative surface"));
  column()->addWidget(import_);
  missing_ = wrappedLabel("missing", this);
  column()->addWidget(missing_);
  result_ = wrappedLabel("importResult", this);
  column()->addWidget(result_);
  warnings_ = wrappedLabel("warnings", this);
  column()->addWidget(warnings_);
  showWarnings(warnings_, {});

  connect(table_, &QTableWidget::itemChanged, this, &SegmentationImportPanel::readTicks);
  connect(import_, &QPushButton::clicked, this, &SegmentationImportPanel::import);
  countWanted_ = document().labels() != nullptr;
  start();
}

void SegmentationImportPanel::addOpenButtons() {
  auto* row = new QHBoxLayout;
  auto* openMap = new QPushButton(tr("Open label map…"), this);
  openMap->setObjectName("openLabelMap");
  openMap->setToolTip(tr("NIfTI, NRRD or MetaImage with whole-number labels, 0 is background"));
  auto* openSurface = new QPushButton(tr("Open surface…"), this);
  openSurface->setObjectName("openSurface");
  openSurface->setToolTip(tr("A liver surface in mm: VTP, VTK, STL, PLY or OBJ; no import is needed then"));
  auto* openFolder = new QPushButton(tr("Open DICOM…"), this);
  openFolder->setObjectName("openDicom");
  openFolder->setToolTip(tr(
      "A folder as the scanner's archive exports it: CT, masks or DICOM SEG; of several series you choose"));
  row->addWidget(openFolder);
  row->addWidget(openMap);
  row->addWidget(openSurface);
  column()->addLayout(row);
  connect(openFolder, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open DICOM folder"));
    if (!folder.isEmpty()) openDicom(bench(), folder.toStdString(), this);
  });
  connect(openMap, &QPushButton::clicked, this, [this] {
    const QString file =
        askForFile(tr("Open label map"), tr("Label maps (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd)"));
    if (!file.isEmpty()) bench().files.open(file.toStdString(), FileRole::Labels);
  });
  connect(openSurface, &QPushButton::clicked, this, [this] {
    const QString file = askForFile(tr("Open liver surface"), tr("Surfaces (*.vtp *.vtk *.stl *.ply *.obj)"));
    if (!file.isEmpty()) bench().files.open(file.toStdString(), FileRole::Preop);
  });
}

void SegmentationImportPanel::enter() {
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::PreopOnly;
    options.distanceShown = false;
  });
}

void SegmentationImportPanel::caseChanged(Case::Part part) {
  if (part == Case::Part::Labels) {
    fillTable({});
    countWanted_ = document().labels() != nullptr;
    logic_.settings.labels.clear();
  }
  if (part == Case::Part::Preop && !document().preop()) {
    result_->clear();
    showWarnings(warnings_, {});
  }
}

void SegmentationImportPanel::refresh() {
  if (const auto& labels = document().labels()) {
    const Vector3d spacing = labels->spacing();
    mapFacts_->setText(tr("%1 × %2 × %3 voxels of %4 × %5 × %6 mm")
                           .arg(labels->size.x())
                           .arg(labels->size.y())
                           .arg(labels->size.z())
                           .arg(spacing.x(), 0, 'g', 3)
                           .arg(spacing.y(), 0, 'g', 3)
                           .arg(spacing.z(), 0, 'g', 3));
  } else {
    mapFacts_->setText(tr("No label map is open."));
  }
  showReadiness(import_, missing_, logic_.missingInput());
  if (countWanted_ && !bench().runner.busy()) countLabels();
}

void SegmentationImportPanel::countLabels() {
  countWanted_ = false;
  const auto labels = document().labels();
  bench().runner.start(
      tr("Counting labels"),
      [labels](const Progress& progress) {
        progress.report(0, "counting labels");
        return labelCounts(*labels);
      },
      [this, labels](const std::vector<std::pair<int, std::size_t>>& counts) {
        if (document().labels() == labels) fillTable(counts);
      },
      // Stopped by the user, or by the next file: counted again at the next opportunity only if still the
      // same map.
      {});
}

void SegmentationImportPanel::fillTable(const std::vector<std::pair<int, std::size_t>>& counts) {
  const QSignalBlocker quiet(table_);
  table_->setRowCount(static_cast<int>(counts.size()));
  const double voxelMl = document().labels() ? document().labels()->voxelVolume() / 1000 : 0;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& [label, voxels] = counts[static_cast<std::size_t>(row)];
    auto* tick = new QTableWidgetItem(QString::number(label));
    tick->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
    tick->setCheckState(Qt::Checked);
    tick->setData(Qt::UserRole, label);
    table_->setItem(row, kLabel, tick);
    table_->setItem(row, kVoxels, numberItem(QString("%L1").arg(voxels)));
    table_->setItem(row, kVolume, numberItem(QString::number(static_cast<double>(voxels) * voxelMl, 'f', 1)));
  }
}

void SegmentationImportPanel::readTicks() {
  std::vector<int> ticked;
  for (int row = 0; row < table_->rowCount(); ++row)
    if (table_->item(row, kLabel)->checkState() == Qt::Checked)
      ticked.push_back(table_->item(row, kLabel)->data(Qt::UserRole).toInt());
  // All is said by an empty list, which also holds for the next label map.
  const bool all = static_cast<int>(ticked.size()) == table_->rowCount();
  logic_.settings.labels = all ? std::vector<int>{} : ticked;
  refresh();
}

void SegmentationImportPanel::import() {
  bench().runner.start(tr("Importing the surface"), logic_.prepare(), [this](SurfaceImportResult result) {
    logic_.accept(std::move(result));
    showResult();
  });
}

void SegmentationImportPanel::showResult() {
  const SurfaceImportResult& last = logic_.last();
  if (!document().preop()) return;
  const Surface& surface = *document().preop();
  const QString facts =
      tr("Surface of %L1 vertices and %L2 triangles, %3 ml; the selected voxels hold %4 ml. Shape: %5.")
          .arg(surface.size())
          .arg(surface.triangles.rows())
          .arg(last.surfaceVolumeMm3 / 1000, 0, 'f', 1)
          .arg(last.voxelVolumeMm3 / 1000, 0, 'f', 1)
          .arg(QString::fromStdString(describeTopology(last.topology)));
  result_->setText(facts);
  bench().log.info(facts);
  showWarnings(warnings_, last.warnings);
  for (const std::string& warning : last.warnings) bench().log.warn(QString::fromStdString(warning));
}

}  // namespace falciform
