#include "Logic/Atlas/ModeCompression.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

constexpr std::size_t kChunk = 4096;      // rows of a tall matrix
constexpr double kRoundingShare = 1e-14;  // of the largest squared singular value: below it is rounding

/// Fields as columns: node 0's x, y, z, then node 1's.
Eigen::MatrixXd asColumns(const std::vector<Points>& fields, Index rows) {
  Eigen::MatrixXd columns(rows, static_cast<Index>(fields.size()));
  for (std::size_t k = 0; k < fields.size(); ++k)
    columns.col(static_cast<Index>(k)) = Eigen::Map<const VectorXd>(fields[k].data(), rows);
  return columns;
}

/// A' W A for a tall A; chunk by chunk, added up in their order.
Eigen::MatrixXd weightedGram(const Eigen::MatrixXd& tall, const VectorXd& weights) {
  const auto rows = static_cast<std::size_t>(tall.rows());
  std::vector<Eigen::MatrixXd> parts((rows + kChunk - 1) / kChunk);
  forEachChunk(rows, kChunk, [&](std::size_t first, std::size_t last) {
    const auto from = static_cast<Index>(first), count = static_cast<Index>(last - first);
    const Eigen::MatrixXd part =
        weights.segment(from, count).cwiseSqrt().asDiagonal() * tall.middleRows(from, count);
    parts[first / kChunk] = transposedProduct(part, part);
  });
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(tall.cols(), tall.cols());
  for (const Eigen::MatrixXd& part : parts) sum += part;
  return (sum + sum.transpose()) / 2;
}

Eigen::MatrixXd tallProduct(const Eigen::MatrixXd& tall, const Eigen::MatrixXd& small) {
  Eigen::MatrixXd result(tall.rows(), small.cols());
  forEachChunk(static_cast<std::size_t>(tall.rows()), kChunk, [&](std::size_t first, std::size_t last) {
    const auto from = static_cast<Index>(first), count = static_cast<Index>(last - first);
    result.middleRows(from, count) = product(tall.middleRows(from, count), small);
  });
  return result;
}

/// Eigenvalues descending, 0 where rounding made them negative, and their vectors.
struct Spectrum {
  VectorXd values;
  Eigen::MatrixXd vectors;
};

Spectrum spectrumOf(const Eigen::MatrixXd& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  return {.values = solver.eigenvalues().reverse().cwiseMax(0.0),
          .vectors = solver.eigenvectors().rowwise().reverse()};
}

Index rankFor(const VectorXd& squares, double energy) {
  const double total = squares.sum();
  double held = 0;
  Index rank = 0;
  while (rank < squares.size() && held < energy * total && squares[rank] > kRoundingShare * squares[0])
    held += squares[rank++];
  return rank;
}

}  // namespace

CompressedFields compressFields(const std::vector<Points>& fields, const Eigen::MatrixXd& combinations,
                                const VectorXd& nodeVolumes, double energy) {
  CompressedFields result;
  if (fields.empty()) {
    result.coefficients = Eigen::MatrixXd::Zero(combinations.rows(), 0);
    result.errorsMm = VectorXd::Zero(combinations.rows());
    return result;
  }
  keepBlasSingleThreaded();
  const Index rows = 3 * nodeVolumes.size(), members = combinations.rows();
  VectorXd weights(rows);
  for (Index n = 0; n < nodeVolumes.size(); ++n)
    weights.segment<3>(3 * n).setConstant(nodeVolumes[n] / nodeVolumes.sum());
  const Eigen::MatrixXd tall = asColumns(fields, rows);
  // With S the fields, C the combinations and S'WS = V L V': the members' singular values are those of
  // L^(1/2) V' C', whose squares are the eigenvalues of H (C'C) H' with H = L^(1/2) V'.
  const Spectrum inner = spectrumOf(weightedGram(tall, weights));
  const Eigen::MatrixXd half = inner.values.cwiseSqrt().asDiagonal() * inner.vectors.transpose();
  const Eigen::MatrixXd shared = transposedProduct(combinations, combinations);
  const Eigen::MatrixXd sharedHalf = product(shared, half.transpose());
  const Eigen::MatrixXd between = product(half, sharedHalf);
  const Spectrum outer = spectrumOf((between + between.transpose()) / 2);
  const Index rank = rankFor(outer.values, energy);

  result.singularValuesMm = outer.values.cwiseSqrt();
  const double total = outer.values.sum();
  result.energy = total > 0 ? outer.values.head(rank).sum() / total : 1;
  const Eigen::MatrixXd leading = outer.vectors.leftCols(rank);
  Eigen::MatrixXd modes =
      tallProduct(tall, product(sharedHalf, leading) * outer.values.head(rank).cwiseInverse().asDiagonal());
  Eigen::MatrixXd coordinates = product(combinations, product(half.transpose(), leading));
  // Small modes come out orthonormal only to rounding times the ratio of squares; once more, to rounding.
  const Eigen::MatrixXd factor = weightedGram(modes, weights).llt().matrixU();
  modes =
      tallProduct(modes, factor.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(rank, rank)));
  coordinates = coordinates * factor.transpose();
  for (Index k = 0; k < rank; ++k) {
    Index largest = 0;
    coordinates.col(k).cwiseAbs().maxCoeff(&largest);
    if (coordinates(largest, k) >= 0) continue;
    coordinates.col(k) *= -1;
    modes.col(k) *= -1;
  }
  result.coefficients = coordinates;
  for (Index k = 0; k < rank; ++k)
    result.modes.emplace_back(Eigen::Map<const Points>(modes.col(k).data(), nodeVolumes.size(), 3));
  // What is left of member m lies along the directions that were not kept.
  const Eigen::MatrixXd dropped =
      product(combinations, product(half.transpose(), outer.vectors.rightCols(outer.values.size() - rank)));
  result.errorsMm =
      dropped.cols() > 0 ? VectorXd(dropped.rowwise().norm()) : VectorXd(VectorXd::Zero(members));
  return result;
}

Points fieldOf(const std::vector<Points>& modes, const Eigen::RowVectorXd& coefficients) {
  Points field = modes.empty() ? Points(0, 3) : Points(coefficients[0] * modes[0]);
  for (Index k = 1; k < coefficients.size(); ++k)
    field += coefficients[k] * modes[static_cast<std::size_t>(k)];
  return field;
}

}  // namespace falciform
