#pragma once
#include <memory>

#include "Logic/Atlas/ModelUpdateLogic.h"
#include "Modules/AtlasUpdate/UpdateDisplay.h"
#include "Modules/AtlasUpdate/UpdateWords.h"
#include "Modules/ModulePanel.h"

class QCheckBox;
class QComboBox;
class QTimer;

namespace falciform {

class PlotWidget;
class SettingsForm;
class SliderBox;
class TargetTable;

/// The model updated from the scan: prepare, update and watch it settle, look at it beside the registration,
/// and be told how far to trust it.
class UpdatePage : public ModulePanel {
  Q_OBJECT

 public:
  explicit UpdatePage(Workbench& workbench, QWidget* parent = nullptr);
  ~UpdatePage() override;

  [[nodiscard]] ModelUpdateLogic& logic() { return logic_; }
  [[nodiscard]] const UpdateMaps* maps() const { return maps_.get(); }
  void enter() override;
  void leave() override;

 protected:
  void refresh() override;

 private:
  void addModel();
  void addRun();
  void addLook();
  void addConfidence();
  void addTargets();
  void addExport();
  void prepareModel();
  void openAtlas();
  void makeModel(const QString& title, std::function<ModelUpdateLogic::Model(const Progress&)> make);
  void runUpdate();
  void updated(std::shared_ptr<const UpdateMaps> maps);
  void endRun();
  void showKept();
  void showLive();
  void showCurves(const std::vector<UpdateRecord>& records);
  void showInViews();
  void look(const std::function<void(UpdateLook&)>& change);
  void seeInside(bool on);
  void openTargets(FileRole role, const QString& title);
  QString askWhere(const QString& title, const QString& name, const QString& filter);
  void saveSurface();
  void saveTargets();

  ModelUpdateLogic logic_;
  UpdateLook look_;
  std::shared_ptr<const UpdateMaps> maps_;
  ModelUpdateLogic::Result triedKept_;  ///< the saved result that showKept() was last called for
  std::unique_ptr<UpdateWatch> watch_;  ///< while an update runs
  std::size_t liveShown_ = 0;
  bool entered_ = false, running_ = false, preparing_ = false, seeThrough_ = false;
  std::map<std::string, double> opacityBefore_;
  QTimer* timer_;
  SettingsForm *meshForm_, *fitForm_;
  QPushButton *prepare_, *open_, *cancel_, *update_, *stop_, *rigid_, *updated_;
  QPushButton *targets_, *truth_, *saveSurface_, *saveTargets_, *savePicture_;
  QLabel *modelMissing_, *modelFacts_, *missing_, *liveWords_, *figures_, *meaning_, *confidence_, *stale_,
      *warnings_;
  std::vector<QWidget*> looks_;  ///< that need a result
  PlotWidget* curves_;
  SliderBox* share_;
  QComboBox* colours_;
  QCheckBox *compare_, *slices_, *before_, *inside_;
  TargetTable* table_;
};

}  // namespace falciform
