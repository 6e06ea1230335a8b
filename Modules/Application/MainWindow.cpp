#include "Modules/Application/MainWindow.h"

#include <QCloseEvent>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMessageBox>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "Modules/Application/Appearance.h"
#include "Modules/Application/CaseActions.h"
#include "Modules/Application/FileOpener.h"
#include "Modules/Application/Menus.h"
#include "Modules/Application/RecentCases.h"
#include "Modules/Application/Recovery.h"
#include "Modules/Application/WindowState.h"
#include "Modules/ModuleList.h"
#include "Modules/ModulePanel.h"
#include "Modules/NextStep.h"
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
      opener_(new FileOpener(bench, *actions_, this)),
      recovery_(new Recovery(bench, this)) {
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
  caseChanged_ = bench_.document.changed.connect([this](Case::Part) {
    showTitle();
    showNextStep();
  });
  bench_.files.viewToSave = [this] {
    return lookOfWindow(bench_, *view(), selector_->currentData().toString());
  };
  bench_.files.viewOpened = [this](const nlohmann::json& state) {
    restoreWindow(state, bench_, *view(), [this](const QString& key) { showModule(key); });
  };
  recovery_->caseFolder = [this] { return actions_->folder(); };
  connect(actions_, &CaseActions::settled, recovery_, &Recovery::forget);
  bench_.view.edit([](ViewOptions& options) { options.darkScene = darkTheme(); });
  warned_ = bench_.view.warned.connect(
      [this](const std::string& why) { bench_.log.warn(QString::fromStdString(why)); });
  showTitle();
  showNextStep();
  resize(1280, 800);
  showModuleAt(0);
}

MainWindow::~MainWindow() {
  bench_.files.viewToSave = nullptr;
  bench_.files.viewOpened = nullptr;
}

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
  next_ = new QToolButton(side);
  next_->setObjectName("nextStep");
  next_->setToolTip(tr("What this case needs next; click to go there"));
  next_->setAutoRaise(true);
  next_->setFocusPolicy(Qt::TabFocus);
  next_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  next_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(next_, &QToolButton::clicked, this, &MainWindow::goToNextStep);
  auto* nextRow = new QHBoxLayout;
  nextRow->setContentsMargins(8, 0, 8, 0);
  nextRow->addWidget(next_);
  column->addLayout(nextRow);
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
  targets.step = [this](int by) { showModuleAt(panels_->currentIndex() + by); };
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

void MainWindow::showNextStep() { next_->setText(tr("Next: %1").arg(nextStep(bench_.document).words)); }

void MainWindow::goToNextStep() {
  const NextStep step = nextStep(bench_.document);
  if (step.target) bench_.painting.target = *step.target;
  showModule(step.module);
  bench_.view.brushChanged.emit();
}

void MainWindow::offerRecovery() {
  const QList<Recovery::Found> left = recovery_->left();
  if (left.isEmpty()) return;
  const Recovery::Found found = left.front();
  QMessageBox box(
      QMessageBox::Question, tr("Recover the last case"),
      tr("The program ended unexpectedly. Of the case \"%1\" there are changes of %2 that were not saved.")
          .arg(found.name, found.time),
      QMessageBox::Open | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("recovery");
  box.setInformativeText(tr("Open them? Discard deletes them; Cancel asks again at the next start."));
  box.setDefaultButton(QMessageBox::Open);
  const int answer = box.exec();
  if (answer == QMessageBox::Discard) return Recovery::remove(found);
  if (answer != QMessageBox::Open) return;
  actions_->recover(found, [this, found] {
    recovery_->keep();  // under this session's name, before the old one goes
    Recovery::remove(found);
    QStringList rest;
    for (const QString& file : {found.ct, found.labels})
      if (!file.isEmpty() && QFileInfo::exists(file)) rest << file;
    QTimer::singleShot(0, this, [this, rest] { open(rest); });
  });
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
  if (closing_ && !bench_.runner.busy()) {
    recovery_->forget();
    return event->accept();
  }
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
