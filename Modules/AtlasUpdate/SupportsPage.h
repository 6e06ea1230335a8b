#pragma once
#include "Logic/Biomechanics/SupportLogic.h"
#include "Modules/ModulePanel.h"

class QCheckBox;

namespace falciform {

class LiveDeformation;
class SettingsForm;
class SliderBox;
class SupportBrush;
class SupportTable;

/// The mechanical model of the liver, the supports painted on it, and the liver as they move it, live: to try
/// what packing does. The scan has no part in it; UpdatePage follows the scan.
class SupportsPage : public ModulePanel {
  Q_OBJECT

 public:
  explicit SupportsPage(Workbench& workbench, QWidget* parent = nullptr);
  ~SupportsPage() override;

  [[nodiscard]] SupportLogic& logic() { return logic_; }
  void enter() override;
  void leave() override;
  /// Another support to paint, fixed at first.
  void addRegion(const QString& name);

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addModel();
  void addSupports();
  void addLive();
  void prepareModel();
  void fillTemplate();
  void choose(int label);
  /// The case's supports with `change(SupportPainting&)`.
  void edit(const std::function<void(SupportPainting&)>& change);
  void showModelFacts();
  void showLiver();

  SupportLogic logic_;
  LiveDeformation* live_;
  bool entered_ = false;
  int chosen_ = support_label::kLeftPacking;
  PaintTarget targetBefore_ = PaintTarget::Preop;
  int labelBefore_ = patch::kFalciform;
  SettingsForm *modelForm_, *templateForm_;
  QPushButton *prepare_, *fill_;
  QLabel *missing_, *facts_, *liveMissing_, *figures_, *warnings_;
  SupportTable* table_;
  SupportBrush* brush_;
  SliderBox *push_, *turn_;
  QCheckBox* colours_;
  Connection viewChanged_, brushChanged_;
};

}  // namespace falciform
