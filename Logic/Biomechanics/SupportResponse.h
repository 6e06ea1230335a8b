#pragma once
#include <memory>

#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/SupportModel.h"

namespace falciform {

/// The pre-operative surface as supports and gravity have moved it, and how far that is.
struct DeformedLiver {
  std::shared_ptr<const Surface> surface;  ///< preop's points moved, with the array kDisplacement
  double largestMm = 0;                    ///< of the surface's points
  DeformationCheck check;
};

/// How a liver on given supports answers to their distances and to gravity. Since the law is linear, one
/// solution for each pushed support and each direction of gravity holds them all: a slider then costs sums of
/// fields, no solution. Immutable; any number of threads may ask.
class SupportResponse {
 public:
  /// Solves for a push of 1 mm of each pushed support and for gravity along x and y (a turn of the patient
  /// has no other). Throws InputError for supports that do not hold the liver.
  SupportResponse(std::shared_ptr<const SupportModel> model, std::vector<Support> supports);

  /// `pushMm` of each support, in their order; those of supports that are not pushed are not looked at.
  [[nodiscard]] DeformedLiver at(const std::vector<double>& pushMm, double turnDeg) const;

  [[nodiscard]] const std::vector<Support>& supports() const { return supports_; }
  [[nodiscard]] const std::shared_ptr<const SupportModel>& model() const { return model_; }

 private:
  std::shared_ptr<const SupportModel> model_;
  std::vector<Support> supports_;
  std::vector<int> pushed_;       ///< numbers of the pushed supports
  std::vector<Points> fields_;    ///< at the mesh's nodes: one a pushed support, then gravity x and y, m/s2
  std::vector<Points> atPoints_;  ///< the same at preop's points
};

}  // namespace falciform
