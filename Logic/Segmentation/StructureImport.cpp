#include "Logic/Segmentation/StructureImport.h"

#include <string>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/Segmentation/Mask.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {
namespace {

constexpr int kIterations = 15;
constexpr double kPassBand = 0.15;

}  // namespace

Surface structureSurface(const LabelMap& map, int label) {
  std::vector<char> wanted(65536, 0);
  if (label > 0 && label < 65536) wanted[static_cast<std::size_t>(label)] = 1;
  const Mask mask = cutOut(map, wanted);
  if (mask.voxels.empty())
    throw InputError("label " + std::to_string(label) + " is not in the map; choose one that is");
  Image field;
  field.size = mask.size;
  field.worldFromIndex = mask.worldFromIndex;
  field.voxels.assign(mask.voxels.begin(), mask.voxels.end());
  return smoothWindowedSinc(isosurface(field, 0.5), kIterations, kPassBand);
}

}  // namespace falciform
