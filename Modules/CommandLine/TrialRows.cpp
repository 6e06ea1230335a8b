#include "Modules/CommandLine/TrialRows.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

namespace {

constexpr std::size_t kKeptCells = 26;

std::string cell(double value) { return std::isfinite(value) ? numberText(value) : ""; }

/// A text that needs no quotes.
std::string plain(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '"' || c == '\n' || c == '\r') c = c == ',' ? ';' : ' ';
  return text;
}

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : ",") + cells[i];
  return line + "\n";
}

/// Shortest text that reads back as exactly this value, NaN and -0 too.
std::string exactly(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Reads the cells of a row one after the other and remembers whether all were what they should be.
class RowReader {
 public:
  explicit RowReader(const std::string& row) {
    for (std::size_t from = 0;;) {
      const std::size_t to = std::min(row.find(',', from), row.size());
      cells_.push_back(row.substr(from, to - from));
      if (to == row.size()) break;
      from = to + 1;
    }
    good_ = cells_.size() == kKeptCells;
  }
  std::string text() { return at_ < cells_.size() ? cells_[at_++] : ""; }
  template <class Number>
  void read(Number& value) {
    const std::string word = text();
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    good_ = good_ && error == std::errc() && end == word.data() + word.size();
  }
  void read(bool& value) {
    int number = 0;
    read(number);
    value = number != 0;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  std::vector<std::string> cells_;
  std::size_t at_ = 0;
  bool good_ = false;
};

}  // namespace

std::string trialsCsv(const TrialOutcome& outcome) {
  std::string csv =
      "method,trial,start_rotation_deg,start_translation_mm,success,target_error_mm,rms_mm,gold_distance_mm,"
      "gold_rotation_deg,basin,poses_found,warnings,iterations,converged,stop_reason,time_s,"
      "time_per_iteration_s\n";
  for (std::size_t i = 0; i < outcome.records.size(); ++i) {
    const TrialRecord& r = outcome.records[i];
    const double turn = Eigen::AngleAxisd(r.error.linear()).angle() * 180 / EIGEN_PI;
    csv += joined({outcome.methods[static_cast<std::size_t>(r.method)].name, std::to_string(r.trial + 1),
                   cell(r.startRotationDeg), cell(r.startTranslationMm), r.success ? "1" : "0",
                   cell(r.targetErrorMm), cell(r.rmsMm), cell(r.goldDistanceMm), cell(turn),
                   std::to_string(outcome.basins[i]), std::to_string(r.posesFound),
                   std::to_string(r.warnings), std::to_string(r.iterations), r.converged ? "1" : "0",
                   plain(r.stopReason), cell(r.seconds), cell(r.seconds / std::max(1, r.iterations))});
  }
  return csv;
}

std::string keptRowsHead() {
  return "method,trial,start_rotation_deg,start_translation_mm,success,target_error_mm,rms_mm,"
         "gold_distance_mm,warnings,poses_found,iterations,converged,stop_reason,time_s,r00,r01,r02,x_mm,r10,"
         "r11,r12,y_mm,r20,r21,r22,z_mm\n";
}

std::string keptRow(const TrialRecord& r, const std::vector<TrialMethod>& methods) {
  std::vector<std::string> cells{methods[static_cast<std::size_t>(r.method)].name,
                                 std::to_string(r.trial),
                                 exactly(r.startRotationDeg),
                                 exactly(r.startTranslationMm),
                                 r.success ? "1" : "0",
                                 exactly(r.targetErrorMm),
                                 exactly(r.rmsMm),
                                 exactly(r.goldDistanceMm),
                                 std::to_string(r.warnings),
                                 std::to_string(r.posesFound),
                                 std::to_string(r.iterations),
                                 r.converged ? "1" : "0",
                                 plain(r.stopReason),
                                 exactly(r.seconds)};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) cells.push_back(exactly(r.error.matrix()(row, column)));
  return joined(cells);
}

std::optional<TrialRecord> recordOfKeptRow(const std::string& row, const std::vector<TrialMethod>& methods) {
  RowReader cells(row);
  TrialRecord r;
  const std::string name = cells.text();
  const auto method =
      std::find_if(methods.begin(), methods.end(), [&](const TrialMethod& m) { return m.name == name; });
  if (method == methods.end()) return std::nullopt;
  r.method = static_cast<int>(method - methods.begin());
  cells.read(r.trial);
  for (double* value : {&r.startRotationDeg, &r.startTranslationMm}) cells.read(*value);
  cells.read(r.success);
  for (double* value : {&r.targetErrorMm, &r.rmsMm, &r.goldDistanceMm}) cells.read(*value);
  for (int* value : {&r.warnings, &r.posesFound, &r.iterations}) cells.read(*value);
  cells.read(r.converged);
  r.stopReason = cells.text();
  cells.read(r.seconds);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) cells.read(r.error.matrix()(i, j));
  if (!cells.good() || r.trial < 0) return std::nullopt;
  return r;
}

}  // namespace falciform::commandline
