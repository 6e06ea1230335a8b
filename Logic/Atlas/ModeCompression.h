#pragma once
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Many displacement fields as sums of few modes, by the singular value decomposition in the inner product
/// <a, b> = sum over nodes of share_n a_n . b_n, the mean over the liver's volume: a field's length is its
/// root-mean-square displacement in mm.
struct CompressedFields {
  std::vector<Points> modes;     ///< rank x (N x 3): orthonormal, so of RMS 1 mm each at coefficient 1
  Eigen::MatrixXd coefficients;  ///< M x rank, mm: a field is about sum_k coefficients(m, k) modes[k]
  VectorXd singularValuesMm;     ///< all of them, descending, those beyond the rank included
  double energy = 1;             ///< share of the sum of their squares that the modes hold
  VectorXd errorsMm;             ///< M: RMS over the volume of what the modes leave of each field
};

/// Fields are the rows of `combinations` (M x K) of `fields` (K x (N x 3), mm). Keeps the fewest modes that
/// hold at least `energy` in (0, 1]; never more than the fields' rank. `nodeVolumes` (N) are the weights, in
/// any unit. By the K x K matrix of inner products, so that no M fields are ever formed. Each mode points the
/// way of its largest coefficient. Same bits for any number of threads.
[[nodiscard]] CompressedFields compressFields(const std::vector<Points>& fields,
                                              const Eigen::MatrixXd& combinations,
                                              const VectorXd& nodeVolumes, double energy);

/// The field of one row of coefficients: N x 3, mm.
[[nodiscard]] Points fieldOf(const std::vector<Points>& modes, const Eigen::RowVectorXd& coefficients);

}  // namespace falciform
