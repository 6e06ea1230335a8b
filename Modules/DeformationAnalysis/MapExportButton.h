#pragma once
#include <QToolButton>

namespace falciform {

/// All that can be saved of a map, in one menu.
class MapExportButton : public QToolButton {
  Q_OBJECT

 public:
  explicit MapExportButton(QWidget* parent = nullptr);

 Q_SIGNALS:
  void pictureWanted();
  /// The user has chosen a file.
  void mapWanted(const QString& file);
  void tableWanted(const QString& file);
  void copyWanted();

 private:
  void askForFile(const QString& title, const QString& name, const QString& ending,
                  void (MapExportButton::*chosen)(const QString&));
};

}  // namespace falciform
