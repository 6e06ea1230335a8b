#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"

#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "Logic/IO/OutputFile.h"
#include "Logic/IO/ResultFiles.h"
#include "Modules/DeformationAnalysis/StatisticsTable.h"
#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Forms/SettingsForm.h"
#include "Widgets/Rendering/Histogram.h"
#include "Widgets/Rendering/ScalarMap.h"
#include "Widgets/Views/PlotWidget.h"

namespace falciform {
namespace {

VectorXd distancesOf(const Surface& side) {
  const auto found = side.arrays.find(kSignedDistance);
  return found == side.arrays.end() ? VectorXd() : found->second;
}

/// Round, and holds every value of both sides.
double fittedLimit(const DistanceMap& map) {
  return symmetricMap(kSignedDistance, "", "mm", {&map.preop, &map.scan}).high;
}

PlotWidget::Bars barsOf(const Surface& side, double limitMm, const QString& name, const QColor& colour) {
  const Histogram histogram = histogramOf(distancesOf(side), -limitMm, limitMm, binWidth(-limitMm, limitMm));
  PlotWidget::Bars bars{name, colour, {histogram.low}, {}};
  for (const double share : histogram.shares) {
    bars.edges << bars.edges.back() + histogram.width;
    bars.heights << 100 * share;
  }
  return bars;
}

}  // namespace

DeformationAnalysisPanel::DeformationAnalysisPanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench, tr("Measures how far the liver in the scan lies from its pre-operative shape."),
                  parent),
      logic_(document()) {
  QLabel* sign = wrappedLabel("signMeaning", this);
  sign->setText(
      tr("Positive (red) means that the intra-operative surface lies outside the pre-operative one, negative "
         "(blue) "
         "inside; grey places have no value."));
  column()->addWidget(sign);

  auto* group = addGroup(tr("Distance map"));
  form_ = new SettingsForm(logic_.settings, {}, {}, this);
  form_->setObjectName("distanceSettings");
  group->addWidget(form_);
  compute_ = new QPushButton(tr("Compute distances"), this);
  compute_->setObjectName("compute");
  compute_->setToolTip(
      tr("Signed distance in mm between the registered scan and the surface, on both sides"));
  group->addWidget(compute_);
  missing_ = wrappedLabel("missing", this);
  group->addWidget(missing_);
  facts_ = wrappedLabel("distanceFacts", this);
  group->addWidget(facts_);

  addColours();
  table_ = new StatisticsTable(this);
  column()->addWidget(table_);
  addExport();

  connect(compute_, &QPushButton::clicked, this, &DeformationAnalysisPanel::compute);
  viewChanged_ = bench().view.changed.connect([this] {
    const QSignalBlocker quiet(limit_);
    limit_->setValue(bench().view.options().distanceLimitMm);
    (bench().view.options().distanceOnScan ? onScan_ : onPreop_)->setChecked(true);
  });
  onPreop_->setChecked(true);
  start();
  showNumbers();
}

void DeformationAnalysisPanel::addColours() {
  auto* group = addGroup(tr("Colours and threshold"));
  auto* form = new QFormLayout;
  onPreop_ = new QRadioButton(tr("Liver"), this);
  onPreop_->setObjectName("distanceOnPreop");
  onPreop_->setToolTip(tr("Colours on the pre-operative liver: distance in mm to the scan"));
  onScan_ = new QRadioButton(tr("Scan"), this);
  onScan_->setObjectName("distanceOnScan");
  onScan_->setToolTip(tr("Colours on the scan: distance in mm to the pre-operative liver"));
  auto* sides = new QHBoxLayout;
  sides->addWidget(onPreop_);
  sides->addWidget(onScan_);
  form->addRow(tr("Show on"), sides);
  const auto show = [this](bool onScan) {
    bench().view.edit([&](ViewOptions& options) { options.distanceOnScan = onScan; });
  };
  connect(onPreop_, &QRadioButton::clicked, this, [show] { show(false); });
  connect(onScan_, &QRadioButton::clicked, this, [show] { show(true); });
  limit_ = new NumberBox(this);
  limit_->setObjectName("colourLimit");
  limit_->setRange(0.1, 200);
  limit_->setPrefix(QString::fromUtf8("± "));
  limit_->setSuffix(" mm");
  limit_->setValue(bench().view.options().distanceLimitMm);
  limit_->setToolTip(
      tr("Colours run from minus to plus this distance; values beyond are dark grey.\nUnit: mm\nRange: 0.1 "
         "to 200"));
  fitRange_ = new QPushButton(tr("Fit"), this);
  fitRange_->setObjectName("fitRange");
  fitRange_->setToolTip(tr("The round limit, in mm, that holds every value"));
  auto* row = new QHBoxLayout;
  row->addWidget(limit_, 1);
  row->addWidget(fitRange_);
  form->addRow(tr("Range"), row);
  threshold_ = new NumberBox(this);
  threshold_->setObjectName("threshold");
  threshold_->setRange(0.1, 200);
  threshold_->setSuffix(" mm");
  threshold_->setValue(thresholdMm_);
  threshold_->setToolTip(
      tr("The table's last column: share of places whose distance is at most this.\nUnit: mm\nRange: 0.1 to "
         "200\nDefault: 5"));
  form->addRow(tr("Threshold"), threshold_);
  group->addLayout(form);
  histogram_ = new PlotWidget(this);
  histogram_->setObjectName("histogram");
  histogram_->setTitles(tr("Signed distance, mm"), tr("Share of covered places, %"));
  histogram_->setEmptyText(tr("The histogram appears here with the distance map."));
  histogram_->setToolTip(tr(
      "Signed distance in mm against the share of covered places in %; dashed lines stand at the threshold"));
  group->addWidget(histogram_);
  connect(limit_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          &DeformationAnalysisPanel::setLimit);
  connect(threshold_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double mm) {
    thresholdMm_ = mm;
    showNumbers();
  });
  connect(fitRange_, &QPushButton::clicked, this, [this] {
    if (document().distance()) setLimit(fittedLimit(*document().distance()));
  });
}

void DeformationAnalysisPanel::addExport() {
  auto* row = new QHBoxLayout;
  csv_ = new QPushButton(tr("Export CSV…"), this);
  csv_->setObjectName("exportCsv");
  csv_->setToolTip(tr("Save the statistics by side and patch, in mm, as a table"));
  png_ = new QPushButton(tr("Export PNG…"), this);
  png_->setObjectName("exportPng");
  png_->setToolTip(tr("Save the 3D view with its colour bar as a picture"));
  row->addWidget(csv_);
  row->addWidget(png_);
  column()->addLayout(row);
  connect(csv_, &QPushButton::clicked, this, [this] {
    QSettings settings;
    const QString folder = settings.value("lastFolder").toString();
    const QString file = QFileDialog::getSaveFileName(this, tr("Export statistics"), folder + "/distance.csv",
                                                      tr("CSV (*.csv)"));
    if (!file.isEmpty()) exportCsv(file);
  });
  connect(png_, &QPushButton::clicked, this, [this] { Q_EMIT pictureWanted("distance.png"); });
}

void DeformationAnalysisPanel::enter() {
  bench().view.edit([&](ViewOptions& options) {
    options.arrangement = Arrangement::Together;
    options.afterRegistration = true;
    options.distanceShown = true;
  });
}

void DeformationAnalysisPanel::caseChanged(Case::Part part) {
  if (part != Case::Part::Distance) return;
  if (document().distance()) setLimit(fittedLimit(*document().distance()));
  showNumbers();
}

void DeformationAnalysisPanel::refresh() {
  showReadiness(compute_, missing_, logic_.missingInput());
  const bool have = document().distance() != nullptr;
  csv_->setEnabled(have && !bench().runner.busy());
  png_->setEnabled(have);
  fitRange_->setEnabled(have);
  if (have)
    facts_->setText(tr("The scan covers %1 % of the liver's surface.")
                        .arg(100 * document().distance()->coverage, 0, 'f', 1));
  else
    facts_->setText(document().registrationStale()
                        ? tr("The registration is out of date: register again first.")
                        : QString());
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

void DeformationAnalysisPanel::setLimit(double limitMm) {
  bench().view.edit([&](ViewOptions& options) { options.distanceLimitMm = limitMm; });
  showNumbers();
}

void DeformationAnalysisPanel::showNumbers() {
  const auto& map = document().distance();
  table_->show(map.get(), thresholdMm_);
  if (!map) {
    histogram_->clear();
    return;
  }
  const double limit = bench().view.options().distanceLimitMm;
  histogram_->setBars({barsOf(map->preop, limit, tr("on the liver"), QColor("#0072b2")),
                       barsOf(map->scan, limit, tr("on the scan"), QColor("#e69f00"))});
  histogram_->setMarkers({-thresholdMm_, thresholdMm_});
}

void DeformationAnalysisPanel::exportCsv(const QString& file) {
  bench().runner.start(
      tr("Exporting statistics"),
      [map = document().distance(), path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        writeTextFile(path, Overwrite::Replace, toCsv(*map));  // the file dialog has asked already
      },
      [this, file] { bench().log.info(tr("Saved %1.").arg(QFileInfo(file).fileName())); });
}

}  // namespace falciform
