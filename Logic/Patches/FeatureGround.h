#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Surface.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

/// Where the patient's right, front and head are: unit rows, in the surface's frame.
struct AnatomicalAxes {
  Matrix3d rows = Matrix3d::Identity();
};
/// Of the world frame LPS: right is -x, front is -y, head is +z.
[[nodiscard]] AnatomicalAxes lpsAxes();
/// Of a frame whose x, y and z run towards these sides of the patient: "LPS", "RAS", "SAR", ... Throws
/// InputError unless the letters name each of R/L, A/P and S/I once.
[[nodiscard]] AnatomicalAxes axesFromLetters(const std::string& letters);

/// A liver's surface made ready for the search of its features: fine enough, with numbers for each vertex
/// that tell what a place looks like and where on the liver it lies, whatever the liver's size.
struct FeatureGround {
  Surface surface;  ///< the given one, subdivided where its edges are long; the old vertices come first
  AnatomicalAxes axes;
  Adjacency neighbours;  ///< by edges
  Points turned;         ///< N x 3, mm towards the patient's right, front and head
  Points standard;  ///< N x 3: right, front and head of the centroid, in standard deviations of each axis
  Vector3d spread = Vector3d::Ones();  ///< those standard deviations, mm
  double sizeMm = 1;                   ///< their geometric mean
  Eigen::MatrixXd descriptors;         ///< N x kDescriptors, about -3 to 3 each
};
inline constexpr int kDescriptors = 27;

/// Descriptors: the place (3) and its normal (3) along the axes; principal curvatures at 8 and 16 mm (4), how
/// far behind the outermost of its sagittal slice in four directions from foot to front (4); ridge peaks at
/// both scales and the valley peak (3); offset from the middle of the surface within 15 and 30 mm, the area
/// there over that of a disk, and the offset along the normal (5 each). Throws InputError for a surface
/// without triangles or with less than 200 vertices.
[[nodiscard]] FeatureGround featureGround(const Surface& surface, const AnatomicalAxes& axes = lpsAxes(),
                                          const Progress& progress = {});

}  // namespace falciform
