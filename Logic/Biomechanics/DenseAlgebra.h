#pragma once
#include <Eigen/Core>

namespace falciform {

using Eigen::Index;

/// Dense linear algebra by the BLAS and LAPACK that the system provides; Eigen's own kernels are an order
/// slower in a build for any processor. All matrices are column-major; "lower" reads and writes the lower
/// triangle only.

/// Keeps BLAS to the thread that calls it, from now on: its own threads would add up in another order for
/// each number of them, and our results must not depend on it. We run many calls at once instead.
void keepBlasSingleThreaded();

/// A = L L' in place (lower). False if A is not positive definite.
[[nodiscard]] bool choleskyInPlace(Eigen::MatrixXd& lower);
/// A X = B in place of B, from A's Cholesky factor.
void solveCholesky(const Eigen::MatrixXd& lower, Eigen::MatrixXd& rightHandSides);
/// A's inverse in place of its Cholesky factor, both triangles filled.
void invertCholesky(Eigen::MatrixXd& lower);
/// C = A B, or A' B.
[[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
[[nodiscard]] Eigen::MatrixXd transposedProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// A A', both triangles.
[[nodiscard]] Eigen::MatrixXd outerSquare(const Eigen::MatrixXd& a);

/// What a supernode of a sparse factor asks for: panels of `height` rows, their own `width` columns first,
/// the diagonal block's lower triangle on top. All matrices column-major with a leading dimension.

/// Factorises the panel in place, and takes the product of its rows below with themselves from `update`, the
/// lower triangle of a square matrix of height - width. `parallel`: in tiles by forEachChunk, with the same
/// bits. False if it is not positive definite.
[[nodiscard]] bool factorisePanel(double* panel, Index height, Index width, double* update, bool parallel);

/// x = L^-1 x and x = L^-T x for the diagonal block.
void solveLower(const double* lower, Index stride, Index width, double* x, Index xStride, Index columns);
void solveLowerTransposed(const double* lower, Index stride, Index width, double* x, Index xStride,
                          Index columns);
void solveLowerTransposed(const float* lower, Index stride, Index width, float* x, Index xStride,
                          Index columns);

/// y -= A x and y -= A' x for the `rows` x `width` block below it.
void subtractProduct(const double* a, Index stride, Index rows, Index width, const double* x, Index xStride,
                     double* y, Index yStride, Index columns);
void subtractTransposedProduct(const double* a, Index stride, Index rows, Index width, const double* x,
                               Index xStride, double* y, Index yStride, Index columns);
void subtractTransposedProduct(const float* a, Index stride, Index rows, Index width, const float* x,
                               Index xStride, float* y, Index yStride, Index columns);

}  // namespace falciform
