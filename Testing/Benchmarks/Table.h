#pragma once
#include <string>
#include <vector>

#include "Testing/Benchmarks/Outcomes.h"

namespace falciform::bench {

/// One way of doing a thing, and how it went.
struct Row {
  std::string who;
  Tally tally;
  bool judged = true;  ///< whether right or wrong means anything here
};

/// The head of the one table; rows of all kinds share its columns.
void printHead();
/// The rows of one comparison. `reference` is the row to whose median wall time the ratios are ("" or
/// unknown: none).
void printRows(const std::string& what, const std::vector<Row>& rows, const std::string& reference);

}  // namespace falciform::bench
