#include "Logic/Biomechanics/DenseAlgebra.h"

#include <algorithm>
#include <atomic>
#include <functional>

#include "Logic/Core/Parallel.h"

extern "C" {
void dpotrf_(const char*, const int*, double*, const int*, int*);
void dpotri_(const char*, const int*, double*, const int*, int*);
void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
            const int*, const double*, const int*, const double*, double*, const int*);
void sgemm_(const char*, const char*, const int*, const int*, const int*, const float*, const float*,
            const int*, const float*, const int*, const float*, float*, const int*);
void dgemv_(const char*, const int*, const int*, const double*, const double*, const int*, const double*,
            const int*, const double*, double*, const int*);
void sgemv_(const char*, const int*, const int*, const float*, const float*, const int*, const float*,
            const int*, const float*, float*, const int*);
void dsyrk_(const char*, const char*, const int*, const int*, const double*, const double*, const int*,
            const double*, double*, const int*);
void dtrsm_(const char*, const char*, const char*, const char*, const int*, const int*, const double*,
            const double*, const int*, double*, const int*);
void strsm_(const char*, const char*, const char*, const char*, const int*, const int*, const float*,
            const float*, const int*, float*, const int*);
void dtrsv_(const char*, const char*, const char*, const int*, const double*, const int*, double*,
            const int*);
void strsv_(const char*, const char*, const char*, const int*, const float*, const int*, float*, const int*);
__attribute__((weak)) void openblas_set_num_threads(int);
}

namespace falciform {
namespace {

// One name for both precisions.
constexpr auto gemm(double) { return dgemm_; }
constexpr auto gemm(float) { return sgemm_; }
constexpr auto gemv(double) { return dgemv_; }
constexpr auto gemv(float) { return sgemv_; }
constexpr auto trsm(double) { return dtrsm_; }
constexpr auto trsm(float) { return strsm_; }
constexpr auto trsv(double) { return dtrsv_; }
constexpr auto trsv(float) { return strsv_; }

template <class Number>
void subtract(const char* transpose, const Number* a, Index stride, Index rows, Index width, const Number* x,
              Index xStride, Number* y, Index yStride, Index columns) {
  if (rows == 0 || width == 0 || columns == 0) return;
  const Number minus = -1, one = 1;
  const int m = static_cast<int>(rows), n = static_cast<int>(width), k = static_cast<int>(columns), step = 1;
  const int lda = static_cast<int>(stride), ldx = static_cast<int>(xStride), ldy = static_cast<int>(yStride);
  const bool transposed = *transpose == 'T';
  if (columns == 1)
    gemv(one)(transpose, &m, &n, &minus, a, &lda, x, &step, &one, y, &step);
  else
    gemm(one)(transpose, "N", transposed ? &n : &m, &k, transposed ? &m : &n, &minus, a, &lda, x, &ldx, &one,
              y, &ldy);
}

template <class Number>
void solveTriangle(const char* transpose, const Number* lower, Index stride, Index width, Number* x,
                   Index xStride, Index columns) {
  if (width == 0 || columns == 0) return;
  const Number one = 1;
  const int n = static_cast<int>(width), k = static_cast<int>(columns), lda = static_cast<int>(stride);
  const int ldx = static_cast<int>(xStride), step = 1;
  if (columns == 1)
    trsv(one)("L", transpose, "N", &n, lower, &lda, x, &step);
  else
    trsm(one)("L", "L", transpose, "N", &n, &k, &one, lower, &lda, x, &ldx);
}

Eigen::MatrixXd multiply(const char* transposeA, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const bool transposed = *transposeA == 'T';
  const int rows = static_cast<int>(transposed ? a.cols() : a.rows()), inner = static_cast<int>(b.rows());
  const int strideA = static_cast<int>(a.rows());
  const double one = 1, zero = 0;
  if (inner == 0) return Eigen::MatrixXd::Zero(rows, b.cols());
  Eigen::MatrixXd c(rows, b.cols());
  if (rows == 0) return c;
  // Strips of columns of fixed width, so that the threads' number does not show.
  forEachChunk(static_cast<std::size_t>(b.cols()), 64, [&](std::size_t first, std::size_t last) {
    const int columns = static_cast<int>(last - first);
    const auto at = static_cast<Index>(first);
    dgemm_(transposeA, "N", &rows, &columns, &inner, &one, a.data(), &strideA, b.data() + at * b.rows(),
           &inner, &zero, c.data() + at * rows, &rows);
  });
  return c;
}

constexpr Index kTile = 256;  ///< columns by step, and rows of a tile; two tiles fit a core's second cache

void forTiles(Index count, bool parallel, const std::function<void(Index first, Index last)>& act) {
  if (count <= 0) return;
  if (parallel) {
    forEachChunk(static_cast<std::size_t>(count), static_cast<std::size_t>(kTile),
                 [&](std::size_t a, std::size_t b) { act(static_cast<Index>(a), static_cast<Index>(b)); });
    return;
  }
  for (Index first = 0; first < count; first += kTile) act(first, std::min(count, first + kTile));
}

/// C -= A B' for an m x n block of C.
void subtractOuter(Index m, Index n, Index k, const double* a, const double* b, Index stride, double* c,
                   Index cStride) {
  if (m <= 0 || n <= 0 || k <= 0) return;
  const double minus = -1, one = 1;
  const int rows = static_cast<int>(m), columns = static_cast<int>(n), inner = static_cast<int>(k);
  const int lda = static_cast<int>(stride), ldc = static_cast<int>(cStride);
  dgemm_("N", "T", &rows, &columns, &inner, &minus, a, &lda, b, &lda, &one, c, &ldc);
}

/// The lower triangle of C -= A A'.
void subtractSquare(Index n, Index k, const double* a, Index stride, double* c, Index cStride) {
  if (n <= 0 || k <= 0) return;
  const double minus = -1, one = 1;
  const int size = static_cast<int>(n), inner = static_cast<int>(k);
  const int lda = static_cast<int>(stride), ldc = static_cast<int>(cStride);
  dsyrk_("L", "N", &size, &inner, &minus, a, &lda, &one, c, &ldc);
}

/// Left-looking by block columns: each takes all that is to its left at once, then its own triangle.
bool factoriseColumns(double* panel, Index height, Index width, bool parallel) {
  for (Index from = 0; from < width; from += kTile) {
    const Index columns = std::min(kTile, width - from);
    double* block = panel + from * height + from;
    if (from > 0)
      forTiles(height - from, parallel, [&](Index first, Index last) {
        const double* left = panel + from;
        if (first == 0) subtractSquare(columns, from, left, height, block, height);
        const Index begin = std::max(first, columns);  // the diagonal block is done
        subtractOuter(last - begin, columns, from, left + begin, left, height, block + begin, height);
      });
    const int size = static_cast<int>(columns), stride = static_cast<int>(height);
    int info = 0;
    dpotrf_("L", &size, block, &stride, &info);
    if (info != 0) return false;
    forTiles(height - from - columns, parallel, [&](Index first, Index last) {
      const int rows = static_cast<int>(last - first);
      const double one = 1;
      dtrsm_("R", "L", "T", "N", &rows, &size, &one, block, &stride, block + columns + first, &stride);
    });
  }
  return true;
}

}  // namespace

void keepBlasSingleThreaded() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

bool choleskyInPlace(Eigen::MatrixXd& lower) {
  return factoriseColumns(lower.data(), lower.rows(), lower.rows(), true);
}

void solveCholesky(const Eigen::MatrixXd& lower, Eigen::MatrixXd& rightHandSides) {
  solveLower(lower.data(), lower.rows(), lower.rows(), rightHandSides.data(), lower.rows(),
             rightHandSides.cols());
  solveLowerTransposed(lower.data(), lower.rows(), lower.rows(), rightHandSides.data(), lower.rows(),
                       rightHandSides.cols());
}

void invertCholesky(Eigen::MatrixXd& lower) {
  // Columns of L^-1, each strip from its own rows down, then the products of the strips.
  const Index size = lower.rows();
  Eigen::MatrixXd inverse = Eigen::MatrixXd::Identity(size, size);
  forEachChunk(static_cast<std::size_t>(size), 128, [&](std::size_t first, std::size_t last) {
    const auto at = static_cast<Index>(first);
    solveLower(lower.data() + at * size + at, size, size - at, inverse.data() + at * size + at, size,
               static_cast<Index>(last - first));
  });
  forEachChunk(static_cast<std::size_t>(size), 128, [&](std::size_t first, std::size_t last) {
    const auto at = static_cast<Index>(first);
    const int columns = static_cast<int>(last - first), below = static_cast<int>(size - at);
    const int stride = static_cast<int>(size);
    const double one = 1, zero = 0;
    Eigen::MatrixXd strip(below, columns);  // rows of L^-1 above `at` are zero in these columns
    dgemm_("T", "N", &below, &columns, &below, &one, inverse.data() + at * size + at, &stride,
           inverse.data() + at * size + at, &stride, &zero, strip.data(), &below);
    lower.block(at, at, size - at, columns) = strip;
  });
  lower.triangularView<Eigen::StrictlyUpper>() = lower.transpose();
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return multiply("N", a, b); }
Eigen::MatrixXd transposedProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return multiply("T", a, b);
}

Eigen::MatrixXd outerSquare(const Eigen::MatrixXd& a) {
  const int inner = static_cast<int>(a.cols()), stride = static_cast<int>(a.rows());
  const double one = 1, zero = 0;
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(a.rows(), a.rows());
  if (inner == 0) return c;
  forEachChunk(static_cast<std::size_t>(a.rows()), 48, [&](std::size_t first, std::size_t last) {
    const auto at = static_cast<Index>(first);  // a strip of the lower triangle
    const int columns = static_cast<int>(last - first), rows = static_cast<int>(a.rows() - at);
    dgemm_("N", "T", &rows, &columns, &inner, &one, a.data() + at, &stride, a.data() + at, &stride, &zero,
           c.data() + at * a.rows() + at, &stride);
  });
  c.triangularView<Eigen::StrictlyUpper>() = c.transpose();
  return c;
}

bool factorisePanel(double* panel, Index height, Index width, double* update, bool parallel) {
  if (!factoriseColumns(panel, height, width, parallel)) return false;
  const Index rest = height - width;
  const double* below = panel + width;
  forTiles(rest, parallel, [&](Index first, Index last) {
    subtractSquare(last - first, width, below + first, height, update + first * rest + first, rest);
    subtractOuter(rest - last, last - first, width, below + last, below + first, height,
                  update + first * rest + last, rest);
  });
  return true;
}

void solveLower(const double* lower, Index stride, Index width, double* x, Index xStride, Index columns) {
  solveTriangle("N", lower, stride, width, x, xStride, columns);
}
void solveLowerTransposed(const double* lower, Index stride, Index width, double* x, Index xStride,
                          Index columns) {
  solveTriangle("T", lower, stride, width, x, xStride, columns);
}
void solveLowerTransposed(const float* lower, Index stride, Index width, float* x, Index xStride,
                          Index columns) {
  solveTriangle("T", lower, stride, width, x, xStride, columns);
}
void subtractProduct(const double* a, Index stride, Index rows, Index width, const double* x, Index xStride,
                     double* y, Index yStride, Index columns) {
  subtract("N", a, stride, rows, width, x, xStride, y, yStride, columns);
}
void subtractTransposedProduct(const double* a, Index stride, Index rows, Index width, const double* x,
                               Index xStride, double* y, Index yStride, Index columns) {
  subtract("T", a, stride, rows, width, x, xStride, y, yStride, columns);
}
void subtractTransposedProduct(const float* a, Index stride, Index rows, Index width, const float* x,
                               Index xStride, float* y, Index yStride, Index columns) {
  subtract("T", a, stride, rows, width, x, xStride, y, yStride, columns);
}

}  // namespace falciform
