#pragma once
#include "Logic/Registration/RegistrationLogic.h"
#include "Modules/ModulePanel.h"

class QCheckBox;
class QComboBox;
class QRadioButton;
class QTimer;

namespace falciform {

class LiveHistory;
class PlotWidget;
class ResultTable;
class SettingsForm;

/// Finds where the scan lies on the liver: method, start, Register and Stop, live curves, figures of the fit.
class RegistrationPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit RegistrationPanel(Workbench& workbench, QWidget* parent = nullptr);
  ~RegistrationPanel() override;

  [[nodiscard]] RegistrationLogic& logic() { return logic_; }
  void enter() override;

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addSettings();
  void addRun();
  void addResult();
  void applyPreset(const QString& name);
  void registerScan();
  void keepLastPose();
  void endRun();
  void showLive();
  void plot(const std::vector<IterationRecord>& records);

  RegistrationLogic logic_;
  std::shared_ptr<LiveHistory> live_;
  bool running_ = false;  // the running job is ours
  QTimer* timer_;
  QComboBox* preset_;
  SettingsForm* form_;
  QCheckBox* landmarks_;
  QPushButton *register_, *stop_;
  QLabel *missing_, *stale_, *warnings_;
  PlotWidget* curves_;
  QRadioButton *before_, *after_;
  ResultTable* table_;
  Connection viewChanged_;
};

}  // namespace falciform
