#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// The colour of one tissue in CIE Lab: a normal distribution, never tighter than what light and camera do to
/// one and the same tissue.
class TissueModel {
 public:
  /// Of the rows `ids` of `lab`; the middle half of them decides, so that blood and highlights do not.
  TissueModel(const Points& lab, const std::vector<int>& ids);

  /// Standard deviations from the tissue's colour.
  [[nodiscard]] double distance(const Vector3d& lab) const;

 private:
  Vector3d mean_;
  Matrix3d precision_;
};

/// Whether a colour may be liver: red to brown, not pale, not grey.
[[nodiscard]] bool looksLikeLiver(const Vector3d& lab);

}  // namespace falciform
