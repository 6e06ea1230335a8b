#pragma once
#include <QTreeWidget>

#include "Logic/Core/Case.h"
#include "Widgets/Views/ViewState.h"

namespace falciform {

/// What the case holds, a row a part: eye, name, colour, opacity. Writes the ViewState; knows nothing of any
/// view.
class CaseTree : public QTreeWidget {
  Q_OBJECT

 public:
  CaseTree(Case& document, ViewState& view, QWidget* parent = nullptr);

  enum Column { kName, kColour, kOpacity };

 private:
  void rebuild();
  void showLooks();
  QTreeWidgetItem* addPart(const QString& name, const std::string& part, const QString& facts);
  void addFact(const QString& name, const QString& facts);
  void chooseColour(QTreeWidgetItem* item, int column);

  Case& case_;
  ViewState& view_;
  Connection caseChanged_, viewChanged_;
  bool hadSupports_ = false;
  bool filling_ = false;  // the tree is writing itself: not the user's edit
};

}  // namespace falciform
