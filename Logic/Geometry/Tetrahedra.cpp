#include "Logic/Geometry/Tetrahedra.h"

#include "Logic/Core/Errors.h"

#ifndef FALCIFORM_WITH_TETGEN

namespace falciform {

TetrahedralMesh tetrahedralise(const Surface&, double) {
  throw InputError(
      "this build is without TetGen, so it cannot fill a surface with tetrahedra; build with "
      "-DFALCIFORM_WITH_TETGEN=ON (Docs/Licences.md says what that means)");
}

}  // namespace falciform

#else

#include <tetgen.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/Topology.h"

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

/// TetGen's description of the surface: points, and one facet of one polygon a triangle. `facets` and
/// `polygons` own what `in` points to, and must be taken out of it again before it dies: see fill().
struct TetGenInput {
  tetgenio in;
  std::vector<tetgenio::facet> facets;
  std::vector<tetgenio::polygon> polygons;
  std::vector<int> corners;
  std::vector<double> coordinates;

  explicit TetGenInput(const Surface& surface)
      : facets(static_cast<std::size_t>(surface.triangles.rows())),
        polygons(facets.size()),
        corners(surface.triangles.data(), surface.triangles.data() + surface.triangles.size()),
        coordinates(surface.points.data(), surface.points.data() + surface.points.size()) {
    for (std::size_t i = 0; i < facets.size(); ++i) {
      polygons[i] = {.vertexlist = corners.data() + 3 * i, .numberofvertices = 3};
      facets[i] = {
          .polygonlist = &polygons[i], .numberofpolygons = 1, .holelist = nullptr, .numberofholes = 0};
    }
    in.numberofpoints = static_cast<int>(surface.size());
    in.pointlist = coordinates.data();
    in.numberoffacets = static_cast<int>(facets.size());
    in.facetlist = facets.data();
  }
  TetGenInput(const TetGenInput&) = delete;
  TetGenInput& operator=(const TetGenInput&) = delete;
  ~TetGenInput() {  // tetgenio would delete[] what the vectors own
    in.pointlist = nullptr;
    in.facetlist = nullptr;
    in.numberofpoints = in.numberoffacets = 0;
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
void runTetGen(tetgenio& in, tetgenio& out, double maxVolumeMm3) {
  // p: fill a boundary; q: radius-edge ratio and dihedral angle; Y: no new points on the boundary; Q: quiet.
  std::string switches = "pq1.414/10YQ";
  if (maxVolumeMm3 > 0) {
    char bound[40];
    std::snprintf(bound, sizeof bound, "a%.9f", maxVolumeMm3);
    switches += bound;
  }
  tetgenbehavior behaviour;
  if (!behaviour.parse_commandline(switches.data()))
    throw InputError("the largest tetrahedron is " + std::to_string(maxVolumeMm3) +
                     " mm3, which TetGen cannot use; take 1e-3 or more");
  static std::mutex oneAtATime;  // the exact predicates' error bounds are global to TetGen
  const std::lock_guard lock(oneAtATime);
  try {
    callSteps(behaviour, in, out);
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
  if (!(maxVolumeMm3 >= 0) || !std::isfinite(maxVolumeMm3))
    throw InputError("the largest tetrahedron is " + std::to_string(maxVolumeMm3) +
                     " mm3; give a volume above 0, or 0 for no bound");
  checkSurface(surface, "the surface to fill");
  checkClosed(surface);
  TetGenInput input(surface);
  tetgenio out;
  runTetGen(input.in, out, maxVolumeMm3);
  const TetrahedralMesh mesh = taken(out);
  checkFilled(mesh, surface);
  return mesh;
}

}  // namespace falciform

#endif
