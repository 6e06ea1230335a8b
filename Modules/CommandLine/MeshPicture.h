#pragma once
#include <filesystem>

#include "Logic/Core/TetrahedralMesh.h"
#include "Logic/IO/OutputFile.h"

namespace falciform::commandline {

/// The mesh cut open: the elements behind a plane through the rearmost tumour (or the middle), seen from the
/// front, tumours before it whole; regions in their colours, cut elements lighter than the outside. PNG,
/// drawn without a display.
void saveMeshPicture(const TetrahedralMesh& mesh, const std::filesystem::path& file, Overwrite overwrite);

}  // namespace falciform::commandline
