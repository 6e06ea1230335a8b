#include "Logic/Biomechanics/DenseAlgebra.h"

extern "C" {
void dpotrf_(const char*, const int*, double*, const int*, int*);
void dpotri_(const char*, const int*, double*, const int*, int*);
void dpotrs_(const char*, const int*, const int*, const double*, const int*, double*, const int*, int*);
void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
            const int*, const double*, const int*, const double*, double*, const int*);
void sgemm_(const char*, const char*, const int*, const int*, const int*, const float*, const float*,
            const int*, const float*, const int*, const float*, float*, const int*);
void sgemv_(const char*, const int*, const int*, const float*, const float*, const int*, const float*,
            const int*, const float*, float*, const int*);
void strsm_(const char*, const char*, const char*, const char*, const int*, const int*, const float*,
            const float*, const int*, float*, const int*);
void strsv_(const char*, const char*, const char*, const int*, const float*, const int*, float*, const int*);
__attribute__((weak)) void openblas_set_num_threads(int);
}

namespace falciform {
namespace {

Eigen::MatrixXd multiply(const char* transposeA, const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const bool transposed = *transposeA == 'T';
  const int rows = static_cast<int>(transposed ? a.cols() : a.rows()), columns = static_cast<int>(b.cols());
  const int inner = static_cast<int>(b.rows()), strideA = static_cast<int>(a.rows());
  const double one = 1, zero = 0;
  Eigen::MatrixXd c(rows, columns);
  if (rows == 0 || columns == 0) return c;
  if (inner == 0) return Eigen::MatrixXd::Zero(rows, columns);
  dgemm_(transposeA, "N", &rows, &columns, &inner, &one, a.data(), &strideA, b.data(), &inner, &zero,
         c.data(), &rows);
  return c;
}

}  // namespace

void keepBlasSingleThreaded() {
  if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
}

bool choleskyInPlace(Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>> lower) {
  const int size = static_cast<int>(lower.rows()), stride = static_cast<int>(lower.outerStride());
  int info = 0;
  if (size > 0) dpotrf_("L", &size, lower.data(), &stride, &info);
  return info == 0;
}

void solveCholesky(const Eigen::MatrixXd& lower, Eigen::MatrixXd& rightHandSides) {
  const int size = static_cast<int>(lower.rows()), columns = static_cast<int>(rightHandSides.cols());
  int info = 0;
  if (size > 0 && columns > 0)
    dpotrs_("L", &size, &columns, lower.data(), &size, rightHandSides.data(), &size, &info);
}

void invertCholesky(Eigen::MatrixXd& lower) {
  const int size = static_cast<int>(lower.rows());
  int info = 0;
  if (size > 0) dpotri_("L", &size, lower.data(), &size, &info);
  lower.triangularView<Eigen::StrictlyUpper>() = lower.transpose();
}

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return multiply("N", a, b); }
Eigen::MatrixXd transposedProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return multiply("T", a, b);
}

void subtractTransposed(int rows, int width, int columns, const float* a, int stride, const float* x,
                        int xStride, float* y, int yStride) {
  if (rows == 0 || width == 0) return;
  const float minus = -1, one = 1;
  const int step = 1;
  if (columns == 1)
    sgemv_("T", &rows, &width, &minus, a, &stride, x, &step, &one, y, &step);
  else
    sgemm_("T", "N", &width, &columns, &rows, &minus, a, &stride, x, &xStride, &one, y, &yStride);
}

void solveTransposedLower(int width, int columns, const float* lower, int stride, float* y, int yStride) {
  if (width == 0) return;
  const float one = 1;
  const int step = 1;
  if (columns == 1)
    strsv_("L", "T", "N", &width, lower, &stride, y, &step);
  else
    strsm_("L", "L", "T", "N", &width, &columns, &one, lower, &stride, y, &yStride);
}

}  // namespace falciform
