#pragma once
#include <string>
#include <vector>

#include "Logic/Acquisition/ImplicitSurface.h"
#include "Logic/Acquisition/LiverShape.h"

namespace falciform {

/// A branching vessel: the smooth union of tapered capsules from each node to its parent.
struct VesselTree {
  struct Node {
    std::string name;
    int parent = -1;  ///< -1: the stem's end
    Vector3d position = Vector3d::Zero();
    double radius = 1;  ///< mm
  };
  std::vector<Node> nodes;  ///< parents first
  [[nodiscard]] double distance(const Vector3d& p) const;
  [[nodiscard]] Box box() const;  ///< with some air
};

/// What lies inside the liver: the same for its surfaces, its label map and its targets.
struct LiverStructures {
  std::vector<Ellipsoid> tumours;
  VesselTree portalVein, hepaticVein;
};

/// Places the structures, moved inwards where the shape is too thin for them: every part at least 1.5 mm
/// below the surface.
[[nodiscard]] LiverStructures placeStructures(const LiverShape& shape);

/// Named points inside: tumour centres, the nodes of both trees, a middle point of each of the eight
/// segments.
[[nodiscard]] Landmarks insideTargets(const LiverShape& shape, const LiverStructures& structures);

}  // namespace falciform
