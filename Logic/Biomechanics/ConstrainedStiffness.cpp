#include "Logic/Biomechanics/ConstrainedStiffness.h"

namespace falciform {

ConstrainedStiffness::ConstrainedStiffness(StiffnessMatrix stiffness, std::vector<NodeConstraint> constraints,
                                           const Progress& progress)
    : stiffness_(std::move(stiffness)),
      reduced_(stiffness_, std::move(constraints)),
      factor_(reduced_.matrix(), reduced_.order(stiffness_.graph), progress) {}

Points ConstrainedStiffness::solve(const Points& forces) const {
  return solve(std::vector<Points>{forces}, {1.0}).front();
}

std::vector<Points> ConstrainedStiffness::solve(const std::vector<Points>& forces,
                                                const std::vector<double>& scales) const {
  const Points given = reduced_.prescribed();
  const bool moved = given.cwiseAbs().maxCoeff() > 0;
  const Points held = moved ? stiffness_.times(given) : Points(Points::Zero(given.rows(), 3));
  Eigen::MatrixXd right(freeDirections(), static_cast<Index>(forces.size()));
  for (std::size_t load = 0; load < forces.size(); ++load)
    reduced_.gather(forces[load] - scales[load] * held, right.col(static_cast<Index>(load)));
  factor_.solve(right);
  std::vector<Points> displacements;
  for (std::size_t load = 0; load < forces.size(); ++load)
    displacements.push_back(scales[load] * given + reduced_.scatter(right.col(static_cast<Index>(load))));
  return displacements;
}

Points ConstrainedStiffness::reactions(const Points& displacements, const Points& forces) const {
  Points result = Points::Zero(displacements.rows(), 3);
  const Points all = stiffness_.times(displacements) - forces;
  for (const NodeConstraint& constraint : reduced_.constraints())
    result.row(constraint.node) = all.row(constraint.node);
  return result;
}

}  // namespace falciform
