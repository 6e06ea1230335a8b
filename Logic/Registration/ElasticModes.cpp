#include "Logic/Registration/ElasticModes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform {

namespace {

constexpr int kHighest = 6;  // products of two cubics
using Exponents = std::array<int, 3>;

/// Exponents of the monomials: 1, then x, y, z, then the higher ones; the first 20 are those of the modes.
const std::array<Exponents, ElasticModes::kProducts>& exponents() {
  static const auto all = [] {
    std::array<Exponents, ElasticModes::kProducts> e{};
    std::size_t next = 0;
    for (int degree = 0; degree <= kHighest; ++degree)
      for (int a = degree; a >= 0; --a)
        for (int b = degree - a; b >= 0; --b) e[next++] = {a, b, degree - a - b};
    return e;
  }();
  return all;
}

/// Means of x^a y^b z^c for a + b + c <= 6 under some measure.
class Moments {
 public:
  double& at(const Exponents& e) { return values_[index(e)]; }
  [[nodiscard]] double at(const Exponents& e) const { return values_[index(e)]; }

 private:
  static std::size_t index(const Exponents& e) {
    return static_cast<std::size_t>(e[0] + (kHighest + 1) * (e[1] + (kHighest + 1) * e[2]));
  }
  std::array<double, (kHighest + 1) * (kHighest + 1) * (kHighest + 1)> values_{};
};

template <class Visit>
void forEachExponent(const Visit& visit) {
  for (int c = 0; c <= kHighest; ++c)
    for (int b = 0; b + c <= kHighest; ++b)
      for (int a = 0; a + b + c <= kHighest; ++a) visit(Exponents{a, b, c});
}

/// Adds `weight` times the monomials at `x`; a cone from the origin holds 3/(d+3) of its base's share of
/// degree d.
void addAt(Moments& moments, const Vector3d& x, double weight, bool cone) {
  std::array<std::array<double, kHighest + 1>, 3> powers;
  for (std::size_t k = 0; k < 3; ++k) {
    powers[k][0] = 1;
    for (std::size_t p = 1; p <= kHighest; ++p) powers[k][p] = powers[k][p - 1] * x[static_cast<Index>(k)];
  }
  forEachExponent([&](const Exponents& e) {
    const double share = cone ? 3.0 / (e[0] + e[1] + e[2] + 3) : 1;
    moments.at(e) += weight * share * powers[0][static_cast<std::size_t>(e[0])] *
                     powers[1][static_cast<std::size_t>(e[1])] * powers[2][static_cast<std::size_t>(e[2])];
  });
}

/// Of the enclosed volume, by cones from the origin over the triangles (each base taken at its middle), or of
/// the points if there are no triangles or no volume; scaled to a total of 1.
Moments momentsOf(const Points& points, const Triangles& triangles, const VectorXd& areas, bool volume) {
  Moments moments;
  if (volume) {
    for (Index t = 0; t < triangles.rows(); ++t) {
      const Vector3d a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
                     c = points.row(triangles(t, 2));
      addAt(moments, (a + b + c) / 3, a.dot(b.cross(c)) / 6, true);
    }
  } else {
    for (Index i = 0; i < points.rows(); ++i) addAt(moments, points.row(i).transpose(), areas[i], false);
  }
  const double total = moments.at({0, 0, 0});
  forEachExponent([&](const Exponents& e) { moments.at(e) /= total; });
  return moments;
}

/// Mean of d(phi_a)/dx_i d(phi_b)/dx_j, in scaled coordinates.
double gradientProduct(const Moments& moments, Exponents a, int i, Exponents b, int j) {
  const int factor = a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)];
  if (factor == 0) return 0;
  --a[static_cast<std::size_t>(i)];
  --b[static_cast<std::size_t>(j)];
  return factor * moments.at({a[0] + b[0], a[1] + b[1], a[2] + b[2]});
}

/// Mean of the sum over i and j of d2(phi_a)/dx_i dx_j d2(phi_b)/dx_i dx_j, in scaled coordinates.
double curvatureProduct(const Moments& moments, const Exponents& a, const Exponents& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    Exponents da = a, db = b;
    const int factor = da[i]-- * db[i]--;
    if (factor == 0) continue;
    for (int j = 0; j < 3; ++j) sum += factor * gradientProduct(moments, da, j, db, j);
  }
  return sum;
}

}  // namespace

ElasticModes::ElasticModes(const Surface& preop, double poissonRatio) {
  const VectorXd areas = vertexAreas(preop);
  centre_ = (preop.points.transpose() * areas) / areas.sum();
  Points centred = preop.points.rowwise() - centre_.transpose();
  scaleMm_ = std::sqrt(centred.rowwise().squaredNorm().mean());
  centred /= scaleMm_;
  // A volume that is a small part of what the surface could hold is that of an open sheet: no organ.
  const double volume = preop.triangles.rows() == 0 ? 0 : signedVolume(preop) / std::pow(scaleMm_, 3);
  const Moments moments = momentsOf(centred, preop.triangles, areas, volume > 0.05);

  const auto& e = exponents();
  const double bulk = poissonRatio / (1 - 2 * poissonRatio), perMm2 = 1 / (scaleMm_ * scaleMm_);
  for (int a = 0; a < kMonomials; ++a)
    for (int b = 0; b < kMonomials; ++b) {
      const Exponents &ea = e[static_cast<std::size_t>(a)], &eb = e[static_cast<std::size_t>(b)];
      products_(a, b) = moments.at({ea[0] + eb[0], ea[1] + eb[1], ea[2] + eb[2]});
      double laplacian = 0;
      for (int i = 0; i < 3; ++i) laplacian += gradientProduct(moments, ea, i, eb, i);
      const double smooth = kSmoothness * curvatureProduct(moments, ea, eb);
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          const double straight = gradientProduct(moments, ea, k, eb, l),
                       crossed = gradientProduct(moments, ea, l, eb, k);
          energy_(k * kMonomials + a, l * kMonomials + b) =
              perMm2 * ((k == l ? 0.5 * laplacian + smooth : 0) + 0.5 * crossed + bulk * straight);
        }
    }
}

ElasticModes::Monomials ElasticModes::monomials(const Vector3d& place) const {
  const Vector3d s = (place - centre_) / scaleMm_;
  const double x = s.x(), y = s.y(), z = s.z();
  Monomials m;  // in the order of exponents()
  m << 1, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z, x * x * x, x * x * y, x * x * z, x * y * y,
      x * y * z, x * z * z, y * y * y, y * y * z, y * z * z, z * z * z;
  return m;
}

ElasticModes::Products ElasticModes::products(const Eigen::Matrix<double, Eigen::Dynamic, 3>& places) const {
  // Each monomial is one of a degree less times the first coordinate that it holds.
  static const auto from = [] {
    std::array<std::pair<int, int>, kProducts> parents{};
    const auto& e = exponents();
    for (std::size_t i = 1; i < e.size(); ++i) {
      Exponents less = e[i];
      const std::size_t axis = less[0] > 0 ? 0 : less[1] > 0 ? 1 : 2;
      --less[axis];
      parents[i] = {static_cast<int>(std::find(e.begin(), e.end(), less) - e.begin()),
                    static_cast<int>(axis)};
    }
    return parents;
  }();
  const Eigen::Matrix<double, Eigen::Dynamic, 3> scaled = (places.rowwise() - centre_.transpose()) / scaleMm_;
  Products all(places.rows(), kProducts);
  all.col(0).setOnes();
  for (int i = 1; i < kProducts; ++i) {
    const auto& [parent, axis] = from[static_cast<std::size_t>(i)];
    all.col(i) = all.col(parent).cwiseProduct(scaled.col(axis));
  }
  return all;
}

const ElasticModes::ProductTable& ElasticModes::productTable() {
  static const ProductTable table = [] {
    ProductTable t;
    const auto& e = exponents();
    for (int a = 0; a < kMonomials; ++a)
      for (int b = 0; b < kMonomials; ++b) {
        const Exponents &ea = e[static_cast<std::size_t>(a)], &eb = e[static_cast<std::size_t>(b)];
        const Exponents sum{ea[0] + eb[0], ea[1] + eb[1], ea[2] + eb[2]};
        t(a, b) = static_cast<int>(std::find(e.begin(), e.end(), sum) - e.begin());
      }
    return t;
  }();
  return table;
}

Isometry3d ElasticModes::rigidPart(const Coefficients& u) const {
  // In coordinates about the centre: x = scale * monomials 1..3, and y = x + u.
  const Vector3d from = scaleMm_ * products_.block<3, 1>(1, 0), shift = u.transpose() * products_.col(0);
  const Matrix3d squares = scaleMm_ * scaleMm_ * products_.block<3, 3>(1, 1);
  const Matrix3d mixed = scaleMm_ * products_.middleRows<3>(1) * u;
  const Vector3d to = from + shift;
  return rigidFromMoments(centre_ + from, centre_ + to, squares + mixed - from * to.transpose());
}

ElasticModes::Coefficients ElasticModes::without(const Isometry3d& rigid, const Coefficients& u) const {
  Coefficients place = Coefficients::Zero();  // x itself
  place.row(0) = centre_;
  place.middleRows<3>(1) = scaleMm_ * Matrix3d::Identity();
  Coefficients back = (place + u) * rigid.linear();
  back.row(0) -= (rigid.linear().transpose() * rigid.translation()).transpose();
  return back - place;
}

double ElasticModes::rootMeanSquare(const Coefficients& u) const {
  return std::sqrt(std::max(0.0, (u.transpose() * products_ * u).trace()));
}

}  // namespace falciform
