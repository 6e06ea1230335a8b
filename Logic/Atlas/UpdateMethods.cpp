#include "Logic/Atlas/UpdateMethods.h"

#include <cstdio>

#include "Logic/Atlas/ClosestAtlas.h"
#include "Logic/Atlas/ControlPoints.h"
#include "Logic/Biomechanics/BoundaryFaces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {
namespace {

using Model = std::variant<UpdateModel, AtlasModel, IncrementalModel>;

[[noreturn]] void refuse(UpdateMethod method, const std::string& found) {
  const std::string name = enumToString(method);
  if (!needsDeformations(method))
    throw InputError("the method '" + name + "' works with surface loads, not with " + found +
                     "; leave the atlas out, build one of surface-loads, or name another method");
  throw InputError("the method '" + name + "' needs an atlas of deformations, and was given " + found +
                   "; build one (falciform atlas build thesis-packing) and give it as --atlas");
}

std::shared_ptr<const Model> modelOf(UpdateMethod method, const Surface& preop, const UpdateBasis& basis,
                                     const Progress& progress) {
  const auto* atlas = std::get_if<std::shared_ptr<const Atlas>>(&basis);
  const auto* loads = std::get_if<std::shared_ptr<const LoadResponses>>(&basis);
  const TetrahedralMesh& mesh = meshOf(basis);
  if (method == UpdateMethod::Incremental)
    return std::make_shared<const Model>(std::in_place_type<IncrementalModel>, preop, mesh, progress);
  if (needsDeformations(method)) {
    if (atlas == nullptr) refuse(method, loads != nullptr ? "one of surface loads" : "none");
    return std::make_shared<const Model>(std::in_place_type<AtlasModel>, preop, *atlas);
  }
  if (atlas != nullptr) refuse(method, "an atlas of deformations");
  if (method == UpdateMethod::Libr)
    return std::make_shared<const Model>(
        std::in_place_type<AtlasModel>, preop,
        loads != nullptr ? controlPointModes(**loads) : controlPointModes(mesh, {}, progress));
  return std::make_shared<const Model>(
      std::in_place_type<UpdateModel>, preop,
      loads != nullptr ? **loads : solveSurfaceLoads(mesh, {Material{}}, {}, progress));
}

ClosestAtlasPlan planOf(UpdateMethod method) {
  switch (method) {
    case UpdateMethod::IcatStar:
      return icatStarPlan();
    case UpdateMethod::Constrained:
      return constrainedPlan();
    case UpdateMethod::Pca:
      return pcaPlan();
    default:
      return icatPlan();
  }
}

/// Mean distance from `points` to the nearest of `others`, mm.
double meanDistance(const Points& points, const Points& others) {
  const KdTree tree(others);
  double sum = 0;
  for (Index i = 0; i < points.rows(); ++i)
    sum += std::sqrt(tree.nearest(points.row(i).transpose()).squaredDistance);
  return sum / static_cast<double>(points.rows());
}

}  // namespace

const TetrahedralMesh& meshOf(const UpdateBasis& basis) {
  if (const auto* atlas = std::get_if<std::shared_ptr<const Atlas>>(&basis)) return (*atlas)->mesh;
  if (const auto* loads = std::get_if<std::shared_ptr<const LoadResponses>>(&basis)) return (*loads)->mesh;
  return *std::get<std::shared_ptr<const TetrahedralMesh>>(basis);
}

bool needsDeformations(UpdateMethod method) {
  using enum UpdateMethod;
  return method == Icat || method == IcatStar || method == Constrained || method == Pca;
}

void checkSameLiver(const TetrahedralMesh& mesh, const Surface& preop) {
  if (mesh.frame != preop.frame)
    throw InputError("the atlas is in frame " + mesh.frame + ", the pre-op surface in " + preop.frame +
                     "; bring both into one frame");
  // Nodes of the mesh's boundary lie within a fraction of an edge of the surface it was made of, and are
  // as far apart as its edges are long: the surface is seen to be another one where the mean is beyond.
  const BoundarySurface boundary = boundarySurface(mesh, boundaryFaces(mesh));
  const double edge = meanEdgeLength(boundary.surface);
  const double reach = edge / 2 + meanEdgeLength(preop);
  const double there = meanDistance(boundary.surface.points, preop.points),
               back = meanDistance(preop.points, boundary.surface.points);
  if (there <= reach && back <= reach) return;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "the atlas belongs to another liver: its mesh lies %.0f mm from the pre-op surface on average; "
      "build an atlas of this surface",
      std::max(there, back));
  throw InputError(text);
}

PreparedUpdate::PreparedUpdate(UpdateMethod method, const Surface& preop, const UpdateBasis& basis,
                               const Progress& progress)
    : method_(method) {
  checkSurface(preop, "the pre-operative surface");
  checkSameLiver(meshOf(basis), preop);
  model_ = modelOf(method, preop, basis, progress);
}

const TetrahedralMesh& PreparedUpdate::mesh() const {
  if (const auto* atlas = std::get_if<AtlasModel>(model_.get())) return atlas->atlas().mesh;
  if (const auto* held = std::get_if<IncrementalModel>(model_.get())) return held->mesh();
  return std::get<UpdateModel>(*model_).responses().mesh;
}

const UpdateModel* PreparedUpdate::model() const { return std::get_if<UpdateModel>(model_.get()); }

UpdateResult updateByMethod(const PreparedUpdate& prepared, const Surface& scan,
                            const Isometry3d& scanFromPreopStart, const UpdateSettings& settings,
                            std::uint64_t seed, const Progress& progress) {
  const Model& model = *prepared.model_;
  if (const auto* held = std::get_if<IncrementalModel>(&model))
    return updateIncrementally(*held, scan, scanFromPreopStart, {}, settings, seed, progress);
  if (const auto* atlas = std::get_if<AtlasModel>(&model)) {
    if (prepared.method_ == UpdateMethod::Libr)
      return updateByControlPoints(*atlas, scan, scanFromPreopStart, {}, settings, seed, progress);
    return updateByClosestAtlas(*atlas, scan, scanFromPreopStart, planOf(prepared.method_), settings, seed,
                                progress);
  }
  return updateModel(*prepared.model(), scan, scanFromPreopStart, settings, seed, progress);
}

}  // namespace falciform
