#include "Logic/IO/TrackedPointFiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "Logic/Core/Errors.h"
#include "Logic/IO/CsvTable.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/SpaceAndUnits.h"
#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

namespace {

constexpr double kPauseS = 1;            // a tip that is lifted and set down again takes longer
constexpr double kUnitLengthOff = 0.01;  // trackers write four digits of a quaternion

/// A column and what its numbers are to be multiplied by.
struct Column {
  int at = -1;
  double factor = 1;
};

/// The columns of one table by their meaning; -1 where there is none.
class Columns {
 public:
  Columns(const CsvTable& table, std::string name) : table_(table), name_(std::move(name)) {
    for (const std::string& cell : table.rows.front().cells) heads_.push_back(lowerCase(cell));
  }

  [[nodiscard]] int find(std::initializer_list<const char*> names) const {
    for (const char* wanted : names) {
      const auto at = std::find(heads_.begin(), heads_.end(), wanted);
      if (at != heads_.end()) return static_cast<int>(at - heads_.begin());
    }
    return -1;
  }

  /// x, y, z in one unit; nothing if one of them is missing.
  [[nodiscard]] std::optional<std::array<Column, 3>> place() const {
    for (const char* prefix : {"", "t"})
      for (const auto& [unit, factor] :
           {std::pair("", 1.0), std::pair("_mm", 1.0), std::pair("_cm", 10.0), std::pair("_m", 1000.0)}) {
        std::array<Column, 3> columns;
        for (int axis = 0; axis < 3; ++axis) {
          const std::string head = std::string(prefix) + "xyz"[axis] + unit;
          columns[static_cast<std::size_t>(axis)] = {find({head.c_str()}), factor};
        }
        if (std::all_of(columns.begin(), columns.end(), [](const Column& c) { return c.at >= 0; }))
          return columns;
      }
    return {};
  }

  [[nodiscard]] const std::string& cell(const CsvRow& row, int column) const {
    return row.cells[static_cast<std::size_t>(column)];
  }
  [[nodiscard]] double number(const CsvRow& row, int column) const {
    const auto value = table_.number(cell(row, column));
    if (!value)
      throw InputError(name_ + ", line " + std::to_string(row.line) + ": '" +
                       cell(row, column).substr(0, 20) + "' in column '" +
                       heads_[static_cast<std::size_t>(column)] + "' is no number; give one");
    return *value;
  }

 private:
  const CsvTable& table_;
  std::string name_;
  std::vector<std::string> heads_;
};

bool isGood(const std::string& state) {
  const std::string word = lowerCase(state);
  return word == "ok" || word == "good" || word == "enabled" || word == "visible" || word == "true" ||
         word == "1" || word == "1.0";
}

/// Three columns of numbers need no names: the table gets them.
void nameColumns(CsvTable& table) {
  const CsvRow& first = table.rows.front();
  if (first.cells.size() != 3) return;
  if (!std::all_of(first.cells.begin(), first.cells.end(),
                   [&](const std::string& cell) { return table.number(cell).has_value(); }))
    return;
  table.rows.insert(table.rows.begin(), CsvRow{0, {"x", "y", "z"}});
}

/// The first space tag among the remarks.
std::optional<std::string> spaceOf(const std::filesystem::path& file) {
  const std::string text = readTextFile(file);
  TextCursor cursor(text);
  for (std::string_view line; cursor.nextLine(line);)
    if (trimmed(line).starts_with('#'))
      if (const auto tag = spaceTagIn(line)) return tag;
  return {};
}

Vector3d tipOf(const Vector3d& origin, const Eigen::Quaterniond& turn, const Vector3d& tipInTool,
               const std::string& where) {
  if (!(std::abs(turn.norm() - 1) < kUnitLengthOff))
    throw InputError(where + ": the quaternion has length " + std::to_string(turn.norm()) +
                     ", not 1; give a rotation in each line, or mark the sample as bad");
  return origin + turn.normalized() * tipInTool;
}

}  // namespace

Loaded<TrackedPoints> readTrackedPoints(const std::filesystem::path& file,
                                        const std::optional<Vector3d>& tipInTool) {
  const std::string name = "'" + file.string() + "'";
  CsvTable table = readCsvTable(file);
  nameColumns(table);
  const Columns columns(table, name);
  const auto place = columns.place();
  if (!place) throw InputError(name + " names no columns x, y, z or tx, ty, tz; name them in the first line");
  const std::array<int, 4> turn{columns.find({"q0", "qw"}), columns.find({"qx"}), columns.find({"qy"}),
                                columns.find({"qz"})};
  if (tipInTool && *std::min_element(turn.begin(), turn.end()) < 0)
    throw InputError(name + " names no columns q0, qx, qy, qz; without them a tip offset cannot be applied");
  const int stroke = columns.find({"stroke", "swab", "segment"}),
            state = columns.find({"state", "status", "visible", "valid"}),
            milliseconds = columns.find({"time_ms"}),
            time = milliseconds >= 0 ? milliseconds : columns.find({"time_s", "time", "seconds", "t"});

  Loaded<TrackedPoints> read;
  TrackedPoints& tracked = read.value;
  std::vector<Vector3d> places;
  std::vector<double> seconds;
  std::string lastStroke;
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    const CsvRow& row = table.rows[r];
    const bool empty = std::any_of(place->begin(), place->end(),
                                   [&](const Column& c) { return columns.cell(row, c.at).empty(); });
    if (empty || (state >= 0 && !isGood(columns.cell(row, state)))) {
      ++tracked.lost;
      continue;
    }
    const std::string where = name + ", line " + std::to_string(row.line);
    Vector3d at;
    for (int axis = 0; axis < 3; ++axis) {
      const Column& column = (*place)[static_cast<std::size_t>(axis)];
      at[axis] = column.factor * columns.number(row, column.at);
    }
    if (tipInTool)
      at = tipOf(at,
                 {columns.number(row, turn[0]), columns.number(row, turn[1]), columns.number(row, turn[2]),
                  columns.number(row, turn[3])},
                 *tipInTool, where);
    bool begins = places.empty();
    if (time >= 0) {
      const double now = columns.number(row, time) * (milliseconds >= 0 ? 1e-3 : 1);
      if (!seconds.empty() && now < seconds.back())
        throw InputError(where + ": the time runs backwards; sort the samples by time");
      begins = begins || now - seconds.back() > kPauseS;
      seconds.push_back(now);
    }
    const std::string label = stroke >= 0 ? columns.cell(row, stroke) : std::string();
    begins = begins || label != lastStroke;
    lastStroke = label;
    if (begins)
      tracked.strokes.push_back(label.empty() ? "stroke " + std::to_string(tracked.strokes.size() + 1)
                                              : label);
    tracked.stroke.push_back(static_cast<int>(tracked.strokes.size()) - 1);
    places.push_back(at);
  }
  if (places.empty())
    throw InputError(name + " holds no usable sample (" + std::to_string(tracked.lost) +
                     " marked as lost or bad); record again with the tool in view");
  tracked.points.resize(static_cast<Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
    tracked.points.row(static_cast<Index>(i)) = places[i].transpose();
  tracked.seconds = Eigen::Map<const VectorXd>(seconds.data(), static_cast<Index>(seconds.size()));
  if (const auto space = spaceOf(file))
    honourSpace(tracked.points, tracked.frame, space, name, read.warnings);
  checkUnits(tracked.points, name, read.warnings);
  if (tracked.lost > 0)
    read.warnings.push_back(name + ": " + std::to_string(tracked.lost) +
                            " samples are lost or marked as bad; left out");
  return read;
}

}  // namespace falciform
