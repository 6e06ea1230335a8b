#pragma once
#include <span>
#include <string>
#include <vector>

#include "Testing/Benchmarks/ThesisUpdateFigures.h"
#include "Testing/Benchmarks/UpdateTrial.h"

namespace falciform::bench {

/// A row of one of thesis Tables V.1 to V.4 as measured here.
struct MeasuredRow {
  std::string trial;
  ErrorFigures before, fullRigid, fullUpdated, partialRigid, partialUpdated;
};

/// Prints a table of chapter V, the thesis's figures beside ours. `rigid`, `update`: the methods' names.
/// With spreads if the thesis has them; with a last row of means, as Tables V.1 and V.2, if it has not.
void printThesisTable(const std::string& rigid, const std::string& update,
                      const std::vector<MeasuredRow>& rows, std::span<const UpdateRow> thesis);

/// Means over rows of means and of largest errors, as the thesis takes them.
[[nodiscard]] ErrorFigures meanOf(const std::vector<ErrorFigures>& figures);

}  // namespace falciform::bench
