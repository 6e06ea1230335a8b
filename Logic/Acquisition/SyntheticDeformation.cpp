#include "Logic/Acquisition/SyntheticDeformation.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"
#include "Logic/Geometry/Measures.h"

namespace falciform {
namespace {

constexpr int kModes = 5;
constexpr double kFold = 0.2;  // det(I + grad u) below which a body counts as folded

/// Takes the small rigid motion that fits u best over `points` out of u, so that what is left is change of
/// shape.
void removeRigidMotion(SmoothDisplacement& u, const Points& points) {
  u.centre = centroid(points);
  Vector3d mean = Vector3d::Zero(), moment = Vector3d::Zero();
  Matrix3d inertia = Matrix3d::Zero();
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d p = points.row(i).transpose(), r = p - u.centre, d = u.at(p);
    mean += d;
    moment += r.cross(d);
    inertia += r.squaredNorm() * Matrix3d::Identity() - r * r.transpose();
  }
  u.translation = mean / static_cast<double>(points.rows());
  u.rotation = inertia.ldlt().solve(moment);
}

void scale(SmoothDisplacement& u, double factor) {
  for (SmoothDisplacement::Mode& mode : u.modes) mode.amplitude *= factor;
  u.translation *= factor;
  u.rotation *= factor;
}

void deform(Surface& surface, const SmoothDisplacement& u) {
  surface.points = u.moved(surface.points);
  if (surface.normals.rows() > 0) surface.normals = vertexNormals(surface);
}

}  // namespace

Vector3d SmoothDisplacement::at(const Vector3d& p) const {
  Vector3d u = -translation - rotation.cross(p - centre);
  for (const Mode& mode : modes) u += mode.amplitude * std::sin(mode.wave.dot(p) + mode.phase);
  return u;
}

Matrix3d SmoothDisplacement::gradient(const Vector3d& p) const {
  Matrix3d g;
  g << 0, rotation.z(), -rotation.y(), -rotation.z(), 0, rotation.x(), rotation.y(), -rotation.x(), 0;
  for (const Mode& mode : modes)
    g += mode.amplitude * mode.wave.transpose() * std::cos(mode.wave.dot(p) + mode.phase);
  return g;
}

Points SmoothDisplacement::moved(const Points& points) const {
  Points result(points.rows(), 3);
  for (Index i = 0; i < points.rows(); ++i) {
    const Vector3d p = points.row(i).transpose();
    result.row(i) = (p + at(p)).transpose();
  }
  return result;
}

SmoothDisplacement drawDisplacement(const Points& points, const SyntheticDeformationSettings& settings) {
  checkSettings(settings);
  if (points.rows() < 3)
    throw InputError("a deformation needs a surface of at least 3 points, found " +
                     std::to_string(points.rows()));
  Draws draws(static_cast<std::uint64_t>(settings.seed), 2);
  SmoothDisplacement u;
  for (int n = 0; n < kModes; ++n) {
    SmoothDisplacement::Mode mode;
    const Vector3d along = draws.direction();
    mode.wave = along * (2 * std::numbers::pi / (settings.wavelengthMm * draws.uniform(1.0, 1.6)));
    // Across the wave: a field without divergence keeps the volume to first order.
    mode.amplitude = along.cross(draws.normal3());
    mode.phase = draws.uniform(0, 2 * std::numbers::pi);
    u.modes.push_back(mode);
  }
  removeRigidMotion(u, points);
  double sum = 0;
  for (Index i = 0; i < points.rows(); ++i) sum += u.at(points.row(i).transpose()).squaredNorm();
  const double rms = std::sqrt(sum / static_cast<double>(points.rows()));
  scale(u, rms > 0 ? settings.rmsMm / rms : 0);

  for (Index i = 0; i < points.rows(); ++i)
    if ((Matrix3d::Identity() + u.gradient(points.row(i).transpose())).determinant() < kFold)
      throw InputError("a deformation of " + std::to_string(settings.rmsMm) + " mm at a wavelength of " +
                       std::to_string(settings.wavelengthMm) +
                       " mm would fold the liver; take less rmsMm or more wavelengthMm");
  return u;
}

SyntheticLiver deformSynthetic(const SyntheticLiver& liver, const SyntheticDeformationSettings& settings) {
  const SmoothDisplacement u = drawDisplacement(liver.surface.points, settings);
  SyntheticLiver result = liver;
  deform(result.surface, u);
  for (auto& [name, structure] : result.structures) deform(structure, u);
  for (Landmarks* list : {&result.targets, &result.anatomical})
    for (Landmark& landmark : list->points) landmark.position += u.at(landmark.position);
  return result;
}

}  // namespace falciform
