#pragma once
#include <filesystem>

#include "Logic/Core/Surface.h"
#include "Logic/IO/OutputFile.h"

namespace falciform::commandline {

/// One sheet, PNG, seen as the scanner saw it: the liver under the scan as the rigid registration leaves it,
/// as the update moves it (coloured by displacement beside the rigid motion), and the update's expected
/// error, where it expects one. All in the scan's frame; `updated` as UpdateTiles asks.
void saveUpdatePicture(const Surface& preop, const Surface& updated, const Surface& scan,
                       const Isometry3d& scanFromPreopRigid, const std::filesystem::path& file,
                       Overwrite overwrite);

}  // namespace falciform::commandline
