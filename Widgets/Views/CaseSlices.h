#pragma once
#include <QWidget>
#include <vector>

#include "Logic/Core/Case.h"
#include "Widgets/Views/ViewState.h"

class QLabel;

namespace falciform {

class SliceView;

/// CT or label map of the case as three cuts with one cursor, and on them the outlines of liver and
/// structures before (dashed) and after a model update. Follows Case and ViewState.
class CaseSlices : public QWidget {
  Q_OBJECT

 public:
  CaseSlices(Case& document, ViewState& view, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<SliceView*>& views() const { return views_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void follow();
  void followExtent();

  Case& case_;
  ViewState& view_;
  std::vector<SliceView*> views_;
  QLabel* legend_;
  std::shared_ptr<const Surface> extentOf_;
  Connection caseChanged_, viewChanged_;
};

}  // namespace falciform
