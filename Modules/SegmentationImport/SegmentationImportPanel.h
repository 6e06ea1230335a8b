#pragma once
#include <map>
#include <optional>
#include <string>

#include "Logic/Segmentation/SegmentationImportLogic.h"
#include "Modules/ModulePanel.h"
#include "Modules/SegmentationImport/LabelTable.h"
#include "Widgets/Jobs/LatestRunner.h"

class QGroupBox;

namespace falciform {

class QualityTable;
class SegmentationBox;
class SettingsForm;

/// CT -> label map by seeds and level set; label map -> closed surface: the labels to tick with their
/// volumes, a preview with its quality, Import.
class SegmentationImportPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit SegmentationImportPanel(Workbench& workbench, QWidget* parent = nullptr);

  [[nodiscard]] SegmentationImportLogic& logic() { return logic_; }
  [[nodiscard]] SegmentationBox& segmentation() { return *segmentation_; }
  void enter() override;
  void leave() override;

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addOpenButtons();
  void addLabels();
  void addSurface();
  void arrangeViews();
  void labelsChanged();
  void countLabels();
  void readTable();
  void chooseColour(int label);
  void preview();
  void import();
  void takeIn(SurfaceImportResult result);
  void showPreview();
  void dropPreview();
  void showResult(const SurfaceImportResult& result, const QString& intro);

  SegmentationImportLogic logic_;
  LatestRunner counting_;
  SegmentationBox* segmentation_ = nullptr;
  LabelTable* table_ = nullptr;
  QualityTable* quality_ = nullptr;
  SettingsForm* form_ = nullptr;
  QLabel *mapFacts_ = nullptr, *missing_ = nullptr, *result_ = nullptr, *warnings_ = nullptr;
  QPushButton *preview_ = nullptr, *import_ = nullptr;
  QGroupBox* segmentationGroup_ = nullptr;
  std::map<int, std::string> names_;              ///< of the labels
  std::optional<SurfaceImportResult> previewed_;  ///< a surface to look at before it is taken in
  std::optional<bool> ownChange_;                 ///< labels change by seeds or brush; true: to a new organ
  bool onScreen_ = false;
  Connection viewChanged_;
};

}  // namespace falciform
