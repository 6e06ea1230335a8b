#include "Logic/Deformation/Normalisation/BasisWarp.h"

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

/// Centres whose functions meet a cell of the lattice: offsets -1, 0, 1, 2 along each axis.
constexpr std::size_t kMeet = 64;
/// Places of a cell at which the gradient is looked at: its corner and half a spacing on along each axis.
constexpr std::size_t kPlaces = 8;

Vector3d offsetOf(std::size_t i) {
  return Vector3d(static_cast<double>(i % 4), static_cast<double>(i / 4 % 4), static_cast<double>(i / 16))
             .array() -
         1.0;
}

/// The same for every cell, lengths in spacings.
struct CellGradients {
  std::array<std::array<Vector3d, kMeet>, kPlaces> at;
  std::array<double, kMeet> largest{};  ///< of each function over the places

  CellGradients() {
    for (std::size_t p = 0; p < kPlaces; ++p)
      for (std::size_t i = 0; i < kMeet; ++i) {
        const Vector3d place(0.5 * static_cast<double>(p & 1), 0.5 * static_cast<double>(p >> 1 & 1),
                             0.5 * static_cast<double>(p >> 2));
        const Vector3d away = (place - offsetOf(i)) / 2;
        at[p][i] = wuSlope(away.norm()) / 2 * away;
        largest[i] = std::max(largest[i], at[p][i].norm());
      }
  }
};

const CellGradients& cellGradients() {
  static const CellGradients gradients;
  return gradients;
}

/// Minus the least eigenvalue of the symmetric part.
double compressionOf(const Matrix3d& gradient) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  return -solver.computeDirect((gradient + gradient.transpose()) / 2, Eigen::EigenvaluesOnly)
              .eigenvalues()[0];
}

}  // namespace

BasisWarp::BasisWarp(const Vector3d& origin, double spacingMm, const Vector3i& counts)
    : coefficients(Points::Zero(static_cast<Index>(counts.x()) * counts.y() * counts.z(), 3)),
      origin_(origin),
      spacing_(spacingMm),
      counts_(counts) {}

Vector3d BasisWarp::move(const Vector3d& place) const {
  Vector3d moved = place;
  forEachBasis(place, [&](Index centre, const Vector3d& away) {
    moved += wu(away.norm()) * coefficients.row(centre).transpose();
  });
  return moved;
}

Matrix3d BasisWarp::gradient(const Vector3d& place) const {
  Matrix3d gradient = Matrix3d::Identity();
  forEachBasis(place, [&](Index centre, const Vector3d& away) {
    gradient +=
        coefficients.row(centre).transpose() * (wuSlope(away.norm()) / (2 * spacing_) * away).transpose();
  });
  return gradient;
}

Vector3d BasisWarp::moveBack(const Vector3d& moved) const {
  Vector3d place = moved;
  for (int i = 0; i < 200; ++i) {
    const Vector3d step = moved - move(place);
    if (step.squaredNorm() < 1e-16) break;
    // Newton converges in a few steps; the fixed point's own step, a contraction, is what makes it sure.
    const Vector3d newton = place + gradient(place).inverse() * step;
    place = (moved - move(newton)).squaredNorm() < step.squaredNorm() ? newton : Vector3d(place + step);
  }
  return place;
}

double BasisWarp::cellCompression(const Vector3i& cell, double enough) const {
  std::array<Vector3d, kMeet> c;
  bool empty = true;
  for (std::size_t i = 0; i < kMeet; ++i) {
    const Vector3i at = cell + offsetOf(i).cast<int>();
    c[i] = inside(at) ? Vector3d(coefficients.row(centreAt(at.x(), at.y(), at.z())).transpose())
                      : Vector3d(Vector3d::Zero());
    empty = empty && c[i].isZero(0);
  }
  if (empty) return 0;
  const CellGradients& gradients = cellGradients();
  double bound = 0;
  for (std::size_t i = 0; i < kMeet; ++i) bound += c[i].norm() * gradients.largest[i];
  if (bound <= enough * spacing_) return bound / spacing_;
  double largest = 0;
  for (const auto& at : gradients.at) {
    Matrix3d gradient = Matrix3d::Zero();
    for (std::size_t i = 0; i < kMeet; ++i) gradient += c[i] * at[i].transpose();
    largest = std::max(largest, compressionOf(gradient));
  }
  return largest / spacing_;
}

double BasisWarp::compression() const {
  double largest = 0;
  for (int z = -3; z < counts_.z() + 2; ++z)
    for (int y = -3; y < counts_.y() + 2; ++y)
      for (int x = -3; x < counts_.x() + 2; ++x) largest = std::max(largest, cellCompression({x, y, z}, 0));
  return largest;
}

void BasisWarp::limitCompression(double limit) {
  constexpr int kRounds = 100;
  const Vector3i cells = counts_.array() + 5;
  const auto cellAt = [&](std::size_t i) {
    const auto at = static_cast<int>(i);
    return Vector3i(at % cells.x() - 3, at / cells.x() % cells.y() - 3, at / cells.x() / cells.y() - 3);
  };
  std::vector<double> is(static_cast<std::size_t>(cells.prod()));
  for (int round = 0; round < kRounds; ++round) {
    forEachChunk(is.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) is[i] = cellCompression(cellAt(i), limit);
    });
    std::vector<double> share(static_cast<std::size_t>(centres()), 1.0);
    bool within = true;
    for (std::size_t i = 0; i < is.size(); ++i) {
      if (is[i] <= limit) continue;
      within = false;
      for (std::size_t k = 0; k < kMeet; ++k) {
        const Vector3i c = cellAt(i) + offsetOf(k).cast<int>();
        if (!inside(c)) continue;
        double& own = share[static_cast<std::size_t>(centreAt(c.x(), c.y(), c.z()))];
        own = std::min(own, 0.95 * limit / is[i]);
      }
    }
    if (within) return;
    for (Index i = 0; i < centres(); ++i) coefficients.row(i) *= share[static_cast<std::size_t>(i)];
  }
  const double worst = compression();
  if (worst > limit) coefficients *= limit / worst;
}

}  // namespace falciform
