#pragma once
#include <QWidget>
#include <vector>

#include "Widgets/Views/ViewState.h"

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace falciform {

class NumberBox;
class RangeHistogram;

/// Which metric is shown, and in what colours: its range, by typing, by dragging in the histogram or
/// automatic, and the size below which values are grey. Writes ViewOptions, and follows them.
class MapColourControls : public QWidget {
  Q_OBJECT

 public:
  explicit MapColourControls(ViewState& view, QWidget* parent = nullptr);

  /// What is looked at: the metrics to choose from are theirs, and so are the values of the histogram.
  void setCases(const std::vector<MappedCase>& cases);
  /// The one that is shown; of the first case's where nothing is chosen yet.
  [[nodiscard]] MapMetric metric() const;

 Q_SIGNALS:
  void metricChanged();

 private:
  void addRange(QFormLayout* form);
  void chooseMetric();
  void count();
  void setAutomatic();
  void setLimits(double low, double high);
  void typed(bool lowBox);
  void follow();
  void setUnit(const QString& unit);

  ViewState& view_;
  std::vector<MappedCase> cases_;
  std::vector<MapMetric> metrics_;
  double scaleEnd_ = 10;  ///< the automatic range of what is shown
  QComboBox* metric_;
  NumberBox *low_, *high_, *threshold_;
  QCheckBox *symmetric_, *automatic_;
  RangeHistogram* histogram_;
  Connection viewChanged_;
};

}  // namespace falciform
