#include "Modules/Application/Menus.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "Modules/Application/AboutDialog.h"
#include "Modules/Application/Appearance.h"
#include "Modules/Application/CaseActions.h"
#include "Modules/Application/RecentCases.h"
#include "Modules/Application/ShortcutSheet.h"
#include "Widgets/Views/CaseView3D.h"

namespace falciform {
namespace {

void addEntry(QMenu* menu, const char* name, const QString& text, const QKeySequence& keys,
              const QString& tip, std::function<void()> call) {
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  action->setShortcut(keys);
  action->setToolTip(tip);
  action->setStatusTip({});
  QObject::connect(action, &QAction::triggered, menu, std::move(call));
}

/// An entry that is on or off; looked up when the menu opens, since others may change it too.
void addTick(QMenu* menu, const char* name, const QString& text, const QKeySequence& keys, const QString& tip,
             std::function<bool()> isOn, std::function<void(bool)> set) {
  QAction* action = menu->addAction(text);
  action->setObjectName(name);
  action->setShortcut(keys);
  action->setToolTip(tip);
  action->setCheckable(true);
  action->setChecked(isOn());
  QObject::connect(menu, &QMenu::aboutToShow, action, [action, isOn] { action->setChecked(isOn()); });
  QObject::connect(action, &QAction::triggered, action, [action, isOn, set = std::move(set)] {
    set(!isOn());
    action->setChecked(isOn());
  });
}

}  // namespace

void Menus::addTo(QMainWindow& window, const Targets& targets) {
  CaseActions* actions = &targets.actions;
  const auto tr = [](const char* text) { return QObject::tr(text); };
  QMenu* file = window.menuBar()->addMenu(tr("&File"));
  file->setObjectName("fileMenu");
  file->setToolTipsVisible(true);
  addEntry(file, "newCase", tr("&New case"), QKeySequence::New, tr("Begin with an empty case"),
           [actions] { actions->newCase(); });
  addEntry(file, "openCase", tr("Open &case…"), QKeySequence("Ctrl+Shift+O"),
           tr("Open a folder that holds a case.json"), [actions] { actions->chooseCase(); });
  addEntry(file, "openFile", tr("&Open file…"), QKeySequence::Open,
           tr("Open a label map, surface, scan or landmarks; the kind is guessed, and asked for where it is "
              "not clear"),
           targets.openFile);
  QMenu* recent = file->addMenu(tr("&Recent cases"));
  recent->setObjectName("recentCases");
  targets.recent.fill(recent);
  file->addSeparator();
  addEntry(file, "saveCase", tr("&Save case"), QKeySequence::Save, tr("Save the whole case"),
           [actions] { actions->save(); });
  addEntry(file, "saveCaseAs", tr("Save case &as…"), QKeySequence("Ctrl+Shift+S"),
           tr("Save the whole case into another folder"), [actions] { actions->saveAs(); });
  addEntry(file, "screenshot", tr("Save &picture…"), QKeySequence("Ctrl+P"),
           tr("Save the 3D view as PNG, with the research-use notice"), targets.screenshot);
  file->addSeparator();
  addEntry(file, "quit", tr("&Quit"), QKeySequence("Ctrl+Q"), tr("Close the window"), targets.close);

  QMenu* edit = window.menuBar()->addMenu(tr("&Edit"));
  edit->setObjectName("editMenu");
  Workbench* bench = &targets.bench;
  addEntry(edit, "editUndo", tr("&Undo stroke"), QKeySequence::Undo, tr("Take the last stroke back"),
           [bench] {
             if (bench->painting.canUndo()) (void)bench->painting.undo();
             bench->view.brushChanged.emit();
           });
  addEntry(edit, "editRedo", tr("&Redo stroke"), QKeySequence::Redo, tr("Bring the stroke back"), [bench] {
    if (bench->painting.canRedo()) (void)bench->painting.redo();
    bench->view.brushChanged.emit();
  });

  QMenu* view = window.menuBar()->addMenu(tr("&View"));
  view->setObjectName("viewMenu");
  addEntry(view, "fitView", tr("&Fit all"), QKeySequence("Ctrl+0"), tr("Show everything"),
           [shown = &targets.view] { shown->fit(); });
  addEntry(view, "previousStep", tr("&Previous step"), QKeySequence("Ctrl+PgUp"),
           tr("The step of the work before"), [step = targets.step] { step(-1); });
  addEntry(view, "nextStepEntry", tr("&Next step"), QKeySequence("Ctrl+PgDown"),
           tr("The step of the work after"), [step = targets.step] { step(1); });
  view->addSeparator();
  addTick(
      view, "ctSlicesWanted", tr("CT &slices"), QKeySequence("Ctrl+3"),
      tr("Three cuts through the CT or the label map below the 3D view, with the outlines of the surfaces"),
      [bench] { return bench->view.options().slicesWanted; },
      [bench](bool on) { bench->view.edit([on](ViewOptions& options) { options.slicesWanted = on; }); });
  addTick(
      view, "darkTheme", tr("&Dark theme"), QKeySequence("Ctrl+Shift+D"), tr("Light on dark, for a dim room"),
      [] { return darkTheme(); },
      [bench](bool on) {
        setDarkTheme(on);
        bench->view.edit([on](ViewOptions& options) { options.darkScene = on; });
      });
  view->addSeparator();
  for (QDockWidget* dock : window.findChildren<QDockWidget*>())
    if (dock->features() & QDockWidget::DockWidgetClosable) view->addAction(dock->toggleViewAction());

  QMenu* help = window.menuBar()->addMenu(tr("&Help"));
  help->setObjectName("helpMenu");
  addEntry(help, "shortcuts", tr("&Keys and mouse"), QKeySequence("F1"), tr("All keys and mouse moves"),
           [parent = &window] { showShortcuts(parent); });
  help->actions().back()->setShortcuts({QKeySequence("F1"), QKeySequence("?")});
  addEntry(help, "aboutFalciform", tr("&About Falciform"), {}, tr("Version and licences"),
           [parent = &window] { showAbout(parent); });
}

}  // namespace falciform
