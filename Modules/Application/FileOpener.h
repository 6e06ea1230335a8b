#pragma once
#include <QObject>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>

#include "Modules/Workbench.h"

namespace falciform {

class CaseActions;

/// Opens files of any kind, one after the other, however they came: menu, drop, command line. Guesses what
/// each is, and asks where the name does not tell.
class FileOpener : public QObject {
  Q_OBJECT

 public:
  FileOpener(Workbench& bench, CaseActions& actions, QWidget* window);

  void open(const QStringList& files);
  /// Takes drops on `target` and its children.
  void takeDropsOn(QWidget* target);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void openNext();
  [[nodiscard]] std::optional<FileRole> roleOf(const QString& file);

  Workbench& bench_;
  CaseActions& actions_;
  QWidget* window_;
  QStringList waiting_;
};

}  // namespace falciform
