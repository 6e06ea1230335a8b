#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "Logic/Geometry/TriangleTree.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/Support/RealData.h"

// One patient in three forms: a CT and binary masks as DICOM (files that do not sort by name), and a map of
// the liver's segments as NIfTI.

namespace falciform::test {

namespace {

const Vector3d kSpacingMm(0.743, 0.743, 1.6);

/// The largest and mean distance between surfaces, in voxels along each axis, from the points of `a` to `b`.
struct Apart {
  double mean = 0, share95 = 0;
};
Apart halfVoxelsApart(const Surface& a, const Surface& b) {
  const TriangleTree tree(b);
  std::vector<double> voxels;
  for (Index p = 0; p < a.size(); p += 7) {
    const Vector3d point = a.points.row(p);
    const Vector3d apart = tree.closest(point).point - point;
    voxels.push_back(apart.cwiseQuotient(kSpacingMm).cwiseAbs().maxCoeff());
  }
  std::sort(voxels.begin(), voxels.end());
  Apart result;
  for (const double v : voxels) result.mean += v / static_cast<double>(voxels.size());
  result.share95 = voxels[voxels.size() * 95 / 100];
  return result;
}

Vector3d middleOf(const LabelMap& map) {
  Vector3d sum = Vector3d::Zero();
  double count = 0;
  for (int k = 0; k < map.size.z(); ++k)
    for (int j = 0; j < map.size.y(); ++j)
      for (int i = 0; i < map.size.x(); ++i)
        if (map.at(i, j, k) > 0) {
          sum += map.world(Vector3d(i, j, k));
          ++count;
        }
  return sum / count;
}

}  // namespace

TEST(DicomReal, CtOpensInSecondsInItsPlace) {
  FALCIFORM_NEEDS_DATA("ircad17/ct");
  const auto start = std::chrono::steady_clock::now();
  const auto ct = readImage(realData() / "ircad17/ct");
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(seconds, 10) << "0.7 s on an idle machine; the rest is for others' load";
  EXPECT_EQ(ct.value.size, Vector3i(512, 512, 119));
  Matrix4d expected = Matrix4d::Identity();
  expected.topLeftCorner<3, 3>() = kSpacingMm.asDiagonal();
  EXPECT_LT((ct.value.worldFromIndex - expected).cwiseAbs().maxCoeff(), 1e-5) << "mm; written as float32";
  EXPECT_TRUE(ct.warnings.empty());
  const auto [low, high] = std::minmax_element(ct.value.voxels.begin(), ct.value.voxels.end());
  EXPECT_EQ(*low, -1024) << "HU of air";
  EXPECT_EQ(*high, 1023) << "HU, cut by the export";
}

TEST(DicomReal, LiverMaskLiesOnTheLiverOfTheCtAndOnTheNiftiSegments) {
  FALCIFORM_NEEDS_DATA("ircad17/masks/liver");
  const auto mask = readNamedLabels(realData() / "ircad17/masks/liver");
  EXPECT_EQ(mask.value.names, (std::map<int, std::string>{{1, "liver"}}));
  const LabelMap& liver = mask.value.map;
  const auto segments = readLabelMap(realData() / "ircad17/couinaud.nii.gz");
  const Vector3d apart = (middleOf(liver) - middleOf(segments.value)).cwiseQuotient(kSpacingMm);
  EXPECT_LT(apart.cwiseAbs().maxCoeff(), 0.5) << "voxels between the two livers' middles";

  const auto ct = readImage(realData() / "ircad17/ct");
  ASSERT_EQ(ct.value.size, liver.size);
  double sum = 0, voxels = 0;
  for (std::size_t v = 0; v < liver.voxels.size(); ++v)
    if (liver.voxels[v] > 0) {
      sum += static_cast<double>(ct.value.voxels[v]);
      ++voxels;
    }
  EXPECT_NEAR(voxels * liver.voxelVolume() / 1000, 1861, 18.6) << "ml, 1 % of the published volume";
  EXPECT_GT(sum / voxels, 80) << "HU of a liver in the portal phase";
  EXPECT_LT(sum / voxels, 160) << "HU of a liver in the portal phase";

  // In the same world whatever the file's axes (NIfTI: LAS): every border within half a voxel.
  const SurfaceImportSettings settings;
  const Surface a = importSurface(liver, settings).surface,
                b = importSurface(segments.value, settings).surface;
  const Apart there = halfVoxelsApart(a, b), back = halfVoxelsApart(b, a);
  for (const Apart& way : {there, back}) {
    EXPECT_LT(way.mean, 0.1) << "voxels; the maps differ in 0.02 % of their voxels";
    EXPECT_LT(way.share95, 0.5) << "voxels";
  }
}

TEST(DicomReal, MasksOfOneFolderBecomeOneMapWithTheirNames) {
  FALCIFORM_NEEDS_DATA("ircad17/masks");
  const auto named = readNamedLabels(realData() / "ircad17/masks");
  std::vector<std::string> names;
  for (const auto& [label, name] : named.value.names) names.push_back(name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("liver", "livertumor1", "portalvein", "venoussystem"));
  EXPECT_EQ(named.value.names.at(1), "liver") << "the largest";
  std::vector<std::size_t> voxels(5, 0);
  for (const auto label : named.value.map.voxels) ++voxels.at(label);
  for (std::size_t label = 1; label < 5; ++label)
    EXPECT_GT(voxels[label], 1000u) << "voxels of label " << label;
}

TEST(DicomReal, Jpeg2000SlabIsReadAsOpenJpegDecodesIt) {
  FALCIFORM_NEEDS_DATA("volumes/dicom_jpeg2000");
  const auto listing = listDicom(realData() / "volumes/dicom_jpeg2000");
  ASSERT_EQ(listing.series.size(), 1u);
  EXPECT_EQ(listing.series[0].modality, "CT");
  const auto slab = readImage(realData() / "volumes/dicom_jpeg2000");
  EXPECT_EQ(slab.value.size, Vector3i(512, 512, 20));
  // Slices are 2 mm apart, and said to be 3 mm thick.
  EXPECT_LT((slab.value.spacing() - Vector3d(0.9765625, 0.9765625, 2)).norm(), 1e-4);
  EXPECT_LT((slab.value.world({0, 0, 0}) - Vector3d(-249.51171875, -437.51171875, -804.5)).norm(), 1e-3);
  // Values of opj_decompress (OpenJPEG 2.5) with the header's intercept, lowest and highest slice.
  const auto sumOf = [&](int k) {
    double sum = 0;
    for (int v = 0; v < 512 * 512; ++v)
      sum += static_cast<double>(slab.value.voxels[slab.value.offset(0, 0, k) + static_cast<std::size_t>(v)]);
    return sum;
  };
  EXPECT_EQ(sumOf(0), 103453060.0 - 1024.0 * 512 * 512);
  EXPECT_EQ(sumOf(19), 105356346.0 - 1024.0 * 512 * 512);
  EXPECT_EQ(slab.value.at(200, 100, 0), 28 - 1024);
  EXPECT_EQ(slab.value.at(256, 256, 0), 1110 - 1024);
  EXPECT_EQ(slab.value.at(256, 256, 19), 1118 - 1024);
  // One file stands for its series.
  EXPECT_EQ(readImage(listing.series[0].slices[7].file).value.voxels, slab.value.voxels);
}

}  // namespace falciform::test
