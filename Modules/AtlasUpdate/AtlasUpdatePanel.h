#pragma once
#include "Modules/ModulePanel.h"

namespace falciform {

/// Says what the model update will need and which of it the case holds already. There is no atlas in this
/// version.
class AtlasUpdatePanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit AtlasUpdatePanel(Workbench& workbench, QWidget* parent = nullptr);

  void enter() override;

 protected:
  void refresh() override;

 private:
  QLabel* needs_;
};

}  // namespace falciform
