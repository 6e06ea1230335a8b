#pragma once
#include <memory>

#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// A liver held where it lies, factorised, ready to be drawn to scans: the pre-operative side of incremental
/// FEM. Immutable.
class IncrementalModel {
 public:
  /// `supports`: what holds the liver; `preop` the surface that the mesh fills. Throws InputError where they
  /// do not hold it.
  IncrementalModel(const Surface& preop, const TetrahedralMesh& mesh, std::vector<Support> supports,
                   const Progress& progress = {});
  /// Held as the thesis has it: fixed around the vena cava, sliding on the bed behind. Throws InputError
  /// where the surface is no liver in LPS.
  IncrementalModel(const Surface& preop, const TetrahedralMesh& mesh, const Progress& progress = {});

  [[nodiscard]] const Surface& preop() const { return preop_; }
  [[nodiscard]] const TetrahedralMesh& mesh() const { return mesh_; }
  [[nodiscard]] const PreparedPreop& rigid() const { return *rigid_; }
  [[nodiscard]] const Surface& fine() const { return fine_; }
  [[nodiscard]] const MeshPlaces& places() const { return places_; }  ///< of fine()'s points in the mesh
  /// Corner nodes of the surface that no support touches, and their outward normals.
  [[nodiscard]] const std::vector<int>& freeNodes() const { return freeNodes_; }
  [[nodiscard]] const Points& freeNormals() const { return freeNormals_; }

  /// 3 N x K: displacements of all nodes under a force of 1 N along the normal of each of `drawn`, numbers
  /// into freeNodes().
  [[nodiscard]] Eigen::MatrixXd underForces(const std::vector<int>& drawn) const;

 private:
  Surface preop_, fine_;
  TetrahedralMesh mesh_;
  std::shared_ptr<const PreparedPreop> rigid_;
  std::shared_ptr<const ConstrainedStiffness> solver_;
  MeshPlaces places_;
  std::vector<int> freeNodes_;
  Points freeNormals_;
};

struct IncrementalPlan {
  bool identifyUndeformed = true;  ///< begin with registerDirr; else from the pose as given
  double share = 0.5;              ///< of the remaining distance that one increment closes
  int maxIncrements = 30;
  double settledMm = 0.01;  ///< change of the mean distance along the normals by the last increment
};

/// Incremental FEM (Cash et al. 2005): the rigid pose that identifies what did not deform (registerDirr),
/// then surface nodes under the scan drawn along their normals towards it, a share of what is left each time,
/// closest points anew after each; traction-free along the surface and everywhere else. No covariance, no
/// coefficients. Throws InputError for fewer than 10 usable scan points, or a scan that is nowhere near the
/// liver.
[[nodiscard]] UpdateResult updateIncrementally(const IncrementalModel& model, const Surface& scan,
                                               const Isometry3d& scanFromPreopStart,
                                               const IncrementalPlan& plan = {},
                                               const UpdateSettings& settings = {}, std::uint64_t seed = 1,
                                               const Progress& progress = {});

}  // namespace falciform
