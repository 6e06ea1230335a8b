#pragma once
#include <memory>

#include "Logic/Biomechanics/BackSubstitution.h"
#include "Logic/Biomechanics/ReducedStiffness.h"

namespace falciform {

/// Where supports may be, by boundary faces: on `sliding` ones along the normal, on `fixed` ones wholly.
struct CandidateSupports {
  std::vector<int> sliding{}, fixed{};
  /// Supports that every hypothesis shares (Fixed and Sliding only): they are eliminated beforehand, which
  /// leaves the hypotheses small. Where candidates touch them, a hypothesis may override them.
  std::vector<Support> held{};
};

/// One guess at what holds and moves the liver: supports (springs excepted) and the change of gravity since
/// the CT.
struct SupportHypothesis {
  std::vector<Support> supports;
  Vector3d gravityChangeMPerS2 = Vector3d::Zero();
};

/// One factorisation for every hypothesis of supports (METHODS 4.3): the six rigid motions are pinned (unless
/// the supports held always do so), the candidate directions come last in the elimination, so that their
/// compliance C = B K+ B' falls out of the factor; a hypothesis is then a small dense system,
///   u = K+ (f - B' lambda) + R a,   [ C  -BR ; (BR)'  0 ] [lambda; a] = [ B K+ f - v ; R' f ],
/// and one back substitution for the displacements of all nodes.
class SupportSolver {
 public:
  /// Throws InputError for a damaged mesh or one in pieces, a damaged material, or candidates that are not
  /// there.
  SupportSolver(const TetrahedralMesh& mesh, const std::vector<Material>& materials,
                const CandidateSupports& candidates, const Progress& progress = {});

  /// Displacements in mm (N x 3) to single precision (about 1e-6 of the largest). Throws InputError for
  /// supports that do not hold the liver or lie outside the candidates.
  [[nodiscard]] Points solve(const SupportHypothesis& hypothesis) const;
  /// The same for many, sharing the passes over memory.
  [[nodiscard]] std::vector<Points> solve(const std::vector<SupportHypothesis>& hypotheses) const;

  [[nodiscard]] const BoundaryFaces& faces() const;
  [[nodiscard]] const NodeNormals& normals() const;
  [[nodiscard]] Index candidateDirections() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace falciform
