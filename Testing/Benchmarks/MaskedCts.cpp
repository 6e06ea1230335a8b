#include "Testing/Benchmarks/MaskedCts.h"

namespace falciform::bench {
namespace {

constexpr int kMarginVoxels = 3;

}  // namespace

const std::vector<MaskedCt>& maskedCts() {
  static const std::vector<MaskedCt> all{
      {"3D-IRCADb 17, portal phase, 0.74 x 0.74 x 1.6 mm",
       "ircad17/ct",
       "ircad17/masks/liver",
       0,
       {{"3: right lobe, left lobe, dome", {{97, 154, 77}, {190, 74, 115}, {147, 94, 154}}},
        {"3: right lobe, left lobe, the larger tumour", {{97, 154, 77}, {190, 74, 115}, {204, 126, 144}}},
        {"5: both lobes, dome, two tumours",
         {{97, 154, 77}, {190, 74, 115}, {147, 94, 154}, {204, 126, 144}, {92, 135, 150}}}}},
      {"TotalSegmentator example, no contrast, 3 mm",
       "volumes/example_ct.nii.gz",
       "volumes/example_seg_fast_force_split.nii.gz",
       5,
       {{"3: right lobe, left lobe, lower right lobe",
         {{-65, -164, 409}, {28, -236, 409}, {-107, -164, 349}}}}}};
  return all;
}

Points pointsOf(const std::vector<Vector3d>& places) {
  Points points(static_cast<Index>(places.size()), 3);
  for (std::size_t p = 0; p < places.size(); ++p) points.row(static_cast<Index>(p)) = places[p].transpose();
  return points;
}

MaskPair cropped(const LabelMap& a, const LabelMap& b, int label) {
  const auto inB = [&](std::size_t i) { return label == 0 ? b.voxels[i] > 0 : b.voxels[i] == label; };
  Vector3i low = a.size, high = Vector3i::Zero();
  for (int k = 0; k < a.size.z(); ++k)
    for (int j = 0; j < a.size.y(); ++j)
      for (int i = 0; i < a.size.x(); ++i)
        if (const std::size_t at = a.offset(i, j, k); a.voxels[at] > 0 || inB(at)) {
          low = low.cwiseMin(Vector3i(i, j, k));
          high = high.cwiseMax(Vector3i(i, j, k));
        }
  low = (low.array() - kMarginVoxels).max(0);
  high = (high.array() + kMarginVoxels).min(a.size.array() - 1);
  MaskPair pair;
  pair.a.size = high - low + Vector3i::Ones();
  pair.a.worldFromIndex = a.worldFromIndex;
  pair.b = pair.a;
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i) {
        const std::size_t at = a.offset(i, j, k);
        pair.a.voxels.push_back(a.voxels[at] > 0);
        pair.b.voxels.push_back(inB(at));
      }
  return pair;
}

double diceOf(const MaskPair& pair) {
  std::size_t both = 0, sum = 0;
  for (std::size_t i = 0; i < pair.a.voxels.size(); ++i) {
    both += pair.a.voxels[i] & pair.b.voxels[i];
    sum += static_cast<std::size_t>(pair.a.voxels[i]) + pair.b.voxels[i];
  }
  return 2 * static_cast<double>(both) / static_cast<double>(sum);
}

}  // namespace falciform::bench
