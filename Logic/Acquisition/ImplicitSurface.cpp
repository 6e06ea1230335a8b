#include "Logic/Acquisition/ImplicitSurface.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Remesh.h"
#include "Logic/VtkBridge/SurfaceFilters.h"

namespace falciform {
namespace {

constexpr int kBlock = 8;          // grid points along a block's edge
constexpr double kSteepest = 2.0;  // bound on the field's slope
constexpr int kNewtonSteps = 4;    // the field is nearly a distance: each step squares the error
constexpr std::size_t kVertexChunk = 512;

void sampleBlock(const ImplicitFunction& distance, const Vector3i& first, double step, Image& depth) {
  const Vector3i last = (first.array() + kBlock).min(depth.size.array());
  const Vector3d middle = depth.world(0.5 * (first + last - Vector3i::Ones()).cast<double>());
  const double reach = 0.5 * kBlock * step * std::sqrt(3.0) + 2 * step;
  const double atMiddle = distance(middle);
  const bool far = std::abs(atMiddle) > kSteepest * reach;
  for (int k = first.z(); k < last.z(); ++k)
    for (int j = first.y(); j < last.y(); ++j)
      for (int i = first.x(); i < last.x(); ++i)
        depth.at(i, j, k) = static_cast<float>(far ? -atMiddle : -distance(depth.world(Vector3d(i, j, k))));
}

/// Moves p onto the zero along the gradient, never by more than `reach` a step.
Vector3d ontoZero(const ImplicitFunction& distance, Vector3d p, double reach) {
  constexpr double kStep = 1e-4;  // mm
  for (int n = 0; n < kNewtonSteps; ++n) {
    const double value = distance(p);
    if (std::abs(value) < 1e-9) break;
    Vector3d slope;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d h = kStep * Vector3d::Unit(axis);
      slope[axis] = (distance(p + h) - distance(p - h)) / (2 * kStep);
    }
    Vector3d move = -value / std::max(slope.squaredNorm(), 0.05) * slope;
    if (move.norm() > reach) move *= reach / move.norm();
    p += move;
  }
  return p;
}

}  // namespace

Image sampleDepth(const ImplicitFunction& distance, const Box& box, double step, const Progress& progress) {
  Image depth;
  depth.size = ((box.row(1) - box.row(0)) / step).array().ceil().cast<int>().transpose() + 1;
  depth.worldFromIndex.diagonal().head<3>().setConstant(step);
  depth.worldFromIndex.topRightCorner<3, 1>() = box.row(0).transpose();
  depth.voxels.resize(static_cast<std::size_t>(depth.size.x()) * static_cast<std::size_t>(depth.size.y()) *
                      static_cast<std::size_t>(depth.size.z()));
  const Vector3i blocks = (depth.size.array() + kBlock - 1) / kBlock;
  const std::size_t perSlab = static_cast<std::size_t>(blocks.x()) * static_cast<std::size_t>(blocks.y());
  for (int slab = 0; slab < blocks.z(); ++slab) {
    progress.report(static_cast<double>(slab) / blocks.z(), "Sampling the body");
    forEachChunk(perSlab, 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b)
        sampleBlock(
            distance,
            kBlock * Vector3i(static_cast<int>(b) % blocks.x(), static_cast<int>(b) / blocks.x(), slab), step,
            depth);
    });
  }
  return depth;
}

Surface meshImplicit(const ImplicitFunction& distance, const Box& box, double step, double edgeLengthMm,
                     const Progress& progress) {
  const Image depth = sampleDepth(distance, box, step, progress.part(0, 0.3));
  Surface surface = isosurface(depth, 0);
  surface = remeshIsotropic(surface, edgeLengthMm, 6, progress.part(0.3, 0.95));
  forEachChunk(static_cast<std::size_t>(surface.size()), kVertexChunk,
               [&](std::size_t begin, std::size_t end) {
                 for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
                   surface.points.row(i) =
                       ontoZero(distance, surface.points.row(i).transpose(), 0.3 * edgeLengthMm).transpose();
               });
  progress.report(1);
  return surface;
}

}  // namespace falciform
