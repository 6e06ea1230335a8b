#include "Logic/Biomechanics/SupportResponse.h"

#include "Logic/Core/Errors.h"
#include "Logic/Core/Results.h"

namespace falciform {
namespace {

/// Area-weighted: a tenth of the time of vertexNormals(), and for shading as good.
Points shadingNormals(const Surface& surface) {
  Points normals = Points::Zero(surface.size(), 3);
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const auto corners = surface.triangles.row(t);
    const Vector3d a = surface.points.row(corners[0]), b = surface.points.row(corners[1]),
                   c = surface.points.row(corners[2]);
    const Vector3d area = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k) normals.row(corners[k]) += area.transpose();
  }
  for (Index i = 0; i < normals.rows(); ++i)
    if (const double length = normals.row(i).norm(); length > 0) normals.row(i) /= length;
  return normals;
}

}  // namespace

SupportResponse::SupportResponse(std::shared_ptr<const SupportModel> model, std::vector<Support> supports)
    : model_(std::move(model)), supports_(std::move(supports)) {
  std::vector<SupportHypothesis> units;
  SupportHypothesis rest;
  rest.supports = supports_;
  for (Support& support : rest.supports) support.pushMm = 0;
  for (std::size_t s = 0; s < supports_.size(); ++s) {
    if (supports_[s].kind != SupportKind::Pushed) continue;
    pushed_.push_back(static_cast<int>(s));
    units.push_back(rest);
    units.back().supports[s].pushMm = 1;
  }
  for (const Vector3d& gravity : {Vector3d(Vector3d::UnitX()), Vector3d(Vector3d::UnitY())}) {
    units.push_back(rest);
    units.back().gravityChangeMPerS2 = gravity;
  }
  fields_ = model_->solver.solve(units);
  for (const Points& field : fields_) atPoints_.emplace_back(model_->places.interpolate(field));
}

DeformedLiver SupportResponse::at(const std::vector<double>& pushMm, double turnDeg) const {
  if (pushMm.size() != supports_.size())
    throw InputError("there are " + std::to_string(pushMm.size()) + " distances for " +
                     std::to_string(supports_.size()) + " supports; give one each");
  std::vector<double> factors;
  for (const int s : pushed_) factors.push_back(pushMm[static_cast<std::size_t>(s)]);
  const Vector3d gravity = gravityChangeOfTurn(turnDeg);
  factors.insert(factors.end(), {gravity.x(), gravity.y()});
  const auto sumOf = [&](const std::vector<Points>& fields) {
    Points sum = Points::Zero(fields.front().rows(), 3);
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (factors[k] != 0) sum += factors[k] * fields[k];
    return sum;
  };

  auto moved = std::make_shared<Surface>(*model_->preop);
  const Points displacement = sumOf(atPoints_);
  moved->points += displacement;
  moved->normals = shadingNormals(*moved);
  DeformedLiver liver;
  VectorXd& lengths = moved->arrays[kDisplacement];
  lengths = displacement.rowwise().norm();
  liver.largestMm = lengths.size() > 0 ? lengths.maxCoeff() : 0;
  liver.surface = std::move(moved);
  liver.check = checkDeformation(model_->liver.mesh, sumOf(fields_));
  return liver;
}

}  // namespace falciform
