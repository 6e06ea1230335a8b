#pragma once
#include <QWidget>

#include "Modules/Workbench.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace falciform {

/// The panel of one module: a column of controls on a logic class. refresh() runs whenever the case or the
/// running job changes; everything a panel shows follows from it, so no control can be left behind.
class ModulePanel : public QWidget {
  Q_OBJECT

 public:
  ~ModulePanel() override;

  /// The module is on screen now, or no longer: sets up the views for its step.
  virtual void enter() {}
  virtual void leave() {}

 Q_SIGNALS:
  /// The user wants a picture of the 3D view; the window knows the view.
  void pictureWanted(const QString& suggestedName);

 protected:
  ModulePanel(Workbench& workbench, const QString& purpose, QWidget* parent);

  /// Controls follow case, view and job. Called once by start(), then at every change.
  virtual void refresh() = 0;
  /// One part of the case changed; refresh() follows.
  virtual void caseChanged(Case::Part) {}
  /// Last line of a constructor: connects, and calls refresh() for the first time.
  void start();

  [[nodiscard]] Workbench& bench() { return bench_; }
  [[nodiscard]] Case& document() { return bench_.document; }
  [[nodiscard]] QVBoxLayout* column() { return column_; }

  /// A titled group at the end of the column.
  QVBoxLayout* addGroup(const QString& title);
  /// A label that wraps; `name` is its objectName.
  static QLabel* wrappedLabel(const QString& name, QWidget* parent);
  /// Shows what is missing in words, and disables `button` while it is or while a job runs.
  void showReadiness(QPushButton* button, QLabel* words, const std::string& missing);
  /// A file dialog that starts where the last one ended; empty if the user changed his mind.
  QString askForFile(const QString& title, const QString& filter);
  /// Warnings into the log, and as one bullet list into `label`, which hides when there is none.
  void showWarnings(QLabel* label, const std::vector<std::string>& warnings);

 private:
  Workbench& bench_;
  QVBoxLayout* column_;
  Connection caseConnection_;
};

}  // namespace falciform
