#include "Modules/CommandLine/SlicePicture.h"

#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Geometry/PlaneSection.h"
#include "Modules/CommandLine/GreySlice.h"

namespace falciform::commandline {
namespace {

constexpr double kMarginMm = 20;
constexpr PixelColour kNow{255, 214, 10}, kWas{90, 200, 250};

/// Two pixels thick; dashes by place, so that they do not depend on how the outline is cut into segments.
void drawOutline(RenderedImage& image, const SliceFrame& frame, const Surface& surface,
                 const PixelColour& colour, bool dashed) {
  const Points ends = planeSection(surface, 2, frame.z);
  for (Index s = 0; s + 1 < ends.rows(); s += 2) {
    const Eigen::Vector2d from = frame.pixel(ends.row(s).transpose()),
                          to = frame.pixel(ends.row(s + 1).transpose());
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * (to - from).norm())));
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector2d at = from + (to - from) * k / steps;
      if (dashed && (static_cast<int>(at.x() / 6) + static_cast<int>(at.y() / 6)) % 2 != 0) continue;
      drawDot(image, static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y())), colour);
    }
  }
}

}  // namespace

SlicePictures slicePictures(const Image& before, const Image& after, const Surface& preop,
                            const TetrahedralMesh& mesh, const UpdateResult& update) {
  const Points bending(MeshPlaces(mesh, preop.points).interpolate(update.displacements));
  Surface bent = preop;
  bent.points += bending;
  Index most = 0;
  bending.leftCols<2>().rowwise().squaredNorm().maxCoeff(&most);

  SliceFrame frame;
  frame.z = bent.points(most, 2);
  const Vector3d low =
                     preop.points.colwise().minCoeff().cwiseMin(bent.points.colwise().minCoeff()).transpose(),
                 high =
                     preop.points.colwise().maxCoeff().cwiseMax(bent.points.colwise().maxCoeff()).transpose();
  frame.middle = (low + high) / 2;
  frame.mmPerPixel = std::max((high.x() - low.x() + 2 * kMarginMm) / frame.width,
                              (high.y() - low.y() + 2 * kMarginMm) / frame.height);
  SlicePictures pictures{greySlice(before, frame), greySlice(after, frame)};
  drawOutline(pictures.before, frame, preop, kWas, false);
  drawOutline(pictures.after, frame, preop, kWas, true);
  drawOutline(pictures.after, frame, bent, kNow, false);
  return pictures;
}

}  // namespace falciform::commandline
