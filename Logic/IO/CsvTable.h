#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace falciform {

/// One line of a table and where it stands in its file.
struct CsvRow {
  std::size_t line = 0;  ///< 1-based
  std::vector<std::string> cells;
};

/// Texts in rows and columns, as a spreadsheet writes them.
struct CsvTable {
  std::vector<CsvRow> rows;   ///< the first one is the head
  bool decimalComma = false;  ///< cells are parted by semicolons, so a comma is a decimal one

  /// The whole of a cell as a finite number; nothing if it is anything else.
  [[nodiscard]] std::optional<double> number(const std::string& cell) const;
};

/// Cells parted by commas, or by semicolons or tabs if the first line has such outside of quotes; blanks
/// around cells, empty lines, a byte order mark and lines that begin with # are passed over. Throws
/// InputError: no such file, no table in it, a quote that is not closed, a row that has not as many cells as
/// the head.
[[nodiscard]] CsvTable readCsvTable(const std::filesystem::path& file);

/// A cell as it is written: in quotes if it must be.
[[nodiscard]] std::string csvCell(const std::string& text);

}  // namespace falciform
