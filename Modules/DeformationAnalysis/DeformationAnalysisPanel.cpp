#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"

#include <QFileInfo>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Modules/DeformationAnalysis/ComparedCases.h"
#include "Modules/DeformationAnalysis/MapColourControls.h"
#include "Modules/DeformationAnalysis/MapExportButton.h"
#include "Modules/DeformationAnalysis/StatisticsTable.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform {

DeformationAnalysisPanel::DeformationAnalysisPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench, tr("Measures how far the liver in the scan lies from its pre-operative shape."),
                  parent),
      logic_(document()) {
  addMap();
  auto* colours = addGroup(tr("Colours"));
  colours_ = new MapColourControls(bench().view, this);
  colours->addWidget(colours_);
  table_ = new StatisticsTable(this);
  column()->addWidget(table_);  // in no group, whose frame would take room from seven columns
  facts_ = wrappedLabel("distanceFacts", this);
  column()->addWidget(facts_);
  auto* others = addGroup(tr("Other cases"));
  compared_ = new ComparedCases(
      bench(), [this] { return logic_.settings; }, this);
  others->addWidget(compared_);
  addExport();

  connect(compute_, &QPushButton::clicked, this, &DeformationAnalysisPanel::compute);
  connect(colours_, &MapColourControls::metricChanged, this, [this] { showRows(); });
  connect(compared_, &ComparedCases::changed, this, [this] {
    showCases();
    refresh();
  });
  viewChanged_ = bench().view.changed.connect([this] {
    if (rowsOf_ != bench().view.options().enlargedCase) showRows();
  });
  start();
  showSegments({});
  showCases();
}

void DeformationAnalysisPanel::addMap() {
  auto* group = addGroup(tr("Distance map"));
  form_ = new SettingsForm(logic_.settings, {}, {}, this);
  form_->setObjectName("distanceSettings");
  group->addWidget(form_);
  auto* row = new QHBoxLayout;
  segments_ = wrappedLabel("segmentsFile", this);
  openSegments_ = new QPushButton(tr("Segments…"), this);
  openSegments_->setObjectName("openSegments");
  openSegments_->setToolTip(tr(
      "A map of the Couinaud segments of the same CT (labels 1 to 8, mm): the table and the line below the "
      "view then name them"));
  row->addWidget(segments_, 1);
  row->addWidget(openSegments_);
  group->addLayout(row);
  connect(openSegments_, &QPushButton::clicked, this, [this] {
    const QString file =
        askForFile(tr("Open segments"), tr("Label maps (*.nii *.nii.gz *.nrrd *.mha *.mhd)"));
    if (!file.isEmpty()) openSegments(file);
  });
  compute_ = new QPushButton(tr("Compute distances"), this);
  compute_->setObjectName("compute");
  compute_->setToolTip(
      tr("Signed distance in mm between the registered scan and the surface, on both sides"));
  group->addWidget(compute_);
  missing_ = wrappedLabel("missing", this);
  group->addWidget(missing_);
  sign_ = wrappedLabel("signMeaning", this);
  group->addWidget(sign_);
}

void DeformationAnalysisPanel::addExport() {
  export_ = new MapExportButton(this);
  column()->addWidget(export_);
  connect(export_, &MapExportButton::pictureWanted, this, [this] { Q_EMIT pictureWanted("distance.png"); });
  connect(export_, &MapExportButton::mapWanted, this, &DeformationAnalysisPanel::exportMap);
  connect(export_, &MapExportButton::tableWanted, this, &DeformationAnalysisPanel::exportTable);
  connect(export_, &MapExportButton::copyWanted, this, [this] {
    table_->copy();
    bench().log.info(tr("Copied the table."));
  });
}

void DeformationAnalysisPanel::enter() {
  onScreen_ = true;
  bench().view.edit([&](ViewOptions& options) {
    options.arrangement = Arrangement::Together;
    options.afterRegistration = true;
    options.distanceShown = true;
    options.galleryShown = compared_->sideBySide();
  });
}

void DeformationAnalysisPanel::leave() {
  onScreen_ = false;
  bench().view.edit([](ViewOptions& options) { options.galleryShown = false; });
}

void DeformationAnalysisPanel::caseChanged(Case::Part part) {
  if (part == Case::Part::Distance || part == Case::Part::Name || part == Case::Part::Registration)
    showCases();
  if (part == Case::Part::Preop && !document().preop()) {  // the next liver has segments of its own
    logic_.segments = nullptr;
    showSegments({});
  }
}

void DeformationAnalysisPanel::refresh() {
  showReadiness(compute_, missing_, logic_.missingInput());
  compared_->refresh();
  openSegments_->setEnabled(!bench().runner.busy());
  export_->setEnabled(!shownCases().empty() && !bench().runner.busy());
}

std::optional<MappedCase> DeformationAnalysisPanel::ownCase() {
  if (!document().distance()) return std::nullopt;
  MappedCase own{document().name(), document().distance(), Matrix4d::Identity()};
  if (document().registration()) own.lpsFromMap = document().registration()->scanFromPreop.inverse().matrix();
  return own;
}

std::vector<MappedCase> DeformationAnalysisPanel::shownCases() {
  std::vector<MappedCase> cases;
  if (const auto own = ownCase()) cases.push_back(*own);
  if (compared_->sideBySide())
    cases.insert(cases.end(), compared_->cases().begin(), compared_->cases().end());
  return cases;
}

std::optional<MappedCase> DeformationAnalysisPanel::caseInFront() {
  const std::vector<MappedCase> cases = shownCases();
  if (cases.empty()) return std::nullopt;
  const int large = bench().view.options().enlargedCase;
  const bool one = compared_->sideBySide() && large >= 0 && large < static_cast<int>(cases.size());
  return cases[one ? static_cast<std::size_t>(large) : 0];
}

void DeformationAnalysisPanel::showCases() {
  const std::vector<MappedCase> cases = shownCases();
  bench().view.edit([&](ViewOptions& options) {
    if (options.mappedCases != cases) options.enlargedCase = -1;
    options.mappedCases = cases;
    options.galleryShown = onScreen_ && compared_->sideBySide();
  });
  colours_->setCases(cases);  // announces the metric, and so the rows
}

void DeformationAnalysisPanel::showRows() {
  const MapMetric metric = colours_->metric();
  const std::vector<MappedCase> cases = shownCases();
  rowsOf_ = bench().view.options().enlargedCase;
  const std::optional<MappedCase> front = caseInFront();
  const bool all = compared_->sideBySide() && rowsOf_ < 0;
  std::vector<RegionRow> rows;
  if (front) rows = all ? caseRows(cases, metric) : regionRows(*front->map, metric);
  table_->show(rows, metric, all ? tr("Case") : metric.onScan ? tr("Scan") : tr("Liver"));
  sign_->setText(metric.meaning.empty()
                     ? QString()
                     : QString::fromStdString(metric.meaning) + tr("; negative: the reverse."));
  sign_->setVisible(!metric.meaning.empty());
  if (front && !all)
    facts_->setText(
        (compared_->sideBySide() ? QString::fromStdString(front->name) + ": " : QString()) +
        tr("the scan covers %1 % of the liver's surface.").arg(100 * front->map->coverage, 0, 'f', 1));
  else
    facts_->setText(front ? QString()
                    : document().registrationStale()
                        ? tr("The registration is out of date: register again first.")
                        : tr("The table appears here with the distance map."));
  facts_->setVisible(!facts_->text().isEmpty());
}

void DeformationAnalysisPanel::compute() {
  bench().runner.start(
      tr("Computing distances"), logic_.prepare(),
      [this, registration = document().registration()](DistanceMap map) {
        if (document().registration() != registration || document().registrationStale()) {
          bench().log.warn(tr("The case changed while distances were computed: the map is dropped."));
          return;
        }
        const DistanceStatistics& scan = map.scanAll;
        bench().log.info(tr("Distance map: scan mean %1 mm, SD %2 mm over %L3 places.")
                             .arg(scan.mean, 0, 'f', 2)
                             .arg(scan.sd, 0, 'f', 2)
                             .arg(scan.count));
        logic_.accept(std::move(map));
        bench().view.edit([](ViewOptions& options) { options.distanceShown = true; });
      });
}

void DeformationAnalysisPanel::openSegments(const QString& file) {
  bench().runner.start(
      tr("Opening segments"),
      [path = file.toStdString()](const Progress& progress) {
        progress.report(0, "reading the label map");
        return readLabelMap(path);
      },
      [this, name = QFileInfo(file).fileName()](Loaded<LabelMap> loaded) {
        for (const std::string& warning : loaded.warnings) bench().log.warn(QString::fromStdString(warning));
        logic_.segments = std::make_shared<const LabelMap>(std::move(loaded.value));
        showSegments(name);
      });
}

void DeformationAnalysisPanel::showSegments(const QString& file) {
  segments_->setText(file.isEmpty() ? tr("No map of segments") : tr("Segments: %1").arg(file));
}

void DeformationAnalysisPanel::exportTable(const QString& file) {
  bench().runner.start(
      tr("Exporting the table"),
      [cases = shownCases(), path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        writeTextFile(path, Overwrite::Replace, regionsCsv(cases));  // the file dialog has asked already
      },
      [this, file] { bench().log.info(tr("Saved %1.").arg(QFileInfo(file).fileName())); });
}

void DeformationAnalysisPanel::exportMap(const QString& file) {
  const std::optional<MappedCase> front = caseInFront();
  if (!front) return;
  bench().runner.start(
      tr("Exporting the map"),
      [front, onScan = colours_->metric().onScan, path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        Isometry3d lpsFromMap;
        lpsFromMap.matrix() = front->lpsFromMap;
        writeSurface(path, transformed(sideOf(*front->map, onScan), lpsFromMap, "LPS"), Overwrite::Replace);
      },
      [this, file, name = front->name] {
        bench().log.info(
            tr("Saved the map of %1 in %2.").arg(QString::fromStdString(name), QFileInfo(file).fileName()));
      });
}

}  // namespace falciform
