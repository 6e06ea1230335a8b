#include "Modules/SegmentationImport/SegmentationImportPanel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QFileDialog>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "Modules/SegmentationImport/QualityTable.h"
#include "Modules/SegmentationImport/SegmentationBox.h"
#include "Modules/SegmentationImport/SeriesChooser.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {

SegmentationImportPanel::SegmentationImportPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench,
                  tr("Grows the liver in a CT from a few clicks, and turns the liver of a label map into a "
                     "closed surface; or takes a surface that exists already."),
                  parent),
      logic_(document()),
      counting_(workbench.runner.mode()) {
  addOpenButtons();
  auto* column = addGroup(tr("Segment the CT"));
  segmentationGroup_ = qobject_cast<QGroupBox*>(column->parentWidget());
  segmentation_ = new SegmentationBox(workbench, this);
  segmentation_->setObjectName("segmentation");
  column->addWidget(segmentation_);
  addLabels();
  addSurface();
  connect(segmentation_, &SegmentationBox::changing, this, [this](bool fresh) { ownChange_ = fresh; });
  connect(segmentation_, &SegmentationBox::changed, this, [this] { ownChange_.reset(); });
  connect(&counting_, &LatestRunner::failed, this, [this](const QString& why) { bench().log.error(why); });
  viewChanged_ =
      bench().view.changed.connect([this] { table_->setColours(bench().view.options().labelColours); });
  labelsChanged();
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
  auto* openCt = new QPushButton(tr("Open CT…"), this);
  openCt->setObjectName("openCt");
  openCt->setToolTip(tr("NIfTI, NRRD or MetaImage in Hounsfield units"));
  auto* second = new QHBoxLayout;
  row->addWidget(openFolder);
  row->addWidget(openCt);
  second->addWidget(openMap);
  second->addWidget(openSurface);
  column()->addLayout(row);
  column()->addLayout(second);
  connect(openFolder, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open DICOM folder"));
    if (!folder.isEmpty()) openDicom(bench(), folder.toStdString(), this);
  });
  const QString volumes = "(*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd)";
  const auto opens = [this](QPushButton* button, const QString& title, const QString& filter, FileRole role) {
    connect(button, &QPushButton::clicked, this, [this, title, filter, role] {
      const QString file = askForFile(title, filter);
      if (!file.isEmpty()) bench().files.open(file.toStdString(), role);
    });
  };
  opens(openCt, tr("Open CT"), tr("CT volumes ") + volumes, FileRole::Ct);
  opens(openMap, tr("Open label map"), tr("Label maps ") + volumes, FileRole::Labels);
  opens(openSurface, tr("Open liver surface"), tr("Surfaces (*.vtp *.vtk *.stl *.ply *.obj)"),
        FileRole::Preop);
}

void SegmentationImportPanel::addLabels() {
  auto* labels = addGroup(tr("Labels"));
  mapFacts_ = wrappedLabel("mapFacts", this);
  labels->addWidget(mapFacts_);
  table_ = new LabelTable(this);
  labels->addWidget(table_);
  auto* shown = new QCheckBox(tr("Show over the CT"), this);
  shown->setObjectName("labelsShown");
  shown->setToolTip(tr("Lay the labels over the CT in the slices"));
  shown->setChecked(true);
  labels->addWidget(shown);
  connect(shown, &QCheckBox::toggled, this,
          [this](bool on) { bench().view.edit([on](ViewOptions& options) { options.labelsShown = on; }); });
  connect(table_, &LabelTable::edited, this, &SegmentationImportPanel::readTable);
  connect(table_, &LabelTable::paintLabelChanged, segmentation_, &SegmentationBox::setPaintLabel);
  connect(table_, &LabelTable::colourWanted, this, &SegmentationImportPanel::chooseColour);
}

void SegmentationImportPanel::addSurface() {
  auto* settings = addGroup(tr("Surface"));
  form_ = new SettingsForm(logic_.settings, {"edgeLengthMm"}, {"labels"}, this);
  form_->setObjectName("importSettings");
  settings->addWidget(form_);
  preview_ = new QPushButton(tr("Preview"), this);
  preview_->setObjectName("previewSurface");
  preview_->setToolTip(tr("Make the surface and show it with its quality; the case stays as it is"));
  import_ = new QPushButton(tr("Import"), this);
  import_->setObjectName("import");
  import_->setToolTip(
      tr("Make the surface from the ticked labels, or take the one that is previewed; replaces the case's "
         "pre-operative surface"));
  auto* row = new QHBoxLayout;
  row->addWidget(preview_, 1);
  row->addWidget(import_, 1);
  column()->addLayout(row);
  missing_ = wrappedLabel("missing", this);
  column()->addWidget(missing_);
  result_ = wrappedLabel("importResult", this);
  column()->addWidget(result_);
  quality_ = new QualityTable(this);
  column()->addWidget(quality_);
  warnings_ = wrappedLabel("warnings", this);
  column()->addWidget(warnings_);
  showWarnings(warnings_, {});
  connect(form_, &SettingsForm::edited, this, [this] { dropPreview(); });
  connect(preview_, &QPushButton::clicked, this, &SegmentationImportPanel::preview);
  connect(import_, &QPushButton::clicked, this, &SegmentationImportPanel::import);
}

void SegmentationImportPanel::enter() {
  onScreen_ = true;
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::PreopOnly;
    options.distanceShown = false;
  });
  arrangeViews();
  segmentation_->enter();
  showPreview();
}

void SegmentationImportPanel::leave() {
  onScreen_ = false;
  segmentation_->leave();
  bench().view.edit([](ViewOptions& options) { options.slicesShown = options.slicesLarge = false; });
}

/// Slices to work in, where there is something to cut.
void SegmentationImportPanel::arrangeViews() {
  if (!onScreen_) return;
  const bool slices = document().ct() || document().labels();
  bench().view.edit([slices](ViewOptions& options) { options.slicesShown = options.slicesLarge = slices; });
}

void SegmentationImportPanel::caseChanged(Case::Part part) {
  if (part == Case::Part::Labels) labelsChanged();
  if (part == Case::Part::Ct) segmentation_->forget();
  if (part == Case::Part::Labels || part == Case::Part::Ct) arrangeViews();
  if (part == Case::Part::Preop && !document().preop()) {
    result_->clear();
    quality_->clearResult();
    showWarnings(warnings_, {});
  }
}

void SegmentationImportPanel::labelsChanged() {
  dropPreview();
  if (!ownChange_) names_ = bench().files.labelNames();
  if (ownChange_.value_or(false)) names_.clear();
  if (ownChange_.value_or(true)) {
    table_->forget();
    logic_.settings.labels.clear();
    logic_.structures.clear();
  }
  if (!ownChange_ || !document().labels()) table_->setCounts({}, 0, {});
  countLabels();
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
  segmentationGroup_->setVisible(document().ct() || document().labels());
  segmentation_->refresh();
  showReadiness(import_, missing_, logic_.missingInput());
  preview_->setEnabled(import_->isEnabled());
}

void SegmentationImportPanel::countLabels() {
  const auto labels = document().labels();
  if (!labels) return counting_.drop();
  counting_.submit([labels] { return labelCounts(*labels); },
                   [this, labels](const LabelTable::Counts& counts) {
                     if (document().labels() != labels) return;
                     table_->setCounts(counts, labels->voxelVolume() / 1000, names_);
                     logic_.structures = table_->structures();
                   });
}

void SegmentationImportPanel::readTable() {
  dropPreview();
  logic_.settings.labels = table_->liverLabels();
  logic_.structures = table_->structures();
  refresh();
}

void SegmentationImportPanel::chooseColour(int label) {
  const auto& colours = bench().view.options().labelColours;
  const auto own = colours.find(label);
  const auto now = own == colours.end() ? labelColour(label) : own->second;
  const QColor colour = QColorDialog::getColor(QColor::fromRgbF(now[0], now[1], now[2]), this,
                                               tr("Colour of label %1").arg(label));
  if (!colour.isValid()) return;
  bench().view.edit([&](ViewOptions& options) {
    options.labelColours[label] = {colour.redF(), colour.greenF(), colour.blueF()};
  });
}

void SegmentationImportPanel::preview() {
  bench().runner.start(tr("Making the surface"), logic_.prepare(),
                       [this, labels = document().labels()](SurfaceImportResult result) {
                         if (document().labels() != labels) return;
                         segmentation_->dropSketch();
                         previewed_ = std::move(result);
                         showPreview();
                         showResult(*previewed_, tr("Not in the case yet: press Import. "));
                       });
}

void SegmentationImportPanel::import() {
  if (previewed_) {
    SurfaceImportResult result = std::move(*previewed_);
    dropPreview();
    return takeIn(std::move(result));
  }
  bench().runner.start(tr("Importing the surface"), logic_.prepare(),
                       [this](SurfaceImportResult result) { takeIn(std::move(result)); });
}

void SegmentationImportPanel::takeIn(SurfaceImportResult result) {
  logic_.accept(std::move(result));
  segmentation_->dropSketch();
  bench().view.edit([](ViewOptions& options) { options.previewSurface = nullptr; });
  showResult(logic_.last(), {});
  if (logic_.structures.empty()) return;
  bench().runner.start(tr("Importing vessels and tumours"), logic_.prepareStructures(),
                       [this](std::map<std::string, Surface> surfaces) {
                         QStringList names;
                         for (const auto& [name, surface] : surfaces) names << QString::fromStdString(name);
                         logic_.acceptStructures(std::move(surfaces));
                         bench().log.info(tr("Imported %1.").arg(names.join(", ")));
                       });
}

void SegmentationImportPanel::showPreview() {
  if (!previewed_ || !onScreen_) return;
  bench().view.edit([this](ViewOptions& options) {
    options.previewSurface = std::make_shared<const Surface>(previewed_->surface);
    options.previewCaption = "Preview: not in the case yet";
    options.previewIsSketch = false;
  });
}

void SegmentationImportPanel::dropPreview() {
  if (!previewed_) return;
  previewed_.reset();
  result_->clear();
  quality_->clearResult();
  showWarnings(warnings_, {});
  bench().view.edit([](ViewOptions& options) { options.previewSurface = nullptr; });
}

void SegmentationImportPanel::showResult(const SurfaceImportResult& result, const QString& intro) {
  const Surface& surface = result.surface;
  const QString facts =
      tr("Surface of %L1 vertices and %L2 triangles, %3 ml; the selected voxels hold %4 ml. Shape: %5.")
          .arg(surface.size())
          .arg(surface.triangles.rows())
          .arg(result.surfaceVolumeMm3 / 1000, 0, 'f', 1)
          .arg(result.voxelVolumeMm3 / 1000, 0, 'f', 1)
          .arg(QString::fromStdString(describeTopology(result.topology)));
  result_->setText(intro + facts);
  quality_->setResult(result);
  bench().log.info(facts);
  showWarnings(warnings_, result.warnings);
  for (const std::string& warning : result.warnings) bench().log.warn(QString::fromStdString(warning));
}

}  // namespace falciform
