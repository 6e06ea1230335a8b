#pragma once
#include <Eigen/Core>

namespace falciform {

/// Dense linear algebra by the BLAS and LAPACK that the system provides; Eigen's own kernels are an order
/// slower in a build for any processor. All matrices are column-major; "lower" reads and writes the lower
/// triangle only.

/// Keeps BLAS to the thread that calls it, from now on: its own threads would add up in another order for
/// each number of them, and our results must not depend on it. We run many calls at once instead.
void keepBlasSingleThreaded();

/// A = L L' in place (lower). False if A is not positive definite.
[[nodiscard]] bool choleskyInPlace(Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>> lower);
/// A X = B in place of B, from A's Cholesky factor.
void solveCholesky(const Eigen::MatrixXd& lower, Eigen::MatrixXd& rightHandSides);
/// A's inverse in place of its Cholesky factor, both triangles filled.
void invertCholesky(Eigen::MatrixXd& lower);
/// C = A B, or A' B.
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
[[nodiscard]] Eigen::MatrixXd transposedProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/// The two steps of a blocked back substitution, in single precision: y -= A' x and solve L' x = y, `columns`
/// right-hand sides at a time; `rows` x `width` matrices with leading dimension `stride`.
void subtractTransposed(int rows, int width, int columns, const float* a, int stride, const float* x,
                        int xStride, float* y, int yStride);
void solveTransposedLower(int width, int columns, const float* lower, int stride, float* y, int yStride);

}  // namespace falciform
