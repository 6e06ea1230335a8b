#pragma once
#include <filesystem>
#include <functional>
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

 private:
  template <class Work, class Done>
  bool start(const QString& title, Work work, Done done);

  Case& case_;
  JobRunner& runner_;
  Log& log_;
};

}  // namespace falciform
