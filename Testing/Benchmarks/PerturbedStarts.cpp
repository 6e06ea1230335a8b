#include "Testing/Benchmarks/PerturbedStarts.h"

#include <algorithm>
#include <numbers>

#include "Logic/Core/Draws.h"

namespace falciform::bench {
namespace {

Isometry3d drawnMotion(const Vector3d& about, const PerturbedPlan& plan, int start) {
  Draws draws(plan.seed, static_cast<std::uint64_t>(start));
  const double most = plan.turnDeg * std::numbers::pi / 180;
  Matrix3d turn = Matrix3d::Identity();
  for (int axis = 0; axis < 3; ++axis)
    turn = turn * Eigen::AngleAxisd(draws.uniform(-most, most), Vector3d::Unit(axis)).toRotationMatrix();
  Isometry3d motion = Isometry3d::Identity();
  motion.linear() = turn;
  motion.translation() = about - turn * about;
  for (int axis = 0; axis < 3; ++axis)
    motion.translation()[axis] += draws.uniform(-plan.shiftMm, plan.shiftMm);
  return motion;
}

}  // namespace

PerturbedOutcome perturbed(const std::string& name, const Surface& scan, const Isometry3d& pose,
                           const Method& method, const PerturbedPlan& plan) {
  PerturbedOutcome all;
  all.method = name;
  all.starts = plan.starts;
  VectorXd means(plan.starts);
  std::vector<Points> answers;
  const Vector3d middle = scan.points.colwise().mean().transpose();
  for (int s = 0; s < plan.starts; ++s) {
    const MethodOutcome one = method(drawnMotion(middle, plan, s) * pose);
    const Index beads = one.updatedMm.size();
    if (s == 0) all.errorsMm.resize(plan.starts * beads);
    all.errorsMm.segment(s * beads, beads) = one.updatedMm;
    means[s] = one.updatedMm.mean();
    for (const Points& before : answers)
      all.farthestMm = std::max(all.farthestMm, (before - one.places).rowwise().norm().maxCoeff());
    answers.push_back(one.places);
  }
  all.meanMm = figuresOf(means);
  return all;
}

}  // namespace falciform::bench
