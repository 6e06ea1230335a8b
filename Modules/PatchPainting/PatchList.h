#pragma once
#include <QTableWidget>

#include "Modules/Workbench.h"

namespace falciform {

/// The patches, a row each: eye, colour, name, what is painted of it on the chosen surface, lock. The
/// selected row is the patch that the brush paints.
class PatchList : public QTableWidget {
  Q_OBJECT

 public:
  explicit PatchList(Workbench& bench, QWidget* parent = nullptr);

  enum Column { kName, kPoints, kArea, kLength, kPieces, kLock };

  /// Shows the patches of both surfaces of the case, with the figures of `surface` (nullptr: none), and
  /// selects `chosen`.
  void follow(const std::shared_ptr<const Surface>& surface, int chosen);
  [[nodiscard]] int chosen() const;
  /// A new patch on both sides, since it serves registration only if both have it; its label, or 0 if there
  /// are too many.
  int addNamed(const QString& name);
  /// Asks for the chosen patch's colour.
  void askColour();

 Q_SIGNALS:
  void picked(int label);
  /// A lock or a name was changed.
  void edited();

 private:
  void takeEdit(QTableWidgetItem* item);
  void rename(int label, const std::string& name);
  [[nodiscard]] int labelAt(int row) const;

  Workbench& bench_;
  bool filling_ = false;  // the list is writing itself: not the user's edit
  std::shared_ptr<const Surface> measured_;
  std::map<int, QStringList> figures_;  ///< of `measured_`, by label
};

}  // namespace falciform
