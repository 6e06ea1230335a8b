#include "Logic/Geometry/Curvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Neighbourhoods.h"
#include "Logic/Geometry/QuadricFit.h"

namespace falciform {

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// Two unit vectors that complete a unit `normal`, without a branch or a root (Duff et al. 2017, Building an
/// Orthonormal Basis, Revisited).
std::array<Vector3d, 2> tangents(const Vector3d& normal) {
  const double sign = std::copysign(1.0, normal.z()), a = -1 / (sign + normal.z());
  const double b = normal.x() * normal.y() * a;
  return {Vector3d(1 + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x()),
          Vector3d(b, sign + normal.y() * normal.y() * a, -normal.y())};
}

/// The quadric at one place, in the frame u, v of its tangent plane; derivatives by mm.
struct LocalQuadric {
  Vector3d normal = Vector3d::Zero();
  std::array<Vector3d, 2> axis;
  QuadricSlopes slopes;
};

/// Fits quadrics to the places of one chunk.
class Fitter {
 public:
  Fitter(const Points& points, const Neighbourhoods& around, const CurvatureSettings& settings)
      : points_(points),
        around_(around),
        linearTerms_(settings.linearTerms),
        largestLean_(settings.largestLean),
        scratch_(around.borrow()) {}
  Fitter(const Fitter&) = delete;
  Fitter& operator=(const Fitter&) = delete;
  ~Fitter() { around_.giveBack(std::move(scratch_)); }

  [[nodiscard]] LocalQuadric at(int place) {
    LocalQuadric quadric;
    quadric.slopes.huu = kNoValue;
    quadric.normal = around_.normal(place);
    if (!(quadric.normal.squaredNorm() > 0.5)) return quadric;  // no normal, no frame
    around_.gather(place, *scratch_);
    const auto count = scratch_->found.size();
    if (count < (linearTerms_ ? 5U : 3U)) return quadric;
    quadric.axis = tangents(quadric.normal);
    offsets_.resize(count + 1);
    const Vector3d here = points_.row(place);
    Vector3d middle = Vector3d::Zero();  // times the count
    double largest = 0;                  // mm^2
    for (std::size_t i = 0; i < count; ++i) {
      offsets_[i] = points_.row(scratch_->found[i]).transpose() - here;
      middle += offsets_[i];
      largest = std::max(largest, offsets_[i].squaredNorm());
    }
    offsets_[count].setZero();  // fills the last lane
    if (!(largest > 0)) return quadric;
    const double size = std::sqrt(largest), perSize = 1 / size;  // mm
    const double aside = (middle - middle.dot(quadric.normal) * quadric.normal).norm();
    if (aside > largestLean_ * size * static_cast<double>(count)) return quadric;
    const Vector3d u = quadric.axis[0] * perSize, v = quadric.axis[1] * perSize, n = quadric.normal * perSize;
    QuadricMoments moments;
    for (std::size_t i = 0; i < count; i += 2) {
      const Vector3d &p = offsets_[i], &q = offsets_[i + 1];
      moments.add({u.dot(p), u.dot(q)}, {v.dot(p), v.dot(q)}, {n.dot(p), n.dot(q)});
    }
    QuadricSlopes s = linearTerms_ ? moments.fitWithLinearTerms(static_cast<double>(count) + 1)
                                   : moments.fitWithoutLinearTerms();
    s.huu *= perSize, s.huv *= perSize, s.hvv *= perSize;
    quadric.slopes = s;
    return quadric;
  }

 private:
  const Points& points_;
  const Neighbourhoods& around_;
  bool linearTerms_;
  double largestLean_;
  std::unique_ptr<Neighbourhoods::Scratch> scratch_;
  std::vector<Vector3d> offsets_;  ///< mm, from the place
};

/// Of the graph of h: positive where it bends away from the normal.
double meanOf(const QuadricSlopes& s) {
  const double steep = 1 + s.hu * s.hu + s.hv * s.hv;
  return -((1 + s.hv * s.hv) * s.huu - 2 * s.hu * s.hv * s.huv + (1 + s.hu * s.hu) * s.hvv) /
         (2 * steep * std::sqrt(steep));
}

/// Calls `write(place, fitter)` for all places, on all threads.
template <class Write>
void forEachPlace(const Surface& surface, const CurvatureSettings& settings, const Write& write) {
  const Neighbourhoods around(surface, settings);
  forEachChunk(static_cast<std::size_t>(surface.size()), 1024, [&](std::size_t begin, std::size_t end) {
    Fitter fitter(surface.points, around, settings);
    for (std::size_t i = begin; i < end; ++i) write(static_cast<int>(i), fitter.at(static_cast<int>(i)));
  });
}

/// The surface's shape operator in an orthonormal frame of the graph's tangent plane, and its eigenvectors.
void writePrincipal(const LocalQuadric& q, Index place, Curvatures& all) {
  const QuadricSlopes& s = q.slopes;
  // Gram-Schmidt on the tangents (1, 0, hu) and (0, 1, hv): t1 = e1 / |e1|, t2 = (e2 - (e2.t1) t1) / |.|.
  const double length1 = std::sqrt(1 + s.hu * s.hu), along = s.hu * s.hv / length1;
  const double steep = 1 + s.hu * s.hu + s.hv * s.hv, length2 = std::sqrt(steep) / length1;
  // Their steps in u and v: t1 = (p, 0), t2 = (r, w).
  const double p = 1 / length1, w = 1 / length2, r = -along * w / length1;
  const double bend = -1 / std::sqrt(steep);
  const double m11 = bend * p * p * s.huu, m12 = bend * p * (r * s.huu + w * s.huv),
               m22 = bend * (r * r * s.huu + 2 * r * w * s.huv + w * w * s.hvv);
  const double mean = 0.5 * (m11 + m22), half = std::hypot(0.5 * (m11 - m22), m12);
  all.mean[place] = mean;
  all.k1[place] = mean + half;
  all.k2[place] = mean - half;
  const double angle = 0.5 * std::atan2(2 * m12, m11 - m22);
  const auto tangent = [&](double c1, double c2) {
    const double u = c1 * p + c2 * r, v = c2 * w;
    return Vector3d(u * q.axis[0] + v * q.axis[1] + (u * s.hu + v * s.hv) * q.normal);
  };
  all.direction1.row(place) = tangent(std::cos(angle), std::sin(angle));
  all.direction2.row(place) = tangent(-std::sin(angle), std::cos(angle));
}

}  // namespace

CurvatureSettings thesisCurvature() {
  CurvatureSettings settings;
  settings.neighbours = 4;
  settings.linearTerms = false;
  return settings;
}

VectorXd meanCurvature(const Surface& surface, const CurvatureSettings& settings) {
  VectorXd mean(surface.size());
  forEachPlace(surface, settings, [&](int i, const LocalQuadric& q) { mean[i] = meanOf(q.slopes); });
  return mean;
}

Curvatures principalCurvatures(const Surface& surface, const CurvatureSettings& settings) {
  Curvatures all;
  all.mean.setConstant(surface.size(), kNoValue);
  all.k1 = all.k2 = all.mean;
  all.direction1.setConstant(surface.size(), 3, kNoValue);
  all.direction2 = all.direction1;
  forEachPlace(surface, settings, [&](int i, const LocalQuadric& q) {
    if (!std::isnan(q.slopes.huu)) writePrincipal(q, i, all);
  });
  return all;
}

}  // namespace falciform
