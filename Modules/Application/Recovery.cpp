#include "Modules/Application/Recovery.h"

#include <QDateTime>
#include <QDir>
#include <QStandardPaths>
#include <QUuid>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/JsonFile.h"

namespace falciform {
namespace {

constexpr char kStateFile[] = "recovery.json";

QString textOf(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? QString::fromStdString(found->get<std::string>())
                                                   : QString();
}

}  // namespace

Recovery::Recovery(Workbench& bench, QObject* parent, const QString& folder)
    : QObject(parent),
      bench_(bench),
      root_(!folder.isEmpty()
                ? folder
                : QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery"),
      session_(root_ + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces)),
      writer_(std::make_unique<LatestRunner>()) {
  timer_.setSingleShot(true);
  timer_.setInterval(kAfterMs);
  connect(&timer_, &QTimer::timeout, this, &Recovery::keep);
  caseChanged_ = bench_.document.changed.connect([this](Case::Part) {
    if (!timer_.isActive()) timer_.start();  // at most every kAfterMs, also under steady changes
  });
  connect(writer_.get(), &LatestRunner::failed, this, [this](const QString& why) {
    bench_.log.warn(tr("Changes are not kept for a crash: %1").arg(why));
  });
}

// Whoever gets here has not crashed.
Recovery::~Recovery() {
  forget();
  writer_.reset();  // waits
  QDir(session_).removeRecursively();
}

void Recovery::keep() {
  if (!bench_.document.modified()) return forget();
  if (!lock_) {
    if (!QDir().mkpath(session_)) return;
    // Held while this session runs; it goes with the process, however that ends.
    lock_ = std::make_unique<QLockFile>(session_ + "/lock");
    lock_->setStaleLockTime(0);
    if (!lock_->tryLock(0)) return;
  }
  auto copy = std::make_shared<Case>();
  copy->adopt(bench_.document);  // a copy would tell the document's listeners of what is taken out of it here
  copy->setCt(nullptr);          // large, and still where they were read from
  const bool ownLabels = bench_.document.labels() && !bench_.files.labelsAreAsRead();
  if (!ownLabels) copy->setLabels(nullptr);
  nlohmann::json state{{"name", bench_.document.name()},
                       {"time", QDateTime::currentDateTime().toString(Qt::ISODate).toStdString()}};
  const QString home = caseFolder ? caseFolder() : QString();
  if (!home.isEmpty()) state["case_folder"] = home.toStdString();
  for (const auto& [role, file] : bench_.files.sources())
    if (role == FileRole::Ct || !ownLabels)
      state[role == FileRole::Ct ? "ct" : "labels"] = std::filesystem::absolute(file).string();
  if (!home.isEmpty())
    for (const auto& [key, file, there] :
         {std::tuple{"ct", "/ct.nii.gz", bench_.document.ct() != nullptr},
          std::tuple{"labels", "/labels.nii.gz", bench_.document.labels() != nullptr && !ownLabels}})
      if (there && !state.contains(key) && QFile::exists(home + file))
        state[key] = (home + file).toStdString();
  const nlohmann::json view = bench_.files.viewToSave ? bench_.files.viewToSave() : nlohmann::json();
  writer_->submit(
      [copy, state, view, folder = std::filesystem::path(session_.toStdString())] {
        saveCase(*copy, folder / "case", Overwrite::Replace, view);
        writeJsonFile(folder / kStateFile, state,
                      Overwrite::Replace);  // last: it says that the rest is whole
        return 0;
      },
      [](int) {});
}

void Recovery::forget() {
  timer_.stop();
  writer_->drop();
  if (!lock_) return;
  lock_->unlock();
  lock_.reset();
  if (writer_->busy())  // after what is being written
    writer_->submit([session = session_] { return QDir(session).removeRecursively(); }, [](bool) {});
  else
    QDir(session_).removeRecursively();
}

QList<Recovery::Found> Recovery::left() const {
  QList<Found> all;
  for (const QFileInfo& entry : QDir(root_).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Time)) {
    const QString folder = entry.absoluteFilePath();
    if (folder == QFileInfo(session_).absoluteFilePath()) continue;
    QLockFile lock(folder + "/lock");
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // that session is running
    lock.unlock();
    if (!QFile::exists(folder + "/" + kStateFile) || !QFile::exists(folder + "/case/case.json")) {
      QDir(folder).removeRecursively();  // it ended before anything was whole
      continue;
    }
    QFile file(folder + "/" + kStateFile);
    if (!file.open(QIODevice::ReadOnly)) continue;
    const nlohmann::json state = nlohmann::json::parse(file.readAll().toStdString(), nullptr, false);
    if (!state.is_object()) continue;
    all << Found{folder,
                 textOf(state, "name"),
                 QString(textOf(state, "time")).replace('T', ' '),
                 textOf(state, "case_folder"),
                 textOf(state, "ct"),
                 textOf(state, "labels")};
  }
  return all;
}

void Recovery::remove(const Found& found) { QDir(found.folder).removeRecursively(); }

}  // namespace falciform
