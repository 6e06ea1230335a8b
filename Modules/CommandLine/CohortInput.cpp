#include "Modules/CommandLine/CohortInput.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Logic/Core/Errors.h"
#include "Logic/Deformation/Cohort/MapCorrelation.h"
#include "Logic/IO/CsvTable.h"

namespace falciform::commandline {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Keeps the file's name and table for words about it.
struct Source {
  std::string name;
  CsvTable table;

  Source(const std::filesystem::path& file, CommandRun& run)
      : name("'" + file.string() + "'"), table(readCsvTable(file)) {
    run.remember(file);
  }
  [[nodiscard]] std::string at(const CsvRow& row) const {
    return name + ", line " + std::to_string(row.line) + ": ";
  }
  [[nodiscard]] const std::vector<std::string>& head() const { return table.rows.front().cells; }

  /// The cell as a number; NaN if it is empty.
  [[nodiscard]] double value(const CsvRow& row, std::size_t column, bool nanIsEmpty) const {
    const std::string& cell = row.cells[column];
    const bool none = cell.empty() || (nanIsEmpty && (cell == "nan" || cell == "NaN" || cell == "NAN"));
    const std::optional<double> number = none ? kNone : table.number(cell);
    if (!number)
      throw InputError(at(row) + "'" + cell.substr(0, 40) + "' in column '" + head()[column] +
                       "' is no number; give one, or nothing where there is no value");
    return *number;
  }
};

Index placeOf(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : found - names.begin();
}

/// More is a table of something else; comparing each two would take hours.
constexpr std::size_t kMostCases = 500;

void checkNames(const std::vector<std::string>& names, const Source& source) {
  if (names.size() > kMostCases)
    throw InputError(source.name + ": the head names " + std::to_string(names.size()) + " cases; " +
                     std::to_string(kMostCases) + " are the most; is this the right file?");
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (name->empty()) throw InputError(source.name + ": the head has an empty cell; name each case there");
    if (std::find(names.begin(), name, *name) != name)
      throw InputError(source.name + ": case '" + *name + "' stands twice in the head; name each once");
  }
}

/// One half fills the other, and the diagonal is 1.
void complete(Cohort& cohort, const Source& source) {
  Eigen::MatrixXd& c = cohort.correlation;
  for (Index i = 0; i < c.rows(); ++i) {
    c(i, i) = 1;
    for (Index j = 0; j < i; ++j) {
      if (std::isnan(c(i, j))) c(i, j) = c(j, i);
      if (std::isnan(c(j, i))) c(j, i) = c(i, j);
      if (std::isnan(c(i, j)))
        throw InputError(source.name + ": cases '" + cohort.cases[static_cast<std::size_t>(j)] + "' and '" +
                         cohort.cases[static_cast<std::size_t>(i)] +
                         "' have no correlation in either half; fill one of the two cells");
    }
  }
}

}  // namespace

CohortInput readCorrelationMatrix(const std::filesystem::path& file, CommandRun& run) {
  const Source source(file, run);
  CohortInput input;
  input.name = file.stem().string();
  Cohort& cohort = input.cohort;
  cohort.cases.assign(source.head().begin() + 1, source.head().end());
  checkNames(cohort.cases, source);
  const auto n = static_cast<Index>(cohort.cases.size());
  cohort.correlation = Eigen::MatrixXd::Constant(n, n, kNone);
  std::vector<bool> given(cohort.cases.size());
  for (auto row = source.table.rows.begin() + 1; row != source.table.rows.end(); ++row) {
    const Index i = placeOf(cohort.cases, row->cells.front());
    if (i < 0)
      throw InputError(source.at(*row) + "case '" + row->cells.front() +
                       "' is not in the head; give the same cases in rows and columns");
    if (given[static_cast<std::size_t>(i)])
      throw InputError(source.at(*row) + "case '" + row->cells.front() + "' has a row already; keep one");
    given[static_cast<std::size_t>(i)] = true;
    for (Index j = 0; j < n; ++j)
      cohort.correlation(i, j) = source.value(*row, static_cast<std::size_t>(j) + 1, false);
  }
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!given[i])
      throw InputError(source.name + ": case '" + cohort.cases[i] +
                       "' has no row; give one, empty if the column says all");
  complete(cohort, source);
  return input;
}

CohortInput readCohortMaps(const std::filesystem::path& file, CommandRun& run) {
  const Source source(file, run);
  CohortInput input;
  input.name = file.stem().string();
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < source.head().size(); ++c) {
    if (source.head()[c] == "vertex") continue;
    columns.push_back(c);
    input.cohort.cases.push_back(source.head()[c]);
  }
  checkNames(input.cohort.cases, source);
  input.vertices = static_cast<Index>(source.table.rows.size()) - 1;
  Eigen::MatrixXd maps(input.vertices, static_cast<Index>(columns.size()));
  for (Index v = 0; v < input.vertices; ++v)
    for (std::size_t c = 0; c < columns.size(); ++c)
      maps(v, static_cast<Index>(c)) =
          source.value(source.table.rows[static_cast<std::size_t>(v) + 1], columns[c], true);
  const std::vector<Index> overlap = commonCoverage(maps);
  input.overlap = static_cast<Index>(overlap.size());
  input.cohort.correlation = mapCorrelation(maps, overlap, input.cohort.cases);
  return input;
}

void readCohortGroups(const std::filesystem::path& file, Cohort& cohort, CommandRun& run) {
  const Source source(file, run);
  const Index name = placeOf(source.head(), "case"), group = placeOf(source.head(), "group");
  if (name < 0 || group < 0)
    throw InputError(source.name + " has no columns 'case' and 'group'; name them in the first line");
  cohort.groups.clear();
  cohort.groupOf.assign(cohort.cases.size(), -1);
  std::vector<bool> given(cohort.cases.size());
  for (auto row = source.table.rows.begin() + 1; row != source.table.rows.end(); ++row) {
    const std::string& caseName = row->cells[static_cast<std::size_t>(name)];
    const std::string& groupName = row->cells[static_cast<std::size_t>(group)];
    const Index i = placeOf(cohort.cases, caseName);
    if (i < 0) {
      run.warn(file.filename().string() + ": case '" + caseName + "' has a group but no correlations");
      continue;
    }
    if (given[static_cast<std::size_t>(i)])
      throw InputError(source.at(*row) + "case '" + caseName + "' has a group already; keep one line");
    given[static_cast<std::size_t>(i)] = true;
    if (groupName.empty()) continue;
    if (placeOf(cohort.groups, groupName) < 0) cohort.groups.push_back(groupName);
    cohort.groupOf[static_cast<std::size_t>(i)] = static_cast<int>(placeOf(cohort.groups, groupName));
  }
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!given[i])
      throw InputError(source.name + ": case '" + cohort.cases[i] +
                       "' has no line; add it, with nothing as its group if its procedure is its own");
  // In the order of their names, whatever the order of the file.
  std::vector<std::string> sorted = cohort.groups;
  std::sort(sorted.begin(), sorted.end());
  for (int& g : cohort.groupOf)
    if (g >= 0) g = static_cast<int>(placeOf(sorted, cohort.groups[static_cast<std::size_t>(g)]));
  cohort.groups = sorted;
}

}  // namespace falciform::commandline
