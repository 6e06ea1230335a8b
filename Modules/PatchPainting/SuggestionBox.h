#pragma once
#include <QWidget>
#include <vector>

#include "Logic/Patches/FeatureSuggestions.h"
#include "Modules/Workbench.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace falciform {

/// Ridge and groove as the program would mark them on the pre-operative liver: looked for as a job, drawn as
/// a line, painted when accepted.
class SuggestionBox : public QWidget {
  Q_OBJECT

 public:
  explicit SuggestionBox(Workbench& bench, QWidget* parent = nullptr);

  void refresh();

 Q_SIGNALS:
  /// Painted as patch `label`.
  void accepted(int label);

 private:
  void look();
  void take(const std::shared_ptr<const Surface>& of, FeatureSuggestions found);
  void show(int index);
  void accept();

  Workbench& bench_;
  std::shared_ptr<const Surface> of_;  ///< what they are of
  std::vector<FeatureSuggestion> found_;
  QPushButton *look_, *accept_, *drop_;
  QComboBox* list_;
  QLabel* words_;
};

}  // namespace falciform
