#pragma once
#include "Modules/ModulePanel.h"

class QButtonGroup;

namespace falciform {

class SupportsPage;
class UpdatePage;

/// Two pages: the model updated from the scan, and supports tried by hand. One is on screen at a time.
class AtlasUpdatePanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit AtlasUpdatePanel(Workbench& workbench, QWidget* parent = nullptr);

  [[nodiscard]] UpdatePage& update() { return *update_; }
  [[nodiscard]] SupportsPage& supports() { return *supports_; }
  void enter() override;
  void leave() override;

 protected:
  void refresh() override {}

 private:
  enum Page { kUpdate, kSupports };
  void showPage(int page);
  [[nodiscard]] ModulePanel& page(int page) const;

  UpdatePage* update_;
  SupportsPage* supports_;
  QButtonGroup* pages_;
  int shown_ = kUpdate;
  bool entered_ = false;
};

}  // namespace falciform
