#pragma once
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// Which points around a place make its curvature, and how.
struct CurvatureSettings {
  int neighbours = 15;      ///< at least so many: whole rings of a mesh, or the nearest of a cloud
  double radiusMm = 0;      ///< all within this distance, if they are more; 0: by their number alone
  bool linearTerms = true;  ///< false: the thesis's fit, level at the point, of exactly `neighbours` nearest
  double largestLean = 1;   ///< no value where the middle of the points around lies farther aside than this
                           ///< share of their reach: at a straight border it is 0.42, where noise counts most
};

template <class Visitor>
void describe(CurvatureSettings& s, Visitor&& field) {
  field(FieldInfo{"curvatureNeighbours", "Curvature neighbours", "", 3, 1000,
                  "At least so many points around a place make its curvature."},
        s.neighbours);
  field(FieldInfo{"curvatureRadiusMm", "Curvature radius", "mm", 0, 50,
                  "All points within this distance make the curvature of a place; 0: by their number."},
        s.radiusMm);
  field(FieldInfo{"curvatureLinearTerms", "Linear terms", "", 0, 1,
                  "Fit the slope too; off: the thesis's fit, level at the point, of the nearest points."},
        s.linearTerms);
  field(FieldInfo{"curvatureLargestLean", "Largest lean", "", 0, 1,
                  "No value where the points around lie to one side by more than this share of their reach."},
        s.largestLean);
}

/// The thesis's: four neighbours, no linear terms, H = a + c (thesis Eq. (IV.2) to (IV.4)).
[[nodiscard]] CurvatureSettings thesisCurvature();

/// Curvature at every point of a surface, 1/mm. Positive where the surface is convex seen along its outward
/// normal: 1/r all over a sphere of radius r. NaN, in all of them, where the points around do not tell it.
struct Curvatures {
  VectorXd mean;                  ///< N: (k1 + k2) / 2
  VectorXd k1, k2;                ///< N: principal curvatures, k1 >= k2
  Points direction1, direction2;  ///< N x 3, unit, in the tangent plane, at right angles; sign arbitrary
};

/// Mean curvature alone, N values, 1/mm (thesis ch. IV; METHODS 3.2). A quadric is fitted by least squares to
/// the points around each place, over its tangent plane, and the exact curvature of that graph taken at the
/// place. On a mesh the points around are those joined to it by edges, and outwards is where the triangles
/// face. On a cloud they are the nearest ones that face the same way, and outwards is along its normals:
/// throws InputError for a cloud without normals, which has no outside. Results do not depend on threads.
[[nodiscard]] VectorXd meanCurvature(const Surface& surface, const CurvatureSettings& settings = {});

/// The same with principal curvatures and their directions.
[[nodiscard]] Curvatures principalCurvatures(const Surface& surface, const CurvatureSettings& settings = {});

inline constexpr char kMeanCurvature[] = "mean_curvature_per_mm";

}  // namespace falciform
