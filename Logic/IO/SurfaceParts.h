#pragma once
#include <span>
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

// What every surface reader of our own needs. Inside Logic/IO only.

/// Collects triangles; polygons are cut into fans from their first corner, triangles with a corner twice are
/// left out.
class TriangleCollector {
 public:
  TriangleCollector(Index points, std::string name) : points_(points), name_(std::move(name)) {}

  /// Throws InputError if an id lies outside [0, points).
  void addPolygon(std::span<const long long> ids);
  [[nodiscard]] Triangles triangles() const;

 private:
  Index points_;
  std::string name_;
  std::vector<int> ids_;
};

/// Collects where points lie in an image, corner by corner, as faces tell it.
class TextureCollector {
 public:
  void put(long long point, float u, float v);
  /// Fills textureAt and seam for `points` points: the place first met, not finite where there is none.
  /// Leaves both as they are if there was no place at all. Throws InputError for a point outside.
  void finish(Index points, const std::string& name, RawSurface& raw) const;

 private:
  struct Corner {
    long long point;
    float u, v;
  };
  std::vector<Corner> corners_;
};

/// Whole numbers in 0..255; throws InputError otherwise.
[[nodiscard]] std::vector<int> patchLabelsFrom(const VectorXd& values, const std::string& name);

/// Scaled to length 1; no rows if one is not finite. A zero normal stays zero.
[[nodiscard]] Points unitNormalsFrom(Points normals);

/// Values clamped to 0..255 and rounded.
[[nodiscard]] Colours coloursFrom(const Points& rgb);

/// "patch 3=gallbladder fossa" in a comment, as our writers put it.
void readPatchNameComment(std::string_view comment, Surface& surface);
[[nodiscard]] std::vector<std::string> patchNameComments(const Surface& surface);

}  // namespace falciform
