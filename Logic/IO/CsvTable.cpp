#include "Logic/IO/CsvTable.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

namespace {

/// Calls `visit(character, quoted)` for what a line holds, quotes themselves resolved; false if one is not
/// closed.
template <class Visit>
bool walk(std::string_view line, const Visit& visit) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '"')
      visit(line[i], quoted);
    else if (quoted && i + 1 < line.size() && line[i + 1] == '"')
      visit(line[++i], true);
    else
      quoted = !quoted;
  }
  return !quoted;
}

char separatorOf(std::string_view head) {
  char found = ',';
  walk(head, [&](char c, bool quoted) {
    if (!quoted && (c == ';' || c == '\t') && found == ',') found = c;
  });
  return found;
}

std::optional<std::vector<std::string>> cellsOf(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  const bool closed = walk(line, [&](char c, bool quoted) {
    if (c == separator && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  });
  if (!closed) return {};
  for (std::string& cell : cells) cell = trimmed(cell);
  return cells;
}

}  // namespace

std::optional<double> CsvTable::number(const std::string& cell) const {
  std::string text = cell;
  if (decimalComma) std::replace(text.begin(), text.end(), ',', '.');
  const std::optional<double> value = toNumber(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

CsvTable readCsvTable(const std::filesystem::path& file) {
  const std::string text = readTextFile(file), name = "'" + file.string() + "'";
  CsvTable table;
  char separator = ',';
  TextCursor cursor(text);
  for (std::string_view line; cursor.nextLine(line);) {
    if (cursor.line() == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // byte order mark
    if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
    if (table.rows.empty()) separator = separatorOf(line);
    std::optional<std::vector<std::string>> cells = cellsOf(line, separator);
    const std::string where = name + ", line " + std::to_string(cursor.line());
    if (!cells) throw InputError(where + ": a quote is not closed; close it");
    if (!table.rows.empty() && cells->size() != table.rows.front().cells.size())
      throw InputError(where + ": has " + std::to_string(cells->size()) + " cells where the head has " +
                       std::to_string(table.rows.front().cells.size()) +
                       "; give as many, empty ones where there is no value");
    table.rows.push_back({cursor.line(), std::move(*cells)});
  }
  if (table.rows.empty()) throw InputError(name + " holds no table; give a head and a line a row");
  table.decimalComma = separator == ';';
  return table;
}

std::string csvCell(const std::string& text) {
  // A leading # would make the line a remark.
  if (text.find_first_of(",;\t\"\r\n") == std::string::npos && !text.starts_with('#')) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace falciform
