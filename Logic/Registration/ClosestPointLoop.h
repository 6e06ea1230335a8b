#pragma once
#include <functional>

#include "Logic/Geometry/TriangleTree.h"
#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"

namespace falciform {

/// Fills row i of `matched` with the pre-op counterpart of row i of `moved`, both N x 3 in pre-op mm.
using MatchPoints = std::function<void(const Points& moved, Points& matched)>;

/// The loop of Besl and McKay with any rule of matching: match, fit in closed form, until nothing moves (or
/// the RMS settles: `settings.stop`). Robust weights as in runPatchIcp; patches are not looked at.
[[nodiscard]] PatchIcpResult runClosestPointLoop(const Points& scan, const MatchPoints& match,
                                                 const RegistrationSettings& settings,
                                                 const Isometry3d& preopFromScanStart,
                                                 const Progress& progress = {},
                                                 const IterationObserver& observer = {});

/// Closest place on the pre-op surface's triangles, or among its points where it has none. The prepared side
/// must outlive it.
class ClosestOnPreop {
 public:
  explicit ClosestOnPreop(const PreparedPreop& preop);
  /// Nothing if no place lies within `boundMm`.
  [[nodiscard]] std::optional<Vector3d> closest(
      const Vector3d& query, double boundMm = std::numeric_limits<double>::infinity()) const;
  /// For each row of `queries`, in parallel.
  void closest(const Points& queries, Points& places) const;

 private:
  const LabelledTarget& points_;
  std::optional<TriangleTree> triangles_;
};

/// Welsch weights exp(-d^2 / 2 s^2) of N distances, s = the scale of the settings but at least 3 medians;
/// ones if the settings ask for none.
[[nodiscard]] VectorXd robustWeights(const VectorXd& distances, const RegistrationSettings& settings);

/// How far the point of `points` that moves farthest lies apart under two poses, at most, mm.
[[nodiscard]] double largestMotion(const Points& points, const Isometry3d& a, const Isometry3d& b);

/// Stores `record`, tells the observer, and the progress if a Stop may throw there.
void noteIteration(PatchIcpResult& result, const IterationRecord& record, double fraction,
                   const Progress& progress, const IterationObserver& observer);

}  // namespace falciform
