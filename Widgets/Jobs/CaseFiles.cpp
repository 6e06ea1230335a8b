#include "Widgets/Jobs/CaseFiles.h"

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"

namespace falciform {
namespace {

namespace fs = std::filesystem;

QString shortName(const fs::path& file) {
  return QString::fromStdString((file.has_filename() ? file : file.parent_path()).filename().string());
}

struct LoadedCase {
  std::shared_ptr<Case> document;
  std::vector<std::string> warnings;
  nlohmann::json view;  ///< null if none was saved
};

/// How the window showed the case; null if that was not saved, or is damaged: no reason not to open the case.
nlohmann::json readView(const fs::path& folderOrFile) {
  const CaseDescription description = readCaseDescription(folderOrFile);
  const fs::path file = description.folder / description.view;
  if (description.view.empty() || !fs::exists(file)) return nullptr;
  const std::string text = readTextFile(file);
  nlohmann::json view = nlohmann::json::parse(text, nullptr, false);
  return view.is_discarded() ? nlohmann::json() : view;
}

bool sameParts(const Case& a, const Case& b) {
  return a.preop() == b.preop() && a.scan() == b.scan() && a.registration() == b.registration() &&
         a.distance() == b.distance() && a.labels() == b.labels() && a.name() == b.name() &&
         a.structures() == b.structures() && a.ct() == b.ct() && a.supports() == b.supports() &&
         a.update() == b.update();
}

}  // namespace

template <class Work, class Done>
bool CaseFiles::start(const QString& title, Work work, Done done) {
  const bool started = runner_.start(title, std::move(work), std::move(done));
  if (!started)
    log_.warn(QObject::tr("%1 has to wait: \"%2\" is still running.").arg(title, runner_.title()));
  return started;
}

bool CaseFiles::open(const fs::path& file, FileRole role, std::function<void()> done) {
  const QString title = QObject::tr("Opening %1").arg(shortName(file));
  const auto finish = [this, file, role, done](const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) log_.warn(QString::fromStdString(warning));
    const std::string_view what = fileRoleName(role);
    log_.info(QObject::tr("Opened %1 as %2.")
                  .arg(shortName(file), QString::fromUtf8(what.data(), int(what.size()))));
    if (done) done();
  };
  switch (role) {
    case FileRole::Case:
      return start(
          title,
          [file](const Progress& progress) {
            progress.report(0, "reading the case");
            LoadedCase loaded{std::make_shared<Case>(), {}, {}};
            loaded.warnings = openCase(*loaded.document, file);
            loaded.view = readView(file);
            progress.report(1);
            return loaded;
          },
          [this, finish](const LoadedCase& loaded) {
            labelNames_.clear();
            case_.adopt(*loaded.document);
            sources_.clear();
            labelsRead_ = case_.labels();
            if (viewOpened && loaded.view.is_object()) viewOpened(loaded.view);
            finish(loaded.warnings);
          });
    case FileRole::Labels:
      return start(
          title,
          [file](const Progress& progress) {
            progress.report(0, "reading the label map");
            return readNamedLabels(file, {}, progress);
          },
          [this, role, file, finish](Loaded<NamedLabels> loaded) {
            labelNames_ = std::move(loaded.value.names);
            case_.setLabels(std::make_shared<const LabelMap>(std::move(loaded.value.map)));
            sources_[role] = file;
            labelsRead_ = case_.labels();
            finish(loaded.warnings);
          });
    case FileRole::Preop:
    case FileRole::Scan:
    case FileRole::Structure:
      return start(
          title,
          [file](const Progress& progress) {
            progress.report(0, "reading the surface");
            return readSurface(file);
          },
          [this, role, file, finish](Loaded<Surface> loaded) {
            auto surface = std::make_shared<const Surface>(std::move(loaded.value));
            if (role == FileRole::Preop)
              case_.setPreop(std::move(surface));
            else if (role == FileRole::Scan)
              case_.setScan(std::move(surface));
            else
              case_.setStructure(file.stem().string(), std::move(surface));
            finish(loaded.warnings);
          });
    case FileRole::Ct:
      return start(
          title,
          [file](const Progress& progress) {
            progress.report(0, "reading the CT");
            return readImage(file);
          },
          [this, role, file, finish](Loaded<Image> loaded) {
            case_.setCt(std::make_shared<const Image>(std::move(loaded.value)));
            sources_[role] = file;
            finish(loaded.warnings);
          });
    case FileRole::PreopLandmarks:
    case FileRole::ScanLandmarks:
    case FileRole::Targets:
    case FileRole::TruthTargets:
      return start(
          title,
          [file](const Progress& progress) {
            progress.report(0, "reading the landmarks");
            return readLandmarks(file);
          },
          [this, role, finish](Loaded<Landmarks> loaded) {
            if (role == FileRole::PreopLandmarks)
              case_.setPreopLandmarks(std::move(loaded.value));
            else if (role == FileRole::ScanLandmarks)
              case_.setScanLandmarks(std::move(loaded.value));
            else if (role == FileRole::Targets)
              case_.setTargets(std::move(loaded.value));
            else
              case_.setTruthTargets(std::move(loaded.value));
            finish(loaded.warnings);
          });
  }
  return false;
}

bool CaseFiles::openSeries(std::vector<DicomSeries> series, FileRole role, std::function<void()> done) {
  const QString title = QObject::tr("Opening DICOM");
  const auto finish = [this, role, done](const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) log_.warn(QString::fromStdString(warning));
    const std::string_view what = fileRoleName(role);
    log_.info(QObject::tr("Opened DICOM as %1.").arg(QString::fromUtf8(what.data(), int(what.size()))));
    if (done) done();
  };
  if (role == FileRole::Ct)
    return start(
        title, [series](const Progress& progress) { return readDicomImage(series.at(0), progress); },
        [this, finish](Loaded<Image> loaded) {
          case_.setCt(std::make_shared<const Image>(std::move(loaded.value)));
          finish(loaded.warnings);
        });
  return start(
      title,
      [series](const Progress& progress) {
        DicomListing chosen;
        chosen.series = series;
        return series.size() > 1 ? readDicomMasks(series, progress) : readChosenLabels(chosen, {}, progress);
      },
      [this, finish](Loaded<NamedLabels> loaded) {
        for (const auto& [label, name] : loaded.value.names)
          log_.info(QObject::tr("Label %1 is '%2'.").arg(label).arg(QString::fromStdString(name)));
        labelNames_ = std::move(loaded.value.names);
        case_.setLabels(std::make_shared<const LabelMap>(std::move(loaded.value.map)));
        labelsRead_ = case_.labels();
        finish(loaded.warnings);
      });
}

bool CaseFiles::save(const fs::path& folder, std::function<void()> done) {
  // The parts are shared and constant, so this copy is a snapshot that the worker may read.
  auto snapshot = std::make_shared<const Case>(case_);
  return start(
      QObject::tr("Saving %1").arg(shortName(folder)),
      [snapshot, folder, view = viewToSave ? viewToSave() : nlohmann::json()](const Progress& progress) {
        progress.report(0, "writing the case");
        saveCase(*snapshot, folder, Overwrite::Replace, view);
      },
      [this, folder, snapshot, done] {
        // What was changed while the worker wrote is not saved yet.
        if (sameParts(case_, *snapshot)) case_.setUnmodified();
        log_.info(QObject::tr("Saved the case in %1.").arg(shortName(folder)));
        if (done) done();
      });
}

}  // namespace falciform
