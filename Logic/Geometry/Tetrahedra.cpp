#include "Logic/Geometry/Tetrahedra.h"

#include "Logic/Core/Errors.h"

#ifndef FALCIFORM_WITH_TETGEN

namespace falciform {

TetrahedralMesh tetrahedralise(const Surface& surface, double) {
  return tetrahedralise(surface, TetrahedraPlan{});
}

TetrahedralMesh tetrahedralise(const Surface&, const TetrahedraPlan&) {
  throw InputError(
      "this build is without TetGen, so it cannot fill a surface with tetrahedra; build with "
      "-DFALCIFORM_WITH_TETGEN=ON (Docs/Licences.md says what that means)");
}

}  // namespace falciform

#else

#include <tetgen.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {
namespace {

void checkClosed(const Surface& surface) {
  const TopologyReport report = inspectTopology(surface);
  if (!report.closedManifold() || report.unusedPoints > 0)
    throw InputError("tetrahedra need a closed surface, found " + describeTopology(report) +
                     "; close it first");
  if (signedVolume(surface) <= 0)
    throw InputError("the surface's triangles face inwards (its volume is " +
                     std::to_string(signedVolume(surface)) +
                     " mm3); turn them round before filling it with tetrahedra");
}

/// A place just inside `inner[which]` and not inside those that it may hold: half-way along the longest of
/// the ways inwards from its triangles to the next one.
Vector3d placeInside(const std::vector<Surface>& inner, std::size_t which) {
  std::vector<TriangleTree> trees;
  for (const Surface& surface : inner) trees.emplace_back(surface);
  const Triangles& triangles = inner[which].triangles;
  const Index step = std::max<Index>(1, triangles.rows() / 200);
  double longest = 0;
  Vector3d best = Vector3d::Zero();
  for (Index t = 0; t < triangles.rows(); t += step) {
    const Vector3d inwards = -trees[which].triangleNormal(static_cast<int>(t));
    const Vector3d middle =
        inner[which].points(triangles.row(t).transpose().eval(), Eigen::all).colwise().mean().transpose();
    const Vector3d start = middle + 1e-6 * inwards;  // mm: past the triangle itself
    double way = std::numeric_limits<double>::infinity();
    for (const TriangleTree& tree : trees)
      if (const auto hit = tree.cast(start, inwards)) way = std::min(way, hit->distance);
    if (!std::isfinite(way) || way <= longest) continue;
    longest = way;
    best = start + way / 2 * inwards;
  }
  return best;
}

/// TetGen's description of the surfaces: points, and one facet of one polygon a triangle. The vectors own
/// what `in` points to.
struct TetGenInput {
  tetgenio in;
  std::vector<tetgenio::facet> facets;
  std::vector<tetgenio::polygon> polygons;
  std::vector<int> corners;
  std::vector<double> coordinates, regions;

  TetGenInput(const Surface& surface, const TetrahedraPlan& plan) {
    add(surface);
    for (const Surface& inner : plan.inner) add(inner);
    coordinates.insert(coordinates.end(), plan.extra.data(), plan.extra.data() + plan.extra.size());
    for (std::size_t k = 0; k < plan.innerMaxVolumeMm3.size(); ++k) {
      if (plan.innerMaxVolumeMm3[k] <= 0) continue;
      const Vector3d place = placeInside(plan.inner, k);
      regions.insert(regions.end(), {place.x(), place.y(), place.z(), static_cast<double>(k + 1),
                                     plan.innerMaxVolumeMm3[k]});
    }
    polygons.resize(corners.size() / 3);
    facets.resize(polygons.size());
    for (std::size_t i = 0; i < facets.size(); ++i) {
      polygons[i] = {.vertexlist = corners.data() + 3 * i, .numberofvertices = 3};
      facets[i] = {
          .polygonlist = &polygons[i], .numberofpolygons = 1, .holelist = nullptr, .numberofholes = 0};
    }
    in.numberofpoints = static_cast<int>(coordinates.size() / 3);
    in.pointlist = coordinates.data();
    in.numberoffacets = static_cast<int>(facets.size());
    in.facetlist = facets.data();
    in.numberofregions = static_cast<int>(regions.size() / 5);
    in.regionlist = regions.empty() ? nullptr : regions.data();
  }
  TetGenInput(const TetGenInput&) = delete;
  TetGenInput& operator=(const TetGenInput&) = delete;
  ~TetGenInput() {  // tetgenio would delete[] what the vectors own
    in.pointlist = in.regionlist = nullptr;
    in.facetlist = nullptr;
    in.numberofpoints = in.numberoffacets = in.numberofregions = 0;
  }

 private:
  void add(const Surface& surface) {
    const int first = static_cast<int>(coordinates.size() / 3);
    coordinates.insert(coordinates.end(), surface.points.data(),
                       surface.points.data() + surface.points.size());
    for (Index i = 0; i < surface.triangles.size(); ++i)
      corners.push_back(surface.triangles.data()[i] + first);
  }
};

/// TetGen's own driver, tetrahedralize(), keeps its mesh on the stack, and an error thrown there frees the
/// mesh twice (1.5.0) and ends the program. So we call its steps ourselves, in its order for these switches.
void callSteps(tetgenbehavior& behaviour, tetgenio& in, tetgenio& out) {
  auto mesh = std::make_unique<tetgenmesh>();
  try {
    clock_t clock = 0;
    mesh->b = &behaviour;
    mesh->in = &in;
    mesh->initializepools();
    mesh->transfernodes();
    exactinit(0, 0, 0, mesh->xmax - mesh->xmin, mesh->ymax - mesh->ymin, mesh->zmax - mesh->zmin);
    mesh->incrementaldelaunay(clock);
    mesh->meshsurface();
    mesh->recoverboundary(clock);
    mesh->carveholes();
    if (mesh->subvertstack->objects > 0) mesh->suppresssteinerpoints();
    mesh->recoverdelaunay();
    mesh->delaunayrefinement();
    mesh->optimizemesh();
    if (mesh->dupverts > 0 || mesh->unuverts > 0) mesh->jettisonnodes();
    out.firstnumber = 0;
    mesh->outnodes(&out);
    mesh->outelements(&out);
  } catch (int) {
    ::operator delete(mesh.release());  // emptied by TetGen already; its destructor would do so again
    throw;
  }
}

/// TetGen throws ints: 1 is out of memory, 3 a self-intersection; the others have one remedy.
void runTetGen(TetGenInput& input, tetgenio& out, const TetrahedraPlan& plan) {
  // p: fill a boundary; q: radius-edge ratio and dihedral angle; Y: no new points on the boundary; Q: quiet;
  // a: largest volume, by region and in all.
  std::array<char, 100> text{};
  std::snprintf(text.data(), text.size(), "pq%.4f/%.3f%sYQ", plan.radiusEdgeRatio, plan.minDihedralDeg,
                input.regions.empty() ? "" : "a");
  std::string switches = text.data();
  if (plan.maxVolumeMm3 > 0) {
    std::snprintf(text.data(), text.size(), "a%.9f", plan.maxVolumeMm3);
    switches += text.data();
  }
  tetgenbehavior behaviour;
  if (!behaviour.parse_commandline(switches.data()))
    throw InputError("the largest tetrahedron is " + std::to_string(plan.maxVolumeMm3) +
                     " mm3, which TetGen cannot use; take 1e-3 or more");
  static std::mutex oneAtATime;  // the exact predicates' error bounds are global to TetGen
  const std::lock_guard lock(oneAtATime);
  try {
    callSteps(behaviour, input.in, out);
  } catch (int code) {
    if (code == 1) throw std::bad_alloc();
    throw InputError(
        code == 3
            ? std::string("the surface cuts through itself, so it cannot be filled with tetrahedra; smooth "
                          "or remesh it first")
            : "TetGen could not fill the surface (its code " + std::to_string(code) +
                  "); remesh it to even triangles first");
  }
}

TetrahedralMesh taken(const tetgenio& out) {
  TetrahedralMesh mesh;
  mesh.points = Eigen::Map<const Points>(out.pointlist, out.numberofpoints, 3);
  mesh.elements.resize(out.numberoftetrahedra, 4);
  for (Index t = 0; t < mesh.elements.rows(); ++t) {
    for (int k = 0; k < 4; ++k) mesh.elements(t, k) = out.tetrahedronlist[t * out.numberofcorners + k];
    if (cornerVolume(mesh, t) < 0) std::swap(mesh.elements(t, 2), mesh.elements(t, 3));
  }
  return mesh;
}

/// What TetGen promises and we rely on: the surface's points first and unmoved, its volume filled, no more
/// and no less.
void checkFilled(const TetrahedralMesh& mesh, const Surface& surface) {
  double sum = 0;
  for (Index t = 0; t < mesh.elements.rows(); ++t) sum += cornerVolume(mesh, t);
  const double wanted = signedVolume(surface);
  const bool kept =
      mesh.points.rows() >= surface.size() && mesh.points.topRows(surface.size()) == surface.points;
  if (!kept || std::abs(sum - wanted) > 1e-6 * wanted)
    throw InputError("the surface encloses " + std::to_string(wanted) + " mm3 but its tetrahedra fill " +
                     std::to_string(sum) +
                     " mm3; it may hold a second surface inside: keep its largest piece");
}

}  // namespace

TetrahedralMesh tetrahedralise(const Surface& surface, double maxVolumeMm3) {
  return tetrahedralise(surface, {.maxVolumeMm3 = maxVolumeMm3});
}

TetrahedralMesh tetrahedralise(const Surface& surface, const TetrahedraPlan& plan) {
  if (!(plan.maxVolumeMm3 >= 0) || !std::isfinite(plan.maxVolumeMm3))
    throw InputError("the largest tetrahedron is " + std::to_string(plan.maxVolumeMm3) +
                     " mm3; give a volume above 0, or 0 for no bound");
  checkSurface(surface, "the surface to fill");
  checkClosed(surface);
  for (const Surface& inner : plan.inner) {
    checkSurface(inner, "a surface inside the one to fill");
    checkClosed(inner);
  }
  TetGenInput input(surface, plan);
  tetgenio out;
  runTetGen(input, out, plan);
  const TetrahedralMesh mesh = taken(out);
  checkFilled(mesh, surface);
  return mesh;
}

}  // namespace falciform

#endif
