#include "Modules/Application/RecentCases.h"

#include <QDir>
#include <QSettings>

namespace falciform {
namespace {

constexpr char kKey[] = "recentCases";

}  // namespace

QStringList RecentCases::folders() const { return QSettings().value(kKey).toStringList(); }

void RecentCases::add(const QString& folder) {
  QStringList list = folders();
  list.removeAll(folder);
  list.prepend(folder);
  QSettings().setValue(kKey, QStringList(list.mid(0, kMost)));
}

void RecentCases::fill(QMenu* menu) {
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QString& folder : folders()) {
      if (!QDir(folder).exists("case.json")) continue;
      QAction* action =
          menu->addAction(QDir(folder).dirName(), this, [this, folder] { Q_EMIT chosen(folder); });
      action->setToolTip(folder);
    }
    if (menu->isEmpty()) menu->addAction(tr("No recent cases"))->setEnabled(false);
  });
  menu->setToolTipsVisible(true);
}

}  // namespace falciform
