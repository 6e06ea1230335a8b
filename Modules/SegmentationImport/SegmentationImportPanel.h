#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "Logic/Segmentation/SegmentationImportLogic.h"
#include "Modules/ModulePanel.h"

class QTableWidget;

namespace falciform {

class SettingsForm;

/// Label map -> closed surface: the labels to tick with their voxel counts, settings, Import.
class SegmentationImportPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit SegmentationImportPanel(Workbench& workbench, QWidget* parent = nullptr);

  [[nodiscard]] SegmentationImportLogic& logic() { return logic_; }
  void enter() override;

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addOpenButtons();
  void countLabels();
  void fillTable(const std::vector<std::pair<int, std::size_t>>& counts);
  void readTicks();
  void import();
  void showResult();

  SegmentationImportLogic logic_;
  QLabel *mapFacts_, *missing_, *result_, *warnings_;
  QTableWidget* table_;
  SettingsForm* form_;
  QPushButton* import_;
  bool countWanted_ = false;  // a new label map whose labels have not been counted yet
};

}  // namespace falciform
