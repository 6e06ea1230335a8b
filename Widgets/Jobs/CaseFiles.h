#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/Core/Case.h"
#include "Logic/IO/DicomSeries.h"
#include "Widgets/Jobs/FileGuess.h"
#include "Widgets/Jobs/JobRunner.h"
#include "Widgets/Jobs/Log.h"

namespace falciform {

/// Reading files into the case and saving it, as jobs: the window never waits for a disk. What readers warn
/// of goes to the log. Each returns false, and logs why, while another job runs.
class CaseFiles {
 public:
  CaseFiles(Case& document, JobRunner& runner, Log& log) : case_(document), runner_(runner), log_(log) {}

  /// Reads `file` as `role` and puts it in its place; `done` then runs. A case replaces all that was there.
  bool open(const std::filesystem::path& file, FileRole role, std::function<void()> done = {});
  /// One DICOM series as CT, or one and several masks as label map.
  bool openSeries(std::vector<DicomSeries> series, FileRole role, std::function<void()> done = {});
  /// Writes the whole case as it is now into `folder`, replacing what an earlier save left there.
  bool save(const std::filesystem::path& folder, std::function<void()> done = {});

  /// How the window shows the case, to be saved with it, and back when a case is opened that has it.
  std::function<nlohmann::json()> viewToSave;
  std::function<void(const nlohmann::json&)> viewOpened;
  /// The files that label map and CT were read from, since the case was opened.
  [[nodiscard]] const std::map<FileRole, std::filesystem::path>& sources() const { return sources_; }
  /// False once the labels are no longer those of a file or series that was opened.
  [[nodiscard]] bool labelsAreAsRead() const { return labelsRead_.lock() == case_.labels(); }
  /// Names that the file of the label map last opened gives to its labels.
  [[nodiscard]] const std::map<int, std::string>& labelNames() const { return labelNames_; }

 private:
  template <class Work, class Done>
  bool start(const QString& title, Work work, Done done);

  Case& case_;
  JobRunner& runner_;
  Log& log_;
  std::map<FileRole, std::filesystem::path> sources_;
  std::map<int, std::string> labelNames_;
  std::weak_ptr<const LabelMap> labelsRead_;
};

}  // namespace falciform
