#pragma once
#include "Logic/Acquisition/ScanPreparationLogic.h"
#include "Modules/ModulePanel.h"
#include "Widgets/Jobs/LatestRunner.h"

class QCheckBox;

namespace falciform {

class ScanBrush;
class SettingsForm;

/// A raw range scan becomes the liver's surface: its unit confirmed, false returns and other tissue marked in
/// colours as the settings change, mended by a brush, then taken out; and back to the raw scan if that was
/// wrong.
class ScanPreparationPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit ScanPreparationPanel(Workbench& workbench, QWidget* parent = nullptr);
  ~ScanPreparationPanel() override;

  [[nodiscard]] ScanPreparationLogic& logic() { return logic_; }
  void enter() override;
  void leave() override;

 protected:
  void refresh() override;

 private:
  void addOpen();
  void addSettings();
  void addMending();
  void addFinish();
  void mark();
  void settingsEdited();
  void apply();
  void showFacts();
  void showCounts();

  ScanPreparationLogic logic_;
  LatestRunner preview_;
  QLabel *facts_, *unit_, *counts_, *missing_, *warnings_;
  SettingsForm* form_;
  QCheckBox* live_;
  ScanBrush* brush_;
  QPushButton *mark_, *apply_, *restore_;
  Connection viewChanged_, brushChanged_;
  PaintTarget targetBefore_ = PaintTarget::Preop;  ///< of the other steps
  int labelBefore_ = patch::kFalciform;
};

}  // namespace falciform
