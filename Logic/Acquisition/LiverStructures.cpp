#include "Logic/Acquisition/LiverStructures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace falciform {
namespace {

constexpr double kCover = 1.5;  // mm of parenchyma left over every structure

/// A node as in the nominal liver of 210 x 150 x 160 mm.
struct NominalNode {
  const char* name;
  int parent;
  double x, y, z, radius;
};

constexpr NominalNode kPortalVein[] = {
    {"portal trunk", -1, -20, 10, 20, 6},
    {"portal bifurcation", 0, -32, 4, 26, 5.5},
    {"right portal vein", 1, -54, 6, 22, 5},
    {"right anterior portal vein", 2, -74, -12, 26, 4},
    {"portal branch VIII", 3, -80, -14, 54, 2.5},
    {"portal branch V", 3, -84, -36, -6, 2.5},
    {"right posterior portal vein", 2, -84, 20, 10, 4},
    {"portal branch VII", 6, -92, 32, 38, 2.4},
    {"portal branch VI", 6, -110, 16, -26, 2.4},
    {"left portal vein", 1, -8, -6, 26, 4.5},
    {"umbilical portion", 9, 3, -28, 24, 3.8},
    {"portal branch II", 10, 34, -12, 30, 2.2},
    {"portal branch III", 10, 32, -38, 24, 2.2},
    {"portal branch IV", 10, -22, -46, 20, 2.4},
};

constexpr NominalNode kHepaticVein[] = {
    {"hepatic vein confluence", -1, -20, 32, 48, 5.5},
    {"right hepatic vein", 0, -50, 26, 43, 4.8},
    {"right hepatic vein, middle", 1, -78, 12, 28, 3.6},
    {"right hepatic vein, end", 2, -100, -6, 0, 2.4},
    {"middle hepatic vein", 0, -30, 10, 47, 4.4},
    {"middle hepatic vein, fork", 4, -42, -18, 38, 3.8},
    {"middle hepatic vein, V", 5, -56, -42, 12, 2.4},
    {"middle hepatic vein, IV", 5, -32, -46, 34, 2.2},
    {"left hepatic vein", 0, 2, 8, 48, 3.8},
    {"left hepatic vein, middle", 8, 24, -10, 45, 2.8},
    {"left hepatic vein, end", 9, 44, -22, 42, 2.2},
};

struct NominalPoint {
  const char* name;
  double x, y, z;
};
constexpr NominalPoint kSegments[] = {
    {"segment I", -8, 26, 28},     {"segment II", 46, -6, 36},     {"segment III", 36, -44, 26},
    {"segment IV", -24, -40, 36},  {"segment V", -68, -44, -16},   {"segment VI", -112, 4, -36},
    {"segment VII", -104, 32, 26}, {"segment VIII", -72, -10, 60},
};

/// The middle of the right lobe, deep under every surface.
Vector3d core(const LiverShape& shape) { return shape.place(-62, 2, 24); }

/// The place nearest `wanted` on the line from `from`, which is inside, so that the stretch between keeps
/// `depth` mm below.
Vector3d pulledInside(const LiverShape& shape, const Vector3d& from, const Vector3d& wanted, double depth) {
  constexpr int kSamples = 24;
  double share = 0;
  for (int n = 1; n <= kSamples; ++n) {
    const double t = static_cast<double>(n) / kSamples;
    if (shape.distance(from + t * (wanted - from)) > -depth) break;
    share = t;
  }
  return from + share * (wanted - from);
}

template <std::size_t N>
VesselTree placeTree(const LiverShape& shape, const NominalNode (&nominal)[N]) {
  VesselTree tree;
  for (const NominalNode& node : nominal) {
    const Vector3d from =
        node.parent < 0 ? core(shape) : tree.nodes[static_cast<std::size_t>(node.parent)].position;
    const double thickest =
        node.parent < 0 ? node.radius : tree.nodes[static_cast<std::size_t>(node.parent)].radius;
    // The union's blend (1/6 of 3 mm) swells the joints.
    const double depth =
        std::max(node.radius, node.parent < 0 ? node.radius : 0.5 * (node.radius + thickest)) + kCover + 1.0;
    tree.nodes.push_back({node.name, node.parent,
                          pulledInside(shape, from, shape.place(node.x, node.y, node.z), depth),
                          node.radius});
  }
  return tree;
}

/// Whether all of the ellipsoid keeps its cover, by directions spread evenly over the sphere.
bool covered(const LiverShape& shape, const Ellipsoid& e) {
  constexpr int kDirections = 128;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int n = 0; n < kDirections; ++n) {
    const double z = 1 - (2.0 * n + 1) / kDirections, r = std::sqrt(1 - z * z);
    const Vector3d direction(r * std::cos(golden * n), r * std::sin(golden * n), z);
    if (shape.distance(e.centre + e.radii.cwiseProduct(direction)) > -kCover - 0.5) return false;
  }
  return true;
}

Ellipsoid placeTumour(const LiverShape& shape, const Vector3d& centre, const Vector3d& radii) {
  Ellipsoid e{centre, radii};
  for (int n = 0; n <= 20 && !covered(shape, e); ++n) {
    const double t = n / 20.0;
    e = {centre + t * (core(shape) - centre), radii * (1 - 0.5 * t)};
  }
  return e;
}

}  // namespace

double VesselTree::distance(const Vector3d& p) const {
  constexpr double kBlend = 3;  // mm
  double d = 1e9;
  for (const Node& node : nodes) {
    if (node.parent < 0) continue;
    const Node& parent = nodes[static_cast<std::size_t>(node.parent)];
    const double next =
        TaperedCapsule{parent.position, node.position, parent.radius, node.radius}.distance(p);
    d = smoothUnion(d, next, kBlend);
  }
  return d;
}

Box VesselTree::box() const {
  Box box;
  box.row(0).setConstant(1e9);
  box.row(1).setConstant(-1e9);
  for (const Node& node : nodes) {
    const double reach = node.radius + 5;
    box.row(0) = box.row(0).cwiseMin((node.position.array() - reach).matrix().transpose());
    box.row(1) = box.row(1).cwiseMax((node.position.array() + reach).matrix().transpose());
  }
  return box;
}

LiverStructures placeStructures(const LiverShape& shape) {
  return {.tumours = {placeTumour(shape, shape.place(-104, -14, 20), {13, 11, 14}),
                      placeTumour(shape, shape.place(-8, -44, 40), {9, 8, 10})},
          .portalVein = placeTree(shape, kPortalVein),
          .hepaticVein = placeTree(shape, kHepaticVein)};
}

Landmarks insideTargets(const LiverShape& shape, const LiverStructures& structures) {
  Landmarks targets;
  for (std::size_t n = 0; n < structures.tumours.size(); ++n)
    targets.points.push_back({"tumour " + std::to_string(n + 1), structures.tumours[n].centre});
  for (const VesselTree* tree : {&structures.portalVein, &structures.hepaticVein})
    for (const VesselTree::Node& node : tree->nodes) targets.points.push_back({node.name, node.position});
  for (const NominalPoint& s : kSegments)
    targets.points.push_back({s.name, pulledInside(shape, core(shape), shape.place(s.x, s.y, s.z), 5)});
  return targets;
}

}  // namespace falciform
