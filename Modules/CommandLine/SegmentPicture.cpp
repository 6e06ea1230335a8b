#include "Modules/CommandLine/SegmentPicture.h"

#include <algorithm>
#include <cmath>

#include "Modules/CommandLine/GreySlice.h"
#include "Modules/CommandLine/PictureTiles.h"

namespace falciform::commandline {
namespace {

constexpr int kCuts = 6, kColumns = 3, kCross = 7;
constexpr double kMarginMm = 25, kSeedMm = 10;
constexpr PixelColour kOutline{255, 214, 10}, kSeed{255, 69, 58};

struct Box {
  Vector3d low = Vector3d::Constant(1e30), high = Vector3d::Constant(-1e30);
};

Box boxOf(const LabelMap& labels) {
  Box box;
  for (int k = 0; k < labels.size.z(); ++k)
    for (int j = 0; j < labels.size.y(); ++j)
      for (int i = 0; i < labels.size.x(); ++i)
        if (labels.at(i, j, k) > 0) {
          const Vector3d at = labels.world(Vector3d(i, j, k));
          box.low = box.low.cwiseMin(at);
          box.high = box.high.cwiseMax(at);
        }
  return box;
}

bool organAt(const LabelMap& labels, const Matrix4d& indexFromWorld, const Vector3d& mm) {
  const Vector3i at = (indexFromWorld * mm.homogeneous()).head<3>().array().round().cast<int>();
  if ((at.array() < 0).any() || (at.array() >= labels.size.array()).any()) return false;
  return labels.at(at.x(), at.y(), at.z()) > 0;
}

void drawOutline(RenderedImage& image, const SliceFrame& frame, const LabelMap& labels) {
  const Matrix4d indexFromWorld = labels.worldFromIndex.inverse();
  const auto organ = [&](int column, int row) {
    return organAt(labels, indexFromWorld, frame.place(column + 0.5, row + 0.5));
  };
  for (int row = 0; row + 1 < frame.height; ++row)
    for (int column = 0; column + 1 < frame.width; ++column) {
      const bool here = organ(column, row);
      if (organ(column + 1, row) != here || organ(column, row + 1) != here)
        drawDot(image, column, row, kOutline);
    }
}

void drawSeeds(RenderedImage& image, const SliceFrame& frame, const Points& seeds) {
  for (Index s = 0; s < seeds.rows(); ++s) {
    const Vector3d mm = seeds.row(s).transpose();
    if (std::abs(mm.z() - frame.z) > kSeedMm) continue;
    const Eigen::Vector2d at = frame.pixel(mm);
    for (int d = -kCross; d <= kCross; ++d) {
      drawDot(image, static_cast<int>(at.x()) + d, static_cast<int>(at.y()), kSeed);
      drawDot(image, static_cast<int>(at.x()), static_cast<int>(at.y()) + d, kSeed);
    }
  }
}

}  // namespace

RenderedImage segmentPicture(const Image& ct, const LabelMap& labels, const Points& seeds) {
  const Box box = boxOf(labels);
  std::vector<RenderedImage> tiles;
  for (int cut = 0; cut < kCuts; ++cut) {
    SliceFrame frame;
    frame.middle = (box.low + box.high) / 2;
    frame.z = box.low.z() + (box.high.z() - box.low.z()) * (cut + 0.5) / kCuts;
    frame.mmPerPixel = std::max((box.high.x() - box.low.x() + 2 * kMarginMm) / frame.width,
                                (box.high.y() - box.low.y() + 2 * kMarginMm) / frame.height);
    RenderedImage tile = greySlice(ct, frame);
    drawOutline(tile, frame, labels);
    drawSeeds(tile, frame, seeds);
    tiles.push_back(std::move(tile));
  }
  return sheetOf(tiles, kColumns);
}

}  // namespace falciform::commandline
