#include "Logic/Acquisition/ScannerPhotograph.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr int kWidth = 1280;
constexpr double kAmbient = 0.35, kGleam = 0.5, kGleamPower = 60;

/// The scanner's picture plane in pixels.
struct PictureGrid {
  double halfWidth, halfHeight;  ///< of the plane at distance 1
  int width, height;

  explicit PictureGrid(const ScannerView& view)
      : halfWidth(-view.u0 + 0.5 * view.step),
        halfHeight(-view.v0 + 0.5 * view.step),
        width(kWidth),
        height(std::max(1, static_cast<int>(std::lround(kWidth * halfHeight / halfWidth)))) {}

  [[nodiscard]] Vector3d ray(const ScannerView& view, int column, int row) const {
    const double u = (2 * (column + 0.5) / width - 1) * halfWidth,
                 v = (2 * (row + 0.5) / height - 1) * halfHeight;
    return view.forward + u * view.right + v * view.down;
  }
};

/// One pixel, as the light beside the camera shows it.
std::array<std::uint8_t, 3> pixel(const ScanScene& scene, const TriangleTree& tree, const Vector3d& eye,
                                  const Vector3d& ray) {
  const Vector3d direction = ray.normalized();
  const auto hit = tree.cast(eye, direction);
  if (!hit) return {0, 0, 0};
  const int vertex = nearestCorner(scene.surface, hit->triangle, hit->point);
  const int source =
      scene.structure.empty() ? structure::kOrgan : scene.structure[static_cast<std::size_t>(vertex)];
  const double facing = std::clamp(-tree.triangleNormal(hit->triangle).dot(direction), 0.0, 1.0);
  const double light = kAmbient + (1 - kAmbient) * facing;
  const double gleam = source == structure::kDrape ? 0 : 255 * kGleam * std::pow(facing, kGleamPower);
  std::array<std::uint8_t, 3> rgb = sceneColour(source, hit->point, scene.surface.patchAt(vertex));
  for (std::uint8_t& value : rgb)
    value = static_cast<std::uint8_t>(std::lround(std::clamp(light * value + gleam, 0.0, 255.0)));
  return rgb;
}

}  // namespace

void photographScan(const ScanScene& scene, const TriangleTree& tree, const ScannerView& view,
                    Surface& scan) {
  const PictureGrid grid(view);
  ColourImage image;
  image.width = grid.width;
  image.height = grid.height;
  image.rgb.resize(3 * static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  forEachChunk(static_cast<std::size_t>(grid.height), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row)
      for (int column = 0; column < grid.width; ++column) {
        const auto rgb = pixel(scene, tree, view.eye, grid.ray(view, column, static_cast<int>(row)));
        std::copy(
            rgb.begin(), rgb.end(),
            image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (row * static_cast<std::size_t>(grid.width) +
                                                                 static_cast<std::size_t>(column))));
      }
  });
  scan.textureAt.resize(scan.size(), 2);
  for (Index i = 0; i < scan.size(); ++i) {
    const Vector3d way = scan.points.row(i).transpose() - view.eye;
    const double depth = way.dot(view.forward);
    scan.textureAt(i, 0) = static_cast<float>(0.5 + 0.5 * way.dot(view.right) / depth / grid.halfWidth);
    scan.textureAt(i, 1) = static_cast<float>(0.5 - 0.5 * way.dot(view.down) / depth / grid.halfHeight);
  }
  scan.colours = coloursAt(image, scan.textureAt);
  scan.texture = std::make_shared<const ColourImage>(std::move(image));
}

}  // namespace falciform
