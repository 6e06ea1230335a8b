#include "Modules/Application/MainWindow.h"

#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "Modules/Application/CaseActions.h"
#include "Modules/Application/FileOpener.h"
#include "Modules/Application/Menus.h"
#include "Modules/Application/RecentCases.h"
#include "Modules/ModuleList.h"
#include "Modules/ModulePanel.h"
#include "Version.h"
#include "Widgets/Jobs/JobBar.h"
#include "Widgets/Jobs/LogView.h"
#include "Widgets/Views/CaseTree.h"
#include "Widgets/Views/CaseViews.h"

namespace falciform {
namespace {

constexpr int kPanelWidth = 372, kTreeWidth = 250, kLogHeight = 92;

QToolButton* stepButton(const QString& name, Qt::ArrowType arrow, const QString& tip, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(name);
  button->setArrowType(arrow);
  button->setToolTip(tip);
  return button;
}

QDockWidget* dock(const QString& title, const QString& name, QWidget* content, QMainWindow* window,
                  Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(title, window);
  made->setObjectName(name);
  made->setWidget(content);
  window->addDockWidget(area, made);
  return made;
}

}  // namespace

MainWindow::MainWindow(Workbench& bench)
    : bench_(bench),
      selector_(new QComboBox(this)),
      panels_(new QStackedWidget(this)),
      views_(new CaseViews(bench.document, bench.view, bench.painting, this)),
      recent_(new RecentCases(this)),
      actions_(new CaseActions(bench, *recent_, this)),
      opener_(new FileOpener(bench, *actions_, this)) {
  setObjectName("mainWindow");
  setCentralWidget(views_);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  addModules();
  addTreeAndLog();
  addMenus();
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(new JobBar(bench_.runner, this), 1);
  opener_->takeDropsOn(this);

  connect(&bench_.runner, &JobRunner::failed, this,
          [this](const QString& message) { bench_.log.error(message); });
  connect(&bench_.runner, &JobRunner::cancelled, this,
          [this] { bench_.log.info(tr("Stopped: %1.").arg(bench_.runner.title())); });
  connect(recent_, &RecentCases::chosen, actions_, &CaseActions::openCase);
  // Saving changes the title's mark without a change of the case.
  connect(&bench_.runner, &JobRunner::finished, this, [this] {
    showTitle();
    if (closing_) QTimer::singleShot(0, this, &QWidget::close);
  });
  caseChanged_ = bench_.document.changed.connect([this](Case::Part) { showTitle(); });
  showTitle();
  resize(1280, 800);
  showModuleAt(0);
}

MainWindow::~MainWindow() = default;

void MainWindow::addModules() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 4, 0, 0);
  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 0, 8, 0);
  selector_->setObjectName("moduleSelector");
  selector_->setToolTip(tr("The steps of the work, in order"));
  auto* back = stepButton("previousModule", Qt::LeftArrow, tr("Previous step"), side);
  auto* next = stepButton("nextModule", Qt::RightArrow, tr("Next step"), side);
  row->addWidget(back);
  row->addWidget(selector_, 1);
  row->addWidget(next);
  column->addLayout(row);
  column->addWidget(panels_, 1);
  panels_->setObjectName("panels");
  for (const Module& module : moduleList()) {
    auto* scroll = new QScrollArea(panels_);
    ModulePanel* panel = module.makePanel(bench_, scroll);
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    panels_->addWidget(scroll);
    selector_->addItem(tr(module.title), QString(module.key));
    selector_->setItemData(selector_->count() - 1, tr("Thesis chapter %1").arg(module.chapter),
                           Qt::ToolTipRole);
    connect(panel, &ModulePanel::pictureWanted, this, &MainWindow::savePicture);
  }
  QDockWidget* place = dock(tr("Module"), "moduleDock", side, this, Qt::LeftDockWidgetArea);
  place->setFeatures(QDockWidget::NoDockWidgetFeatures);
  place->setTitleBarWidget(new QWidget(place));  // the selector is title enough
  side->setMinimumWidth(kPanelWidth);
  connect(selector_, qOverload<int>(&QComboBox::activated), this, &MainWindow::showModuleAt);
  connect(back, &QToolButton::clicked, this, [this] { showModuleAt(panels_->currentIndex() - 1); });
  connect(next, &QToolButton::clicked, this, [this] { showModuleAt(panels_->currentIndex() + 1); });
}

void MainWindow::addTreeAndLog() {
  auto* tree = new CaseTree(bench_.document, bench_.view, this);
  QDockWidget* treeDock = dock(tr("Case"), "caseDock", tree, this, Qt::RightDockWidgetArea);
  auto* log = new LogView(bench_.log, this);
  QDockWidget* logDock = dock(tr("Log"), "logDock", log, this, Qt::BottomDockWidgetArea);
  resizeDocks({treeDock}, {kTreeWidth}, Qt::Horizontal);
  resizeDocks({logDock}, {kLogHeight}, Qt::Vertical);
}

void MainWindow::addMenus() {
  Menus::Targets targets{*actions_, *recent_, *view(), bench_};
  targets.openFile = [this] {
    QSettings settings;
    const QStringList files =
        QFileDialog::getOpenFileNames(this, tr("Open files"), settings.value("lastFolder").toString());
    if (files.isEmpty()) return;
    settings.setValue("lastFolder", QFileInfo(files.front()).absolutePath());
    open(files);
  };
  targets.screenshot = [this] { savePicture("falciform.png"); };
  targets.close = [this] { close(); };
  Menus::addTo(*this, targets);
}

CaseView3D* MainWindow::view() const { return views_->main(); }

void MainWindow::open(const QStringList& files) { opener_->open(files); }

ModulePanel* MainWindow::currentPanel() const {
  auto* scroll = qobject_cast<QScrollArea*>(panels_->currentWidget());
  return scroll ? qobject_cast<ModulePanel*>(scroll->widget()) : nullptr;
}

void MainWindow::showModule(const QString& key) {
  const int index = selector_->findData(key);
  if (index >= 0) showModuleAt(index);
}

void MainWindow::showModuleAt(int index) {
  if (index < 0 || index >= panels_->count()) return;
  if (index != panels_->currentIndex())
    if (ModulePanel* old = currentPanel()) old->leave();
  panels_->setCurrentIndex(index);
  selector_->setCurrentIndex(index);
  currentPanel()->enter();
}

void MainWindow::showTitle() {
  // The notice stands in the title whatever the case is called.
  setWindowTitle(
      tr("%1[*] - Falciform - %2").arg(QString::fromStdString(bench_.document.name()), kResearchUse));
  setWindowModified(bench_.document.modified());
}

void MainWindow::savePicture(const QString& suggestedName) {
  QSettings settings;
  QString file = QFileDialog::getSaveFileName(this, tr("Save picture"),
                                              settings.value("lastFolder").toString() + "/" + suggestedName,
                                              tr("PNG pictures (*.png)"));
  if (file.isEmpty()) return;
  if (!file.endsWith(".png", Qt::CaseInsensitive)) file += ".png";
  bench_.runner.start(
      tr("Saving the picture"),
      [write = views_->picture(), path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        write(path);
      },
      [this, file] { bench_.log.info(tr("Saved %1.").arg(QFileInfo(file).fileName())); });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (closing_ && !bench_.runner.busy()) return event->accept();
  event->ignore();
  if (closing_) return;
  actions_->ifNothingIsLost([this] {
    closing_ = true;
    // A running job ends at its next report; its end closes the window. The window stays alive meanwhile.
    if (bench_.runner.busy())
      bench_.runner.cancel();
    else
      QTimer::singleShot(0, this, &QWidget::close);
  });
}

}  // namespace falciform
