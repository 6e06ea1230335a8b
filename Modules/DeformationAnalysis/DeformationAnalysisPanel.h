#pragma once
#include "Logic/Deformation/DeformationLogic.h"
#include "Modules/ModulePanel.h"

class QRadioButton;

namespace falciform {

class NumberBox;
class PlotWidget;
class SettingsForm;
class StatisticsTable;

/// The signed distance between scan and liver: map, colour range, histogram, statistics by patch, export.
class DeformationAnalysisPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit DeformationAnalysisPanel(Workbench& workbench, QWidget* parent = nullptr);

  [[nodiscard]] DeformationLogic& logic() { return logic_; }
  void enter() override;
  /// Writes the statistics as CSV, as a job.
  void exportCsv(const QString& file);

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addColours();
  void addExport();
  void compute();
  void showNumbers();
  void setLimit(double limitMm);

  DeformationLogic logic_;
  double thresholdMm_ = 5;
  SettingsForm* form_;
  QPushButton *compute_, *csv_, *png_, *fitRange_;
  QRadioButton *onPreop_, *onScan_;
  NumberBox *limit_, *threshold_;
  QLabel *missing_, *facts_;
  PlotWidget* histogram_;
  StatisticsTable* table_;
  Connection viewChanged_;
};

}  // namespace falciform
