#pragma once
#include "Logic/Registration/RegistrationLogic.h"
#include "Modules/ModulePanel.h"
#include "Modules/Registration/PosePreview.h"

class QComboBox;
class QGroupBox;
class QRadioButton;
class QTimer;

namespace falciform {

class BasinTable;
class ConvergenceReplay;
class HandPoseControls;
class LandmarkStart;
class LiveHistory;
class ResultTable;
class SettingsForm;

/// Finds where the scan lies on the liver: method, start, Register and Stop, live curves, figures of the fit,
/// and the other poses there are.
class RegistrationPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit RegistrationPanel(Workbench& workbench, QWidget* parent = nullptr);
  ~RegistrationPanel() override;

  [[nodiscard]] RegistrationLogic& logic() { return logic_; }
  void enter() override;
  void leave() override;

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addSettings();
  void addStart();
  void addRun();
  void addResult();
  void addBasins();
  void applyPreset(const QString& name);
  void viewChanged();

  // The job
  void registerScan(const std::function<RegistrationLogic::Job()>& prepare);
  void registered(RegistrationResult result, const std::shared_ptr<const Surface>& preop,
                  const std::shared_ptr<const Surface>& scan);
  void keepLastPose();
  void endRun();
  void showLive();

  // Poses beside the stored one
  [[nodiscard]] Isometry3d startPreopFromScan() const;
  void moveByHand(bool on);
  void setHandPose(const Isometry3d& preopFromScan);
  void showReplay(int iteration);
  void showBasin(int row);
  void useBasin(std::size_t row);
  [[nodiscard]] std::size_t bestBasin() const;
  void evaluate(RegistrationResult pose);
  void refreshBasins();

  RegistrationLogic logic_;
  PosePreview preview_;
  std::shared_ptr<LiveHistory> live_;
  std::size_t liveShown_ = 0;
  bool running_ = false;                             // the running job is a registration of ours
  Isometry3d runStart_ = Isometry3d::Identity();     // scan from preop, of the last run
  std::optional<Isometry3d> hand_;                   // preop from scan, as placed by hand
  std::shared_ptr<const Surface> handScan_;          // and which scan it was
  std::shared_ptr<const RegistrationResult> found_;  // as registered: choosing a basin leaves it as it is
  bool choosing_ = false;
  QTimer* timer_;
  QComboBox* preset_;
  SettingsForm* form_;
  LandmarkStart* landmarks_;
  HandPoseControls* handControls_;
  QPushButton *register_, *stop_, *useBasin_, *backToBest_;
  QLabel *missing_, *stale_, *warnings_, *basinWords_;
  ConvergenceReplay* convergence_;
  QWidget* beforeAfter_;
  QRadioButton *before_, *after_;
  ResultTable* table_;
  QGroupBox* basinGroup_;
  BasinTable* basins_;
  Connection viewChanged_;
};

}  // namespace falciform
