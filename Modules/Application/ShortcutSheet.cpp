#include "Modules/Application/ShortcutSheet.h"

#include <QAction>
#include <QDialog>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace falciform {
namespace {

QString tr(const char* text) { return QObject::tr(text); }

QString row(const QString& keys, const QString& what) {
  return QString("<tr><td style='padding-right:18px'><b>%1</b></td><td>%2</td></tr>")
      .arg(keys.toHtmlEscaped(), what.toHtmlEscaped());
}

QString head(const QString& title) { return QString("<tr><td colspan=2><h3>%1</h3></td></tr>").arg(title); }

QString menuRows(const QMenu* menu) {
  QString rows;
  for (const QAction* action : menu->actions()) {
    if (action->shortcut().isEmpty()) continue;
    QString text = action->text();
    rows +=
        row(action->shortcut().toString(QKeySequence::NativeText), text.remove('&').remove(QChar(0x2026)));
  }
  return rows;
}

QString sheet(const QMainWindow* window) {
  QString html = "<table cellspacing=2>";
  html += head(tr("Any view"));
  html += row(tr("left drag"), tr("turn"));
  html += row(tr("middle drag, Shift + left drag"), tr("move"));
  html += row(tr("right drag, wheel"), tr("zoom"));
  html += row("R", tr("fit all"));
  html += row("Shift + A P R L S I", tr("from the front, back, right, left, head, feet"));
  html += head(tr("Slices"));
  html += row(tr("left click"), tr("move all cuts there, or use the tool; with Ctrl always move"));
  html += row(tr("wheel, arrows"), tr("next cut"));
  html += row(tr("right drag"), tr("grey window: width to the right, level upwards"));
  html += row(tr("Ctrl + wheel, middle drag, R"), tr("zoom, shift, all again"));
  html += row(tr("double click"), tr("the large one"));
  html += head(tr("While painting"));
  html += row(tr("left drag or click"), tr("what the tool does"));
  html += row(tr("Ctrl, Shift or Alt + drag"), tr("turn or move, as when not painting"));
  html += row(tr("Shift + wheel, + and -"), tr("brush radius x 1.2, x 0.8"));
  html += row("1 - 9", tr("patch 1 to 9"));
  html += row("0", tr("eraser"));
  html += row("Z, Y", tr("undo, redo a step"));
  html += row(tr("Enter, double click"), tr("line: paint it"));
  html += row(tr("Backspace"), tr("line: take the last point back"));
  html += row("Esc", tr("drop a line or lasso; leave painting"));
  for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) {
    const QString rows = menuRows(menu);
    if (!rows.isEmpty()) html += head(QString(menu->title()).remove('&')) + rows;
  }
  html += head(tr("Panels"));
  html += row(tr("Alt + underlined letter"), tr("the control of that name"));
  html += row(tr("Ctrl + Page up, Ctrl + Page down"), tr("previous, next step of the work"));
  html += row(tr("Ctrl + U, Ctrl + T"), tr("update the model; rigid and updated to and fro"));
  return html + "</table>";
}

}  // namespace

void showShortcuts(QMainWindow* window) {
  if (auto* open = window->findChild<QDialog*>("shortcutSheet")) {
    open->raise();
    open->activateWindow();
    return;
  }
  auto* dialog = new QDialog(window);
  dialog->setObjectName("shortcutSheet");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Keys and mouse"));
  auto* text = new QTextBrowser(dialog);
  text->setObjectName("shortcutText");
  text->setToolTip(tr("All keys and mouse moves; Esc closes"));
  text->setHtml(sheet(window));
  auto* column = new QVBoxLayout(dialog);
  column->setContentsMargins(8, 8, 8, 8);
  column->addWidget(text);
  dialog->resize(520, 640);
  dialog->show();
}

}  // namespace falciform
