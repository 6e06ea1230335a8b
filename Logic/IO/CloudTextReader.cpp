#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/RangeGrid.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceParts.h"

// XYZ and CSV: one point a line; numbers parted by blanks, commas or semicolons; a first line may name the
// columns. A raster is told by columns named row and column, or by a comment "# raster ROWS COLUMNS" above
// ROWS x COLUMNS lines, line by line from the upper left as the scanner sees it; missing samples are nan.

namespace falciform {

namespace {

std::string lower(std::string_view word) {
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

struct Table {
  std::vector<std::string> names;  ///< as in the header line; empty without one
  std::size_t columns = 0;
  std::vector<double> values;             ///< row by row
  int rasterRows = 0, rasterColumns = 0;  ///< as a comment says; 0: it does not
};

class TableReader {
 public:
  explicit TableReader(const std::string& name) : name_(name) {}

  Table read(const std::string& text, std::optional<std::string>& space) {
    TextCursor cursor(text);
    for (std::string_view line; cursor.nextLine(line);) {
      if (cursor.line() == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);  // byte order mark
      const std::size_t begin = line.find_first_not_of(" \t");
      if (begin == std::string_view::npos) continue;
      line_ = cursor.line();
      if (line[begin] == '#' || line.substr(begin, 2) == "//") {
        if (const auto tag = spaceTagIn(line); tag && !space) space = tag;
        readRasterComment(line.substr(begin + 1));
        continue;
      }
      readRow(line);
    }
    return std::move(table_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(name_ + ", line " + std::to_string(line_) + ": " + why);
  }

  void readRasterComment(std::string_view comment) {
    int rows = 0, columns = 0;
    if (nextWord(comment) == "raster" && parseNumber(nextWord(comment), rows) &&
        parseNumber(nextWord(comment), columns) && rows > 0 && columns > 0) {
      table_.rasterRows = rows;
      table_.rasterColumns = columns;
    }
  }

  void readRow(std::string_view line) {
    std::string copy;
    // "1,5;2,5": with semicolons between the columns a comma is a decimal one.
    if (line.find(';') != std::string_view::npos) {
      copy = line;
      std::replace(copy.begin(), copy.end(), ',', '.');
      line = copy;
    }
    std::size_t count = 0;
    for (std::string_view word = nextWord(line, kSeparators); !word.empty();
         word = nextWord(line, kSeparators), ++count) {
      if (word.size() >= 2 && word.front() == '"' && word.back() == '"')
        word = word.substr(1, word.size() - 2);
      double value = 0;
      if (parseNumber(word, value)) {
        if (!table_.names.empty() && table_.values.empty()) {
          if (count > 0) refuse("it mixes names of columns and numbers; give the names a line of their own");
          checkHeader();
        }
        table_.values.push_back(value);
      } else if (table_.values.empty()) {
        table_.names.emplace_back(word);
      } else {
        refuse("'" + std::string(word.substr(0, 20)) +
               "' is no number; give x, y, z as numbers in each line");
      }
    }
    if (table_.values.empty()) return;  // that was the header line
    if (table_.columns == 0) table_.columns = count;
    if (count != table_.columns)
      refuse("it has " + std::to_string(count) + " columns where the lines above have " +
             std::to_string(table_.columns) + "; give each point as many");
  }

  void checkHeader() {
    table_.columns = table_.names.size();
    if (lower(table_.names[0]) == "x" || table_.names.size() >= 3) return;
    refuse("the first line is neither numbers nor column names; begin with 'x,y,z'");
  }

  static constexpr std::string_view kSeparators = " \t,;\r\v\f";
  const std::string& name_;
  std::size_t line_ = 0;
  Table table_;
};

using Columns = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

void useNames(const Table& table, const Columns& columns, const std::string& name, Surface& surface) {
  const auto place = [&](std::initializer_list<const char*> names) -> Index {
    for (std::size_t k = 0; k < table.names.size(); ++k)
      for (const char* candidate : names)
        if (lower(table.names[k]) == candidate) return static_cast<Index>(k);
    return -1;
  };
  std::vector<Index> used;
  const auto take = [&](Index a, Index b, Index c, Points& rows) {
    if (a < 0 || b < 0 || c < 0) return false;
    rows.resize(columns.rows(), 3);
    rows << columns.col(a), columns.col(b), columns.col(c);
    used.insert(used.end(), {a, b, c});
    return true;
  };
  if (!take(place({"x"}), place({"y"}), place({"z"}), surface.points))
    throw InputError(name + ": its first line names no columns x, y and z; name them so");
  Points rows;
  if (take(place({"nx"}), place({"ny"}), place({"nz"}), rows)) surface.normals = unitNormalsFrom(rows);
  if (take(place({"red", "r"}), place({"green", "g"}), place({"blue", "b"}), rows))
    surface.colours = coloursFrom(rows);
  if (const Index labels = place({"patch"}); labels >= 0) {
    surface.patch = patchLabelsFrom(columns.col(labels), name);
    used.push_back(labels);
  }
  for (Index k = 0; k < columns.cols(); ++k)
    if (std::find(used.begin(), used.end(), k) == used.end())
      surface.arrays[table.names[static_cast<std::size_t>(k)]] = columns.col(k);
}

/// Without names, six columns are colours if all are whole numbers in 0..255, and normals if all have
/// length 1.
void guessColumns(const Columns& columns, const std::string& name, RawSurface& raw) {
  raw.surface.points = columns.leftCols<3>();
  if (columns.cols() == 3) return;
  if (columns.cols() == 6) {
    const Points rest = columns.rightCols<3>();
    if ((rest.rowwise().norm().array() - 1).abs().maxCoeff() < 0.01) {  // written with two or more digits
      raw.surface.normals = unitNormalsFrom(rest);
      return;
    }
    if ((rest.array() == rest.array().floor()).all() && rest.minCoeff() >= 0 && rest.maxCoeff() <= 255) {
      raw.surface.colours = coloursFrom(rest);
      return;
    }
  }
  raw.warnings.push_back(
      name + ": columns 4 to " + std::to_string(columns.cols()) +
      " have no names and were ignored; name them in a first line, such as x,y,z,nx,ny,nz");
}

/// Of the columns named row and column, and takes these out of the arrays; empty without them.
RangeGrid namedGrid(Surface& surface, const std::string& name) {
  constexpr double kCellsAPoint = 50;  // emptier than this it is no raster
  RangeGrid grid;
  const auto named = [&](std::initializer_list<const char*> names) {
    return std::find_if(surface.arrays.begin(), surface.arrays.end(), [&](const auto& array) {
      return std::find(names.begin(), names.end(), lower(array.first)) != names.end();
    });
  };
  const auto rows = named({"row", "line"}), columns = named({"column", "col", "sample"});
  if (rows == surface.arrays.end() || columns == surface.arrays.end()) return grid;
  const VectorXd row = rows->second, column = columns->second;
  const auto whole = [](const VectorXd& values) {
    return values.allFinite() && values.minCoeff() >= 0 && (values.array() == values.array().floor()).all();
  };
  if (!whole(row) || !whole(column)) return grid;
  const double cells = (row.maxCoeff() + 1) * (column.maxCoeff() + 1);
  if (cells > kCellsAPoint * static_cast<double>(row.size()))
    throw InputError(name + ": its rows and columns span " + numberText(cells) + " samples for " +
                     std::to_string(row.size()) + " points; number them from 0 without gaps");
  grid.rows = static_cast<int>(row.maxCoeff()) + 1;
  grid.columns = static_cast<int>(column.maxCoeff()) + 1;
  grid.point.assign(static_cast<std::size_t>(cells), -1);
  for (Index i = 0; i < row.size(); ++i)
    grid.point[static_cast<std::size_t>(row[i] * grid.columns + column[i])] = static_cast<int>(i);
  surface.arrays.erase(rows);
  surface.arrays.erase(columns);
  return grid;
}

RangeGrid announcedGrid(const Table& table, Index points, const std::string& name) {
  RangeGrid grid{table.rasterRows, table.rasterColumns, {}};
  if (static_cast<double>(grid.rows) * grid.columns != static_cast<double>(points))
    throw InputError(name + ": it announces a raster of " + std::to_string(grid.rows) + " x " +
                     std::to_string(grid.columns) + " samples, but holds " + std::to_string(points) +
                     " lines; write 'nan nan nan' for each missing sample");
  grid.point.resize(static_cast<std::size_t>(points));
  std::iota(grid.point.begin(), grid.point.end(), 0);
  return grid;
}

}  // namespace

RawSurface readCloudText(const std::string& text, const std::string& name) {
  if (text.find('\0') != std::string::npos)
    throw InputError(name + " is no text; give a file with one point a line");
  RawSurface raw;
  const Table table = TableReader(name).read(text, raw.space);
  if (table.values.empty()) return raw;
  if (table.columns < 3)
    throw InputError(name + ": its lines have " + std::to_string(table.columns) +
                     " columns; give x, y and z");
  const Columns columns(table.values.data(), static_cast<Index>(table.values.size() / table.columns),
                        static_cast<Index>(table.columns));
  if (table.names.empty())
    guessColumns(columns, name, raw);
  else
    useNames(table, columns, name, raw.surface);
  RangeGrid grid =
      table.rasterRows > 0 ? announcedGrid(table, raw.surface.size(), name) : namedGrid(raw.surface, name);
  if (grid.rows > 0) {
    (void)dropMissing(raw.surface, grid);
    if (raw.surface.size() > 0) joinRaster(raw.surface, grid, std::nullopt);
  }
  return raw;
}

}  // namespace falciform
