#pragma once
#include <QMainWindow>
#include <QStringList>

#include "Modules/Workbench.h"

class QComboBox;
class QStackedWidget;
class QToolButton;

namespace falciform {

class CaseActions;
class CaseView3D;
class CaseViews;
class FileOpener;
class ModulePanel;
class RecentCases;
class Recovery;

/// The window: selector and panel of the module on the left, the 3D view in the middle, the case's parts on
/// the right, job and log at the foot. It only places these; what they do is theirs.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `bench` must outlive the window.
  explicit MainWindow(Workbench& bench);
  ~MainWindow() override;

  /// Opens cases or files of any kind, one after the other.
  void open(const QStringList& files);
  /// Shows the module with this key of moduleList(); unknown keys are ignored.
  void showModule(const QString& key);
  [[nodiscard]] ModulePanel* currentPanel() const;
  [[nodiscard]] CaseView3D* view() const;
  [[nodiscard]] CaseViews& views() const { return *views_; }
  [[nodiscard]] Recovery& recovery() const { return *recovery_; }
  /// Asks whether to go on with what a session that ended badly has left, if there is any.
  void offerRecovery();

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void addModules();
  void addTreeAndLog();
  void addMenus();
  void showModuleAt(int index);
  void showTitle();
  void showNextStep();
  void goToNextStep();
  void savePicture(const QString& suggestedName);

  Workbench& bench_;
  QComboBox* selector_;
  QStackedWidget* panels_;
  CaseViews* views_;
  RecentCases* recent_;
  CaseActions* actions_;
  FileOpener* opener_;
  Recovery* recovery_;
  QToolButton* next_ = nullptr;
  bool closing_ = false;  // the user has agreed to close; a job may still be stopping
  Connection caseChanged_, warned_;
};

}  // namespace falciform
