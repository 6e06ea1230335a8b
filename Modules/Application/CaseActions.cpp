#include "Modules/Application/CaseActions.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>

#include "Modules/Application/RecentCases.h"

namespace falciform {
namespace {

QString lastFolder() { return QSettings().value("lastFolder", QDir::homePath()).toString(); }

QString caseFolderOf(const QString& path) {
  const QFileInfo info(path);
  return info.isDir() ? info.absoluteFilePath() : info.absolutePath();
}

}  // namespace

CaseActions::CaseActions(Workbench& bench, RecentCases& recent, QWidget* window)
    : QObject(window), bench_(bench), recent_(recent), window_(window) {}

void CaseActions::newCase() {
  ifNothingIsLost([this] {
    folder_.clear();
    bench_.document.clear();
    bench_.view.edit([](ViewOptions& options) {
      options.looks.clear();
      options.patchLooks.clear();
    });
    Q_EMIT settled();
    bench_.log.info(tr("New case."));
  });
}

void CaseActions::chooseCase() {
  const QString folder = QFileDialog::getExistingDirectory(window_, tr("Open case folder"), lastFolder());
  if (!folder.isEmpty()) openCase(folder);
}

void CaseActions::openCase(const QString& path) {
  ifNothingIsLost([this, path] {
    bench_.files.open(path.toStdString(), FileRole::Case, [this, path] {
      folder_ = caseFolderOf(path);
      Q_EMIT settled();
      recent_.add(folder_);
      QSettings().setValue("lastFolder", QFileInfo(folder_).absolutePath());
    });
  });
}

void CaseActions::save(std::function<void()> done) {
  if (folder_.isEmpty())
    saveAs(std::move(done));
  else
    saveTo(folder_, std::move(done));
}

void CaseActions::saveAs(std::function<void()> done) {
  const QString suggested = lastFolder() + "/" + QString::fromStdString(bench_.document.name());
  const QString folder =
      QFileDialog::getSaveFileName(window_, tr("Save case as folder"), suggested, tr("Case folders (*)"),
                                   nullptr, QFileDialog::ShowDirsOnly | QFileDialog::DontConfirmOverwrite);
  if (folder.isEmpty()) return;
  const QDir chosen(folder);
  if (chosen.exists() && !chosen.isEmpty()) {
    const bool isCase = chosen.exists("case.json");
    const QString question =
        isCase ? tr("%1 holds a case already. Replace it?").arg(chosen.dirName())
               : tr("%1 holds other files. Save the case among them?").arg(chosen.dirName());
    if (QMessageBox::question(window_, tr("Save case"), question) != QMessageBox::Yes) return;
  }
  saveTo(folder, std::move(done));
}

void CaseActions::saveTo(const QString& folder, std::function<void()> done) {
  bench_.files.save(folder.toStdString(), [this, folder, done = std::move(done)] {
    folder_ = QFileInfo(folder).absoluteFilePath();
    recent_.add(folder_);
    QSettings().setValue("lastFolder", QFileInfo(folder_).absolutePath());
    if (!bench_.document.modified()) Q_EMIT settled();
    if (done) done();
  });
}

void CaseActions::recover(const Recovery::Found& found, std::function<void()> done) {
  bench_.files.open((found.folder + "/case").toStdString(), FileRole::Case,
                    [this, found, done = std::move(done)] {
                      folder_ = found.caseFolder;
                      bench_.document.setName(bench_.document.name());  // not saved where it belongs
                      if (done) done();
                    });
}

void CaseActions::ifNothingIsLost(std::function<void()> next) {
  if (!bench_.document.modified()) return next();
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("The case \"%1\" has changes that are not saved.")
                      .arg(QString::fromStdString(bench_.document.name())),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box.setObjectName("unsavedChanges");
  box.setInformativeText(tr("Save them first?"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      save([this, next] {
        if (!bench_.document.modified()) next();
      });
      break;
    case QMessageBox::Discard:
      Q_EMIT settled();
      next();
      break;
    default:
      break;
  }
}

}  // namespace falciform
