#include "Testing/Benchmarks/CgalPeer.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Neighbourhoods.h"

namespace falciform::bench {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Triangle>::const_iterator>;
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 pointOf(const Points& points, Index i) { return {points(i, 0), points(i, 1), points(i, 2)}; }

}  // namespace

struct CgalTree::Tree {
  std::vector<Triangle> triangles;
  Boxes boxes;
};

CgalTree::CgalTree(const Surface& mesh) : tree_(std::make_unique<Tree>()) {
  for (Index t = 0; t < mesh.triangles.rows(); ++t)
    tree_->triangles.emplace_back(pointOf(mesh.points, mesh.triangles(t, 0)),
                                  pointOf(mesh.points, mesh.triangles(t, 1)),
                                  pointOf(mesh.points, mesh.triangles(t, 2)));
  const std::vector<Triangle>& triangles = tree_->triangles;
  tree_->boxes.insert(triangles.begin(), triangles.end());
  tree_->boxes.build();
  tree_->boxes.accelerate_distance_queries();
}

CgalTree::~CgalTree() = default;

VectorXd CgalTree::distances(const Points& queries) const {
  VectorXd values(queries.rows());
  forEachChunk(static_cast<std::size_t>(queries.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      values[row] = std::sqrt(tree_->boxes.squared_distance(pointOf(queries, row)));
    }
  });
  return values;
}

VectorXd cgalJetCurvature(const Surface& surface) {
  using Jets = CGAL::Monge_via_jet_fitting<Kernel>;
  const Neighbourhoods around(surface, {});
  VectorXd values(surface.size());
  forEachChunk(static_cast<std::size_t>(surface.size()), 1024, [&](std::size_t begin, std::size_t end) {
    auto scratch = around.borrow();
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = begin; i < end; ++i) {
      const auto v = static_cast<int>(i);
      around.gather(v, *scratch);
      points.assign(1, pointOf(surface.points, v));
      for (const int other : scratch->found) points.push_back(pointOf(surface.points, other));
      Jets jets;
      Jets::Monge_form form = jets(points.begin(), points.end(), 2, 2);
      const Vector3d normal = around.normal(v);
      form.comply_wrt_given_normal({normal.x(), normal.y(), normal.z()});
      values[static_cast<Index>(i)] = -0.5 * (form.principal_curvatures(0) + form.principal_curvatures(1));
    }
    around.giveBack(std::move(scratch));
  });
  return values;
}

}  // namespace falciform::bench
