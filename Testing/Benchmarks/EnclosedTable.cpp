// ./run bench segmentation-enclosed: what the search for enclosed tissue finds on ten real livers' shapes
// (Docs/Segmentation.md). Nothing should be found where all around them is muscle, in the porta hepatis, the
// gallbladder's bed and the cava's groove; tumours painted on their border should be.
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/EnclosedTissue.h"
#include "Logic/Segmentation/GridFilters.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

constexpr int kTumours = 5;       // painted on each liver, one at a time
constexpr double kVoxelMm = 3.2;  // of the first growth
constexpr double kMarginMm = 40;
constexpr float kOrganHu = 100, kMuscleHu = 55, kFatHu = -90, kTumourHu = 50;
using Flags = Volume<std::uint8_t>;

/// The liver on a coarse grid with a margin, axes along LPS.
Flags coarse(const LabelMap& map) {
  const Matrix4d indexFromWorld = map.worldFromIndex.inverse();
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j)
      for (int i = 0; i < map.size.x(); ++i)
        if (map.at(i, j, k) > 0) {
          low = low.cwiseMin(map.world(Vector3d(i, j, k)));
          high = high.cwiseMax(map.world(Vector3d(i, j, k)));
        }
  Flags liver;
  low.array() -= kMarginMm;
  liver.size =
      ((high - low).array() + kMarginMm).cwiseQuotient(Vector3d::Constant(kVoxelMm).array()).cast<int>();
  liver.worldFromIndex.diagonal().head<3>().setConstant(kVoxelMm);
  liver.worldFromIndex.col(3).head<3>() = low;
  for (int k = 0; k < liver.size.z(); ++k)
    for (int j = 0; j < liver.size.y(); ++j)
      for (int i = 0; i < liver.size.x(); ++i) {
        const Vector3i at = (indexFromWorld * liver.world(Vector3d(i, j, k)).homogeneous())
                                .head<3>()
                                .array()
                                .round()
                                .cast<int>();
        const bool inside = (at.array() >= 0).all() && (at.array() < map.size.array()).all();
        liver.voxels.push_back(inside && map.at(at.x(), at.y(), at.z()) > 0);
      }
  return liver;
}

/// The liver with a ball cut out of it, and what the search finds with `aroundHu` about both.
std::vector<EnclosedBody> found(const Flags& liver, const Vector3d& ball, double radiusMm, float aroundHu,
                                bool beyond) {
  Flags organ = liver;
  Image image = sameGrid(liver, aroundHu);
  for (int k = 0; k < liver.size.z(); ++k)
    for (int j = 0; j < liver.size.y(); ++j)
      for (int i = 0; i < liver.size.x(); ++i) {
        const std::size_t at = liver.offset(i, j, k);
        const bool tumour = (liver.world(Vector3d(i, j, k)) - ball).norm() < radiusMm;
        if (liver.voxels[at] != 0) image.voxels[at] = kOrganHu;
        if (tumour && (beyond || liver.voxels[at] != 0)) {
          image.voxels[at] = kTumourHu;
          organ.voxels[at] = 0;
        }
      }
  return enclosedBodies(image, organ, {}, {});
}

double millilitres(const std::vector<EnclosedBody>& bodies) {
  double sum = 0;
  for (const EnclosedBody& body : bodies) sum += body.volumeMl;
  return sum;
}

/// Places so deep in the liver.
std::vector<Vector3d> placesAt(const Flags& liver, double depthMm) {
  Flags outside = liver;
  for (std::uint8_t& value : outside.voxels) value = value == 0;
  const Image depth = distanceTo(outside);
  std::vector<Vector3d> places;
  for (int k = 0; k < liver.size.z(); ++k)
    for (int j = 0; j < liver.size.y(); ++j)
      for (int i = 0; i < liver.size.x(); ++i)
        if (std::abs(static_cast<double>(depth.at(i, j, k)) - depthMm) < kVoxelMm / 2)
          places.push_back(liver.world(Vector3d(i, j, k)));
  return places;
}

int run() {
  setThreads(2);
  std::printf(
      "Ten livers of 3D-IRCADb, %.1f mm voxels. %d tumours of 50 HU on each liver, one at a time, radius 12 "
      "to "
      "25 mm, at random places; found: bodies of at least 40 %% of its ball's volume taken in.\n\n"
      "| liver | nothing but muscle around: taken in, ml | tumour's middle half a radius deep, in fat: found "
      "| "
      "the same, in muscle | middle on the border, standing out into fat: found |\n|---|---|---|---|---|\n",
      kVoxelMm, kTumours);
  for (const int number : {2, 3, 4, 5, 6, 7, 8, 9, 10, 17}) {
    const auto file = test::realData() / ("cohort/couinaud/3Dircadb-" + std::to_string(number) + ".nii.gz");
    if (!std::filesystem::exists(file)) continue;
    const Flags liver = coarse(readLabelMap(file).value);
    const double wrong = millilitres(found(liver, Vector3d::Constant(1e6), 1, kMuscleHu, false));
    int inFat = 0, inMuscle = 0, outstanding = 0;
    Draws random(static_cast<std::uint64_t>(number), 5);
    for (int t = 0; t < kTumours; ++t) {
      const double radius = 12 + 13 * random.uniform(),
                   sphereMl = 4.0 / 3 * std::numbers::pi * radius * radius * radius / 1000;
      const std::vector<Vector3d> deep = placesAt(liver, radius / 2), edge = placesAt(liver, 1.5);
      const auto any = [&](const std::vector<Vector3d>& places) {
        return places[static_cast<std::size_t>(random.uniform() * static_cast<double>(places.size()))];
      };
      const Vector3d at = any(deep), onEdge = any(edge);
      inFat += millilitres(found(liver, at, radius, kFatHu, false)) > 0.4 * sphereMl;
      inMuscle += millilitres(found(liver, at, radius, kMuscleHu, false)) > 0.4 * sphereMl;
      outstanding += millilitres(found(liver, onEdge, radius, kFatHu, true)) > 0.4 * sphereMl;
    }
    std::printf("| %d | %.0f | %d of %d | %d of %d | %d of %d |\n", number, wrong, inFat, kTumours, inMuscle,
                kTumours, outstanding, kTumours);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main() { return falciform::bench::run(); }
