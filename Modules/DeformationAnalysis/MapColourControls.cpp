#include "Modules/DeformationAnalysis/MapColourControls.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Views/RangeHistogram.h"

namespace falciform {
namespace {

constexpr double kLargest = 1000;  // of any limit, in the metric's unit
constexpr double kLeast = 1e-6;

}  // namespace

MapColourControls::MapColourControls(ViewState& view, QWidget* parent)
    : QWidget(parent), view_(view), metric_(new QComboBox(this)), histogram_(new RangeHistogram(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* form = new QFormLayout;
  metric_->setObjectName("metric");
  metric_->setToolTip(tr("What is shown as colour, and on which of the two surfaces"));
  form->addRow(metric_);  // its names need the whole width
  addRange(form);
  column->addLayout(form);
  histogram_->setObjectName("histogram");
  histogram_->setEmptyText(tr("The histogram appears here with the distance map."));
  histogram_->setToolTip(
      tr("How many covered places have which value, in the map's colours.\nDrag the two handles to set the "
         "colours' limits; a double click makes them automatic.\nKeys: Left and Right move the marked limit, "
         "Page up and down by ten steps, Space marks the other, Home is automatic."));
  column->addWidget(histogram_);

  connect(metric_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] { chooseMetric(); });
  connect(histogram_, &RangeHistogram::limitsChanged, this, [this](double low, double high) {
    automatic_->setChecked(false);
    setLimits(low, high);
  });
  connect(histogram_, &RangeHistogram::automaticWanted, this, [this] { automatic_->setChecked(true); });
  viewChanged_ = view_.changed.connect([this] { follow(); });
  follow();
}

void MapColourControls::addRange(QFormLayout* form) {
  const auto box = [this](const char* name) {
    auto* made = new NumberBox(this);
    made->setObjectName(name);
    made->setRange(-kLargest, kLargest);
    return made;
  };
  low_ = box("rangeLow");
  high_ = box("rangeHigh");
  threshold_ = box("threshold");
  threshold_->setMinimum(0);
  auto* range = new QHBoxLayout;
  range->addWidget(low_, 1);
  range->addWidget(new QLabel(tr("to"), this));
  range->addWidget(high_, 1);
  form->addRow(tr("Range"), range);
  symmetric_ = new QCheckBox(tr("symmetric"), this);
  symmetric_->setObjectName("rangeSymmetric");
  symmetric_->setChecked(true);
  symmetric_->setToolTip(tr("Both ends of the colours lie equally far from 0"));
  automatic_ = new QCheckBox(tr("automatic"), this);
  automatic_->setObjectName("rangeAutomatic");
  automatic_->setChecked(true);
  automatic_->setToolTip(
      tr("The round symmetric range that holds 98 % of the values of all cases shown; dragging or typing "
         "ends it"));
  auto* kind = new QHBoxLayout;
  kind->addWidget(symmetric_);
  kind->addWidget(automatic_);
  kind->addStretch(1);
  form->addRow(QString(), kind);
  form->addRow(tr("Threshold"), threshold_);
  connect(low_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { typed(true); });
  connect(high_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { typed(false); });
  connect(threshold_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double size) {
    view_.edit([&](ViewOptions& options) { options.distanceColours.threshold = size; });
  });
  connect(symmetric_, &QCheckBox::toggled, this, [this](bool on) {
    histogram_->setSymmetric(on);
    const ScalarMap& now = view_.options().distanceColours;
    const double end = std::max(std::abs(now.low), std::abs(now.high));
    if (on) setLimits(-end, end);
  });
  connect(automatic_, &QCheckBox::toggled, this, [this](bool on) {
    if (on) setAutomatic();
  });
}

void MapColourControls::setCases(const std::vector<MappedCase>& cases) {
  cases_ = cases;
  std::vector<MapMetric> metrics;
  for (const MappedCase& one : cases_)
    for (const MapMetric& metric : metricsOf(*one.map))
      if (std::find(metrics.begin(), metrics.end(), metric) == metrics.end()) metrics.push_back(metric);
  if (metrics != metrics_) {
    const ViewOptions& options = view_.options();
    const MapMetric before = metricOf(options.distanceColours.array, options.distanceOnScan);
    const QSignalBlocker quiet(metric_);
    metrics_ = metrics;
    metric_->clear();
    for (const MapMetric& metric : metrics_) {
      const QString place = metric.onScan ? tr("Scan") : tr("Liver");
      QString title = QString::fromStdString(metric.title);
      if (!title.isEmpty()) title[0] = title[0].toLower();
      const QString unit = metric.unit.empty() ? QString() : ", " + QString::fromStdString(metric.unit);
      metric_->addItem(QString("%1: %2%3").arg(place, title, unit));
    }
    const auto found = std::find(metrics_.begin(), metrics_.end(), before);
    metric_->setCurrentIndex(found == metrics_.end() ? 0 : static_cast<int>(found - metrics_.begin()));
  }
  setEnabled(!metrics_.empty());
  chooseMetric();
}

MapMetric MapColourControls::metric() const {
  const int index = metric_->currentIndex();
  return index >= 0 ? metrics_.at(static_cast<std::size_t>(index)) : metricOf(kSignedDistance, false);
}

void MapColourControls::chooseMetric() {
  const MapMetric chosen = metric();
  const bool other = view_.options().distanceColours.array != chosen.array;
  if (other) {  // a range in mm means nothing in 1/mm
    const QSignalBlocker quiet(automatic_);
    automatic_->setChecked(true);
  }
  count();
  view_.edit([&](ViewOptions& options) {
    options.distanceOnScan = chosen.onScan;
    ScalarMap& colours = options.distanceColours;
    colours.array = chosen.array;
    colours.title = chosen.title;
    colours.unit = chosen.unit;
    if (other) colours.threshold = 0;
    if (automatic_->isChecked() && !metrics_.empty()) {
      colours.low = -scaleEnd_;
      colours.high = scaleEnd_;
    }
  });
  follow();
  Q_EMIT metricChanged();
}

/// The values of all cases together: one range for all.
void MapColourControls::count() {
  const MapMetric chosen = metric();
  Index size = 0, row = 0;
  std::vector<VectorXd> parts;
  for (const MappedCase& one : cases_) {
    parts.push_back(valuesOf(*one.map, chosen.array, chosen.onScan));
    size += parts.back().size();
  }
  VectorXd values(size);
  for (const VectorXd& part : parts) {
    values.segment(row, part.size()) = part;
    row += part.size();
  }
  scaleEnd_ = symmetricEnd(values);
  histogram_->setValues(std::move(values), scaleEnd_);
}

void MapColourControls::setAutomatic() {
  if (!metrics_.empty()) setLimits(-scaleEnd_, scaleEnd_);
}

void MapColourControls::setLimits(double low, double high) {
  view_.edit([&](ViewOptions& options) {
    options.distanceColours.low = low;
    options.distanceColours.high = high;
  });
  follow();  // also where nothing changed: a refused number goes
}

void MapColourControls::typed(bool lowBox) {
  const ScalarMap& now = view_.options().distanceColours;
  double low = low_->value(), high = high_->value();
  if (symmetric_->isChecked()) {
    high = lowBox ? -low : high;
    low = -high;
  }
  if (high - low < kLeast) return setLimits(now.low, now.high);
  const QSignalBlocker quiet(automatic_);
  automatic_->setChecked(false);
  setLimits(low, high);
}

void MapColourControls::follow() {
  const ScalarMap& colours = view_.options().distanceColours;
  const QSignalBlocker a(low_), b(high_), c(threshold_);
  setUnit(QString::fromStdString(colours.unit));
  low_->setValue(colours.low);
  high_->setValue(colours.high);
  threshold_->setValue(colours.threshold);
  histogram_->setColours(colours);
}

void MapColourControls::setUnit(const QString& unit) {
  const QString suffix = unit.isEmpty() ? QString() : " " + unit;
  if (high_->suffix() == suffix && !high_->toolTip().isEmpty()) return;
  const QString range = tr("\nUnit: %1\nRange: %2 to 1000").arg(unit.isEmpty() ? tr("none") : unit);
  low_->setToolTip(tr("Where the colours begin; values below are dark grey.") + range.arg("-1000"));
  high_->setToolTip(tr("Where the colours end; values above are dark grey.") + range.arg("-1000"));
  threshold_->setToolTip(tr("Values of a smaller size than this, either sign, are pale grey; 0: none are.") +
                         range.arg("0"));
  for (NumberBox* box : {low_, high_, threshold_}) box->setSuffix(suffix);
}

}  // namespace falciform
