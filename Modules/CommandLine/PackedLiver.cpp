#include "Modules/CommandLine/PackedLiver.h"

#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/CorotationalWarp.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Biomechanics/SupportTemplates.h"
#include "Logic/Core/LandmarkPairs.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::commandline {
namespace {

/// Carries places along with the mesh.
class Carrier {
 public:
  Carrier(const TetrahedralMesh& mesh, Points displacements)
      : locator_(mesh), displacements_(std::move(displacements)) {}

  void move(Points& points) const {
    points += Points(MeshPlaces(locator_, points).interpolate(displacements_));
  }
  void move(Surface& surface) const {
    move(surface.points);
    if (surface.normals.rows() > 0) surface.normals = vertexNormals(surface);
  }
  void move(Landmarks& landmarks) const {
    Points places = positionsOf(landmarks);
    move(places);
    for (Index i = 0; i < places.rows(); ++i)
      landmarks.points[static_cast<std::size_t>(i)].position = places.row(i).transpose();
  }

 private:
  MeshLocator locator_;
  Points displacements_;
};

}  // namespace

SyntheticLiver packLiver(const SyntheticLiver& liver, const PackingSettings& settings,
                         const Progress& progress) {
  MeshSettings meshing;
  meshing.edgeLengthMm = settings.packedEdgeLengthMm;
  const TetrahedralMesh mesh = meshLiver(liver.surface, {}, meshing, progress.part(0, 0.3)).mesh;
  const BoundaryFaces faces = boundaryFaces(mesh);
  const std::vector<Support> supports = leftLobePacked(findSupportSites(liver.surface, mesh, faces),
                                                       settings.packingMm, settings.packedExtentMm);
  const std::vector<NodeConstraint> constraints =
      nodeConstraints(faces, nodeNormals(faces, mesh.nodes()), supports);
  std::vector<int> anchors;
  for (const NodeConstraint& constraint : constraints)
    if (constraint.count == 3) anchors.push_back(constraint.node);
  const ConstrainedStiffness solver(assembleStiffness(mesh, {Material{}}), constraints,
                                    progress.part(0.3, 0.9));
  const Points linear = solver.solve(Points::Zero(mesh.nodes(), 3));
  const Carrier carrier(mesh, CorotationalWarp(mesh, anchors).apply(linear));
  SyntheticLiver packed = liver;
  carrier.move(packed.surface);
  for (auto& [name, structure] : packed.structures) carrier.move(structure);
  carrier.move(packed.targets);
  carrier.move(packed.anatomical);
  progress.report(1);
  return packed;
}

}  // namespace falciform::commandline
