#include "Logic/Segmentation/LevelSetInput.h"

#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Logic/Core/PlaceText.h"

namespace falciform {

namespace {

constexpr int kLeastVoxels = 4;     ///< along each axis: fewer are slices, not a volume
constexpr double kSameGrid = 1e-3;  ///< mm: rounding of two files' headers

void checkMap(const LabelMap* map, const Image& ct, const std::string& what) {
  if (map == nullptr) return;
  if (map->size != ct.size || map->voxels.size() != ct.voxels.size() ||
      (map->worldFromIndex - ct.worldFromIndex).cwiseAbs().maxCoeff() > kSameGrid)
    throw InputError(what + " has a grid of " + std::to_string(map->size.x()) + " x " +
                     std::to_string(map->size.y()) + " x " + std::to_string(map->size.z()) +
                     " voxels that is not the CT's; give one made on this CT");
}

}  // namespace

void checkLevelSetInput(const LevelSetInput& input) {
  const Image& ct = input.ct;
  if (ct.size.minCoeff() < kLeastVoxels)
    throw InputError("the volume has " + std::to_string(ct.size.x()) + " x " + std::to_string(ct.size.y()) +
                     " x " + std::to_string(ct.size.z()) + " voxels; at least " +
                     std::to_string(kLeastVoxels) + " along each axis are needed");
  if (!ct.worldFromIndex.allFinite() || !(ct.spacing().minCoeff() > 1e-3) ||
      !(ct.spacing().maxCoeff() < 1e3) || !(ct.voxelVolume() > 0.5 * ct.spacing().prod()))
    throw InputError("the volume's voxels measure " + roundedText(ct.spacing().x(), 3) + " x " +
                     roundedText(ct.spacing().y(), 3) + " x " + roundedText(ct.spacing().z(), 3) +
                     " mm or are skewed; mend the file's header");
  if (input.seeds.rows() == 0 && input.start == nullptr)
    throw InputError("no seeds were given; click at least once inside the organ");
  checkMap(input.start, ct, "the label map to go on from");
  checkMap(input.forbidden, ct, "the map of forbidden voxels");
  if (input.start != nullptr && input.seeds.rows() == 0 &&
      std::none_of(input.start->voxels.begin(), input.start->voxels.end(),
                   [](std::uint16_t v) { return v > 0; }))
    throw InputError("the label map to go on from is empty; give seeds, or a map with voxels above 0");
  const Matrix4d indexFromWorld = ct.worldFromIndex.inverse();
  for (Index s = 0; s < input.seeds.rows(); ++s) {
    const Vector3d mm = input.seeds.row(s).transpose();
    const Vector3d index = (indexFromWorld * mm.homogeneous()).head<3>();
    if (!mm.allFinite() || (index.array() < -0.5).any() ||
        (index.array() > ct.size.cast<double>().array() - 0.5).any())
      throw InputError("seed " + std::to_string(s + 1) + " at " + placeText(mm) +
                       " lies outside the volume; give it in patient LPS mm");
  }
}

std::vector<Vector3d> storedSeeds(const Points& seeds, const StorageOrder& order) {
  std::vector<Vector3d> indices;
  const Matrix4d indexFromWorld = order.worldFromIndex.inverse();
  for (Index s = 0; s < seeds.rows(); ++s)
    indices.emplace_back((indexFromWorld * Vector3d(seeds.row(s).transpose()).homogeneous()).head<3>());
  return indices;
}

}  // namespace falciform
