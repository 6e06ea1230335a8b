#include "Modules/Application/FileOpener.h"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QInputDialog>
#include <QMimeData>
#include <QTimer>
#include <QUrl>

#include "Logic/IO/VolumeFiles.h"
#include "Modules/Application/CaseActions.h"
#include "Modules/SegmentationImport/SeriesChooser.h"

namespace falciform {

FileOpener::FileOpener(Workbench& bench, CaseActions& actions, QWidget* window)
    : QObject(window), bench_(bench), actions_(actions), window_(window) {
  // Queued, so that whoever else waits for the job's end comes first.
  connect(&bench_.runner, &JobRunner::finished, this, &FileOpener::openNext, Qt::QueuedConnection);
}

void FileOpener::open(const QStringList& files) {
  waiting_ += files;
  openNext();
}

void FileOpener::takeDropsOn(QWidget* target) {
  target->setAcceptDrops(true);
  target->installEventFilter(this);
}

bool FileOpener::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::DragEnter) {
    auto* drag = static_cast<QDragEnterEvent*>(event);
    if (drag->mimeData()->hasUrls()) {
      drag->acceptProposedAction();
      return true;
    }
  } else if (event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    QStringList files;
    for (const QUrl& url : drop->mimeData()->urls())
      if (url.isLocalFile()) files << url.toLocalFile();
    drop->acceptProposedAction();
    // After the drop has been answered: a question may come up, and the file's owner should not wait for it.
    QTimer::singleShot(0, this, [this, files] { open(files); });
    return true;
  }
  return QObject::eventFilter(watched, event);
}

std::optional<FileRole> FileOpener::roleOf(const QString& file) {
  const QString name = QFileInfo(file).fileName();
  const std::vector<FileRole> roles = guessFileRoles(file.toStdString());
  if (roles.empty()) {
    bench_.log.error(tr("%1 is no file that can be opened here; open a DICOM folder, a label map (NIfTI, "
                        "NRRD, MetaImage), a "
                        "surface or scan (VTP, "
                        "VTK, STL, PLY, OBJ, PCD, XYZ, CSV, RGBD, PNG of depths), landmarks (.mrk.json, "
                        ".fcsv) or a case folder.")
                         .arg(name));
    return std::nullopt;
  }
  if (roles.size() == 1) return roles.front();
  QStringList names;
  for (const FileRole role : roles)
    names << QString::fromUtf8(fileRoleName(role).data(), int(fileRoleName(role).size()));
  bool chosen = false;
  const QString answer = QInputDialog::getItem(window_, tr("What is this file?"), tr("Open %1 as").arg(name),
                                               names, 0, false, &chosen);
  if (!chosen) return std::nullopt;
  return roles[static_cast<std::size_t>(names.indexOf(answer))];
}

void FileOpener::openNext() {
  if (waiting_.isEmpty() || bench_.runner.busy()) return;
  const QString file = waiting_.takeFirst();
  if (!QFileInfo::exists(file)) {
    bench_.log.error(tr("%1 does not exist; check the name.").arg(file));
  } else if (const std::filesystem::path path = file.toStdString();
             !std::filesystem::exists(path / "case.json") && !isVolumeFile(path) && isDicom(path)) {
    openDicom(bench_, path, window_);
  } else if (const auto role = roleOf(file)) {
    if (*role == FileRole::Case)
      actions_.openCase(file);
    else
      bench_.files.open(file.toStdString(), *role);
  }
  if (!waiting_.isEmpty() && !bench_.runner.busy()) openNext();
}

}  // namespace falciform
