#pragma once
#include <filesystem>
#include <vector>

#include "Logic/Atlas/Atlas.h"
#include "Logic/IO/OutputFile.h"

namespace falciform::commandline {

/// Five members that show what an atlas holds: of setups spread evenly, the farthest moved that folds next to
/// no tissue, or the least folded; of one setup, members spread evenly.
[[nodiscard]] std::vector<Index> telling(const Atlas& atlas);

/// One sheet, PNG: the first member's supports from behind and below in the colours of the thesis's
/// Fig. V.6, then each member from the front, coloured by displacement on one scale, the liver at rest as a
/// shadow. Drawn without a display. Throws InputError for a member that is not there.
void saveAtlasPicture(const Atlas& atlas, const std::vector<Index>& members,
                      const std::filesystem::path& file, Overwrite overwrite);

}  // namespace falciform::commandline
