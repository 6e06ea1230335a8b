#include "Logic/Atlas/ScanChoice.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Errors.h"
#include "Logic/Registration/ScanSample.h"

namespace falciform {

ScanChoice chooseScanPoints(const Surface& scan, int count, std::uint64_t seed) {
  checkSurface(scan, "the scan");
  std::vector<int> rows(static_cast<std::size_t>(scan.size()));
  std::iota(rows.begin(), rows.end(), 0);
  Draws draws(seed);
  for (std::size_t i = rows.size(); i > 1; --i)
    std::swap(rows[i - 1], rows[static_cast<std::size_t>(draws.uniform() * static_cast<double>(i))]);
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(4 * count)));
  rows = withoutStragglers(scan.points, KdTree(scan.points), rows);
  if (rows.size() < 10)
    throw InputError("the scan has " + std::to_string(rows.size()) +
                     " usable points; a model update needs at least 10");
  ScanChoice choice;
  choice.crowd = scan.points(rows, Eigen::all);
  rows.resize(std::min(rows.size(), static_cast<std::size_t>(count)));
  choice.points = scan.points(rows, Eigen::all);
  for (const int row : rows) choice.labels.push_back(scan.patchAt(row));
  return choice;
}

}  // namespace falciform
