#include "Logic/IO/DisplacementFiles.h"

#include "Logic/IO/HeaderText.h"
#include "Logic/IO/NiftiFile.h"
#include "Logic/IO/NrrdFile.h"

namespace falciform {
namespace {

std::string nameOf(const std::filesystem::path& file) { return lowerCase(file.filename().string()); }
bool isNrrd(const std::filesystem::path& file) {
  return nameOf(file).ends_with(".nrrd") && !nameOf(file).ends_with(".seg.nrrd");
}
bool isDeflated(const std::filesystem::path& file) { return nameOf(file).ends_with(".nii.gz"); }

}  // namespace

bool isDisplacementFile(const std::filesystem::path& file) {
  return isNrrd(file) || isDeflated(file) || nameOf(file).ends_with(".nii");
}

void writeDisplacements(const std::filesystem::path& file, const DisplacementGrid& grid,
                        Overwrite overwrite) {
  if (!isDisplacementFile(file))
    refuseVolume(file, "displacements are not written as " + inQuotes(file.extension().string()) +
                           "; use .nrrd, .nii or .nii.gz");
  VolumeLayout layout;
  layout.file = file;
  layout.size = checkedSize(file, grid.size.x(), grid.size.y(), grid.size.z());
  layout.worldFromIndex = grid.worldFromIndex;
  checkGeometry(layout);
  if (!isNrrd(file) && grid.size.maxCoeff() > 32767)
    refuseVolume(file, "the grid has " + std::to_string(grid.size.maxCoeff()) +
                           " points along one axis, NIfTI holds 32767; save it as .nrrd");
  writeFile(file, overwrite, [&](const std::filesystem::path& temporary) {
    if (isNrrd(file))
      writeNrrdDisplacements(temporary, grid);
    else
      writeNiftiDisplacements(temporary, grid, isDeflated(file));
  });
}

}  // namespace falciform
