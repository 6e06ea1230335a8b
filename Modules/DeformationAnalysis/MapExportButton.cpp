#include "Modules/DeformationAnalysis/MapExportButton.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace falciform {

MapExportButton::MapExportButton(QWidget* parent) : QToolButton(parent) {
  setObjectName("exportMenu");
  setText(tr("Export"));
  setToolTip(tr("Save the view as a picture, the map as a surface, the table for a spreadsheet"));
  setPopupMode(QToolButton::InstantPopup);
  setToolButtonStyle(Qt::ToolButtonTextOnly);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* menu = new QMenu(this);
  menu->setToolTipsVisible(true);
  const auto entry = [&](const char* name, const QString& text, const QString& tip, auto call) {
    QAction* action = menu->addAction(text);
    action->setObjectName(name);
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this, call);
  };
  entry("exportPicture", tr("Picture (PNG)…"), tr("What the view shows, with the research-use notice"),
        [this] { Q_EMIT pictureWanted(); });
  entry("exportMap", tr("Map (VTP)…"),
        tr("The coloured surface with its values, in the patient's frame (LPS, mm)"),
        [this] { askForFile(tr("Export map"), "distance_map", "vtp", &MapExportButton::mapWanted); });
  entry("exportTable", tr("Table (CSV)…"), tr("Every metric of every case shown, by region"),
        [this] { askForFile(tr("Export table"), "distance", "csv", &MapExportButton::tableWanted); });
  entry("copyTable", tr("Copy table"), tr("What the table shows, for a spreadsheet"),
        [this] { Q_EMIT copyWanted(); });
  setMenu(menu);
}

void MapExportButton::askForFile(const QString& title, const QString& name, const QString& ending,
                                 void (MapExportButton::*chosen)(const QString&)) {
  QSettings settings;
  QString file = QFileDialog::getSaveFileName(
      this, title, QString("%1/%2.%3").arg(settings.value("lastFolder").toString(), name, ending),
      QString("%1 (*.%2)").arg(ending.toUpper(), ending));
  if (file.isEmpty()) return;
  if (!file.endsWith("." + ending, Qt::CaseInsensitive)) file += "." + ending;
  settings.setValue("lastFolder", QFileInfo(file).absolutePath());
  Q_EMIT(this->*chosen)(file);
}

}  // namespace falciform
