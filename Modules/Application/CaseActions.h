#pragma once
#include <QObject>
#include <QString>
#include <QWidget>
#include <functional>

#include "Modules/Application/Recovery.h"
#include "Modules/Workbench.h"

namespace falciform {

class RecentCases;

/// New, open, save, and the question before unsaved changes are lost.
class CaseActions : public QObject {
  Q_OBJECT

 public:
  CaseActions(Workbench& bench, RecentCases& recent, QWidget* window);

  void newCase();
  /// Asks for a folder.
  void chooseCase();
  void openCase(const QString& folder);
  void save(std::function<void()> done = {});
  void saveAs(std::function<void()> done = {});
  /// Saves the whole case into `folder`.
  void saveTo(const QString& folder, std::function<void()> done = {});
  /// `next` runs if nothing would be lost, or the user saves or discards; not at all if he turns back.
  void ifNothingIsLost(std::function<void()> next);

  /// Where the case was opened from or saved to; empty for a new one.
  [[nodiscard]] const QString& folder() const { return folder_; }

 Q_SIGNALS:
  /// Saved, discarded or replaced: what was there is not to be recovered.
  void settled();

 public:
  /// Opens what a session that ended badly has left, as changes of the case it belongs to.
  void recover(const Recovery::Found& found, std::function<void()> done);

 private:
  Workbench& bench_;
  RecentCases& recent_;
  QWidget* window_;
  QString folder_;
};

}  // namespace falciform
