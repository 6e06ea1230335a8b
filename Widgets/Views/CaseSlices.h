#pragma once
#include <QWidget>
#include <optional>
#include <vector>

#include "Logic/Core/Case.h"
#include "Widgets/Views/ViewState.h"

class QComboBox;
class QGridLayout;
class QLabel;

namespace falciform {

class SliceView;

/// CT of the case as three cuts with one cursor, the label map over it, and on them the outlines of liver and
/// structures before (dashed) and after a model update. Grey window, tools and seeds are those of the
/// ViewState; what a tool touches is told to it. Follows Case and ViewState.
class CaseSlices : public QWidget {
  Q_OBJECT

 public:
  CaseSlices(Case& document, ViewState& view, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<SliceView*>& views() const { return views_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addViews();
  void addBottom();
  void follow();
  void followExtent();
  void followOutlines();
  void arrange();
  void showReadout(const Vector3d& mm);
  void choosePreset(int index);
  void moveCursors(const Vector3d& mm, const SliceView* but);

  Case& case_;
  ViewState& view_;
  QGridLayout* grid_;
  std::vector<SliceView*> views_;
  QLabel *legend_, *readout_;
  QComboBox* preset_;
  int large_ = 0;  ///< which view is, when one is
  std::optional<bool> arrangedLarge_;
  Vector3d low_ = Vector3d::Zero(), high_ = Vector3d::Zero();  ///< what is shown
  Connection caseChanged_, viewChanged_, wanderTo_;
};

/// A window that shows most of a CT's soft tissue: from its 2nd to its 98th percentile of what is not air.
[[nodiscard]] GreyWindow automaticWindow(const Image& ct);

}  // namespace falciform
