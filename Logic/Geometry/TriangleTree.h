#pragma once
#include <limits>
#include <memory>
#include <optional>

#include "Logic/Core/Surface.h"

namespace falciform {

/// The closest place of a surface to a query.
struct ClosestPlace {
  int triangle = -1;                                          ///< -1: none within the bound
  Vector3d point = Vector3d::Zero();                          ///< mm
  Vector3d barycentric = Vector3d::Zero();                    ///< weights of the triangle's three vertices
  double distance = std::numeric_limits<double>::infinity();  ///< mm, >= 0
  double side = 1;  ///< +1 outside, -1 inside, by the angle-weighted pseudonormal (Baerentzen, Aanaes 2005)
};

struct RayHit {
  int triangle = -1;
  double distance = 0;  ///< mm along the unit direction
  Vector3d point = Vector3d::Zero();
};

/// Exact point-to-triangle queries and ray casts by a bounding-volume tree. Immutable; any number of threads
/// may ask.
class TriangleTree {
 public:
  /// Throws InputError if the surface has no triangles.
  explicit TriangleTree(const Surface& surface);

  [[nodiscard]] ClosestPlace closest(const Vector3d& query,
                                     double bound = std::numeric_limits<double>::infinity()) const;
  /// The same but for `side`, which stays 1: the first of these does not wait for the pseudonormals.
  [[nodiscard]] ClosestPlace closestAnySide(const Vector3d& query,
                                            double bound = std::numeric_limits<double>::infinity()) const;
  /// First hit of the ray from `origin` along `direction` (any length > 0), from either side.
  [[nodiscard]] std::optional<RayHit> cast(const Vector3d& origin, const Vector3d& direction) const;
  [[nodiscard]] int vertexOf(int triangle, int corner) const;
  [[nodiscard]] Vector3d triangleNormal(int triangle) const;  ///< unit, outward

 private:
  struct Tree;
  struct Found;
  [[nodiscard]] Found find(const Vector3d& query, double bound) const;

  std::shared_ptr<const Tree> tree_;
};

}  // namespace falciform
