#pragma once
#include <optional>
#include <vector>

#include "Logic/Deformation/DeformationLogic.h"
#include "Modules/ModulePanel.h"

namespace falciform {

class ComparedCases;
class MapColourControls;
class MapExportButton;
class SettingsForm;
class StatisticsTable;

/// What differs between scan and liver: map, colours, histogram, values by region; other cases beside it;
/// export.
class DeformationAnalysisPanel : public ModulePanel {
  Q_OBJECT

 public:
  explicit DeformationAnalysisPanel(Workbench& workbench, QWidget* parent = nullptr);

  [[nodiscard]] DeformationLogic& logic() { return logic_; }
  [[nodiscard]] ComparedCases& compared() { return *compared_; }
  void enter() override;
  void leave() override;
  /// Writes the values by region of every case shown as CSV, as a job.
  void exportTable(const QString& file);
  /// Writes the coloured surface of the case in front, in LPS, as a job.
  void exportMap(const QString& file);
  /// Reads a map of Couinaud segments, as a job: the next map is by segment as well.
  void openSegments(const QString& file);

 protected:
  void refresh() override;
  void caseChanged(Case::Part part) override;

 private:
  void addMap();
  void addExport();
  void compute();
  void showCases();
  void showRows();
  void showSegments(const QString& file);
  [[nodiscard]] std::optional<MappedCase> ownCase();
  /// What the views show: the open case, or all of them.
  [[nodiscard]] std::vector<MappedCase> shownCases();
  /// Of these the one shown large, or the only one, or the first.
  [[nodiscard]] std::optional<MappedCase> caseInFront();

  DeformationLogic logic_;
  SettingsForm* form_;
  QPushButton *compute_, *openSegments_;
  QLabel *segments_, *sign_, *missing_, *facts_;
  MapColourControls* colours_;
  StatisticsTable* table_;
  ComparedCases* compared_;
  MapExportButton* export_;
  bool onScreen_ = false;
  int rowsOf_ = -1;  // the enlarged case that the table is of
  Connection viewChanged_;
};

}  // namespace falciform
