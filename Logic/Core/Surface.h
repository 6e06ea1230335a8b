#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Logic/Core/ColourImage.h"
#include "Logic/Core/Types.h"

namespace falciform {

/// Labels of the `Patch` point array: the features that a clinician paints on surface and scan.
namespace patch {
inline constexpr int kNone = 0;
inline constexpr int kFalciform = 1;
inline constexpr int kInferiorRidge = 2;
inline constexpr int kFirstNamed = 3;  ///< 3 and up are named by the user
inline constexpr int kMax = 255;
}  // namespace patch

/// A triangle surface or, with no triangles, a point cloud. Scans are Surfaces too, with or without
/// triangles.
struct Surface {
  Points points;                               ///< N x 3, mm, in `frame`
  Triangles triangles;                         ///< M x 3; 0 rows for a cloud
  std::vector<int> patch;                      ///< N labels, or empty when nothing is painted
  Points normals;                              ///< N x 3 unit vectors, or 0 rows
  Colours colours;                             ///< N x 3, or 0 rows
  TexturePlaces textureAt;                     ///< N x 2 places in `texture`, or 0 rows
  std::shared_ptr<const ColourImage> texture;  ///< the scanner's photograph; nullptr: none
  std::map<std::string, VectorXd>
      arrays;  ///< analysis arrays of N values, unit in the name: "signed_distance_mm"
  std::map<int, std::string> patchNames;  ///< names of labels from 3 up
  std::string frame = "LPS";  ///< "LPS" (patient) or the name of a scanner's or tracker's own frame

  [[nodiscard]] Index size() const { return points.rows(); }
  [[nodiscard]] int patchAt(Index i) const {
    return patch.empty() ? patch::kNone : patch[static_cast<std::size_t>(i)];
  }
};

/// "falciform", "inferior ridge", the user's name, or "patch N".
[[nodiscard]] std::string patchName(const Surface& surface, int label);

/// Points with the given label, in order of index.
[[nodiscard]] std::vector<int> pointsOfPatch(const Surface& surface, int label);

/// Labels above 0 that occur, ascending.
[[nodiscard]] std::vector<int> patchLabels(const Surface& surface);

/// The surface with points moved and normals turned by `targetFromSource`, in frame `frame`; all else as it
/// was.
[[nodiscard]] Surface transformed(const Surface& surface, const Isometry3d& targetFromSource,
                                  const std::string& frame);

/// N x 3 points moved by `targetFromSource`.
[[nodiscard]] Points transformed(const Points& points, const Isometry3d& targetFromSource);

/// Checks that every array has N rows, indices lie in range and coordinates are finite; throws InputError
/// that names `what` (a file or role) otherwise.
void checkSurface(const Surface& surface, const std::string& what);

}  // namespace falciform
