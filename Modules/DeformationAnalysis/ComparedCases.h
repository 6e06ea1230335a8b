#pragma once
#include <QStringList>
#include <QWidget>
#include <functional>

#include "Logic/Deformation/DistanceMapping.h"
#include "Modules/Workbench.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace falciform {

/// Other cases beside the open one: opened from their folders (a map that is missing is computed) as a job,
/// kept while the window is open, and shown beside it or alone.
class ComparedCases : public QWidget {
  Q_OBJECT

 public:
  /// `settings` are those by which missing maps are computed, asked for when they are.
  ComparedCases(Workbench& bench, std::function<DistanceSettings()> settings, QWidget* parent = nullptr);

  /// Opens what the folder (or case.json, or .vtp) holds, and shows it beside what is there.
  void open(const QString& place);

  [[nodiscard]] const std::vector<MappedCase>& cases() const { return cases_; }
  [[nodiscard]] bool sideBySide() const;
  void refresh();

 Q_SIGNALS:
  /// Other cases, or shown otherwise.
  void changed();

 private:
  void choose(const QString& title);

  Workbench& bench_;
  std::function<DistanceSettings()> settings_;
  std::vector<MappedCase> cases_;
  QPushButton *compare_, *cohort_, *clear_;
  QCheckBox* sideBySide_;
  QLabel* names_;
};

}  // namespace falciform
