#pragma once
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "Modules/CommandLine/TrialOutcome.h"

namespace falciform::commandline {

/// The trials that a run has done so far, in `trials.partial.csv` of its result folder, so that one that is
/// stopped can go on where it stood: the one file that a command leaves behind when it is cancelled. Its
/// first line holds what the trials rest on: inputs, settings, gold standard.
class KeptTrials {
 public:
  /// `basis`: an object; a run may go on only if every entry is the same.
  KeptTrials(std::filesystem::path folder, nlohmann::json basis, std::vector<TrialMethod> methods);

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Those of an earlier run with the same basis, trials below `count` only. One with another basis is
  /// forgotten if `anew`; else throws InputError that says what differs. Unfinished lines are dropped.
  [[nodiscard]] std::vector<TrialRecord> earlier(int count, bool anew);
  /// Writes one more to disk. Throws InputError if that cannot be done.
  void keep(const TrialRecord& record);
  /// How many stand in the file.
  [[nodiscard]] std::size_t size() const { return rows_; }

 private:
  [[nodiscard]] std::string head() const;

  std::filesystem::path file_;
  nlohmann::json basis_;
  std::vector<TrialMethod> methods_;
  std::ofstream stream_;
  std::size_t rows_ = 0;
};

}  // namespace falciform::commandline
