#include "Modules/CommandLine/KeptTrials.h"

#include <sstream>

#include "Logic/Core/Errors.h"
#include "Logic/IO/OutputFile.h"
#include "Modules/CommandLine/TrialRows.h"

namespace falciform::commandline {

namespace {

constexpr char kMark[] = "# falciform trials, unfinished: ";

/// The entry in which the two differ, or empty.
std::string difference(const nlohmann::json& now, const nlohmann::json& then) {
  if (!then.is_object()) return "format";
  for (const auto& [key, value] : now.items())
    if (!then.contains(key) || then.at(key) != value) return key;
  return now.size() == then.size() ? "" : "format";
}

}  // namespace

KeptTrials::KeptTrials(std::filesystem::path folder, nlohmann::json basis, std::vector<TrialMethod> methods)
    : file_(std::move(folder) / "trials.partial.csv"),
      basis_(std::move(basis)),
      methods_(std::move(methods)) {}

std::string KeptTrials::head() const { return kMark + basis_.dump() + "\n" + keptRowsHead(); }

std::vector<TrialRecord> KeptTrials::earlier(int count, bool anew) {
  std::vector<TrialRecord> records;
  if (!std::filesystem::exists(file_)) return records;
  std::string text = readTextFile(file_);
  text.resize(text.rfind('\n') + 1);  // a run that was killed may have left half a line; npos + 1 is 0
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const nlohmann::json then = line.starts_with(kMark)
                                  ? nlohmann::json::parse(line.substr(sizeof kMark - 1), nullptr, false)
                                  : nlohmann::json();
  if (const std::string differs = difference(basis_, then); !differs.empty()) {
    if (anew) return records;
    throw InputError("'" + file_.string() + "' is of an interrupted run with another " + differs +
                     "; repeat that command, choose another --out or begin anew with --force");
  }
  std::string kept = head();
  std::getline(lines, line);
  while (std::getline(lines, line))
    if (const auto record = recordOfKeptRow(line, methods_)) {
      kept += line + "\n";
      ++rows_;
      if (record->trial < count) records.push_back(*record);
    }
  writeTextFile(file_, Overwrite::Replace, kept);
  return records;
}

void KeptTrials::keep(const TrialRecord& record) {
  if (!stream_.is_open()) {
    // The file appears with its first row: a run that fails before leaves nothing.
    if (rows_ == 0) writeTextFile(file_, Overwrite::Replace, head());
    stream_.open(file_, std::ios::binary | std::ios::app);
  }
  stream_ << keptRow(record, methods_) << std::flush;
  if (!stream_) throw InputError("cannot write '" + file_.string() + "'; is the disk full?");
  ++rows_;
}

}  // namespace falciform::commandline
