#pragma once
#include <memory>
#include <vector>

#include "Logic/Atlas/DeformedMesh.h"
#include "Logic/Atlas/FieldContinuation.h"

namespace falciform {

/// Where a place of the operating room is in the pre-operative CT.
struct PreopPlace {
  Vector3d preop = Vector3d::Zero();  ///< mm
  bool inside = false;                ///< in the liver's mesh, as bent
  int element = -1;                   ///< of the mesh, where inside
  double outsideMm = 0;               ///< else how far `preop` is from it, mm; filled by preopFromScan
  /// How far the answer's own image is from the place asked for, mm: rounding, but where the continuation
  /// folds over in a narrow cleft no place may fit better.
  double missMm = 0;
};

/// A model update as a map of all space, both ways. Three sets of coordinates: *pre-op*, as the CT saw it;
/// *bent*, the same frame with the liver bent and nothing moved rigidly; *scan* = scanFromPreop * bent.
/// In the mesh tissue follows its element's shape functions. Outside, within bandMm, the same field continued
/// linearly fades into a smooth one, and that one to nothing over the margin (FieldContinuation): beyond it
/// there is the rigid motion alone. Immutable; any number of threads may ask.
class UpdateMap {
 public:
  /// `displacements`: N x 3 mm at the mesh's nodes, rigid motion apart. Throws InputError as DeformedMesh
  /// does.
  UpdateMap(const TetrahedralMesh& mesh, const Points& displacements, const Isometry3d& scanFromPreop,
            const ContinuationPlan& plan = {});

  [[nodiscard]] const Isometry3d& scanFromPreop() const { return scanFromPreop_; }
  [[nodiscard]] const DeformedMesh& deformed() const { return deformed_; }
  [[nodiscard]] double marginMm() const { return continuation_.marginMm(); }

  [[nodiscard]] Vector3d bentFromPreop(const Vector3d& preop) const;
  /// The inverse. `guess`: the answer for a place nearby, which makes it quicker and, where the map is one to
  /// one, no different. Outside the mesh by Broyden's method to `toleranceMm`.
  [[nodiscard]] PreopPlace preopFromBent(const Vector3d& bent, const PreopPlace* guess = nullptr,
                                         double toleranceMm = 1e-9) const;

  /// K x 3 in, mm, K out. The same for any number of threads.
  [[nodiscard]] Points scanFromPreop(const Points& preop) const;
  [[nodiscard]] std::vector<PreopPlace> preopFromScan(const Points& scan) const;

 private:
  [[nodiscard]] PreopPlace invertOutside(const Vector3d& bent, const Vector3d& start,
                                         double toleranceMm) const;

  ContinuationPlan plan_;
  Isometry3d scanFromPreop_;
  MeshLocator locator_;
  DeformedMesh deformed_;
  FieldContinuation continuation_;
};

}  // namespace falciform
