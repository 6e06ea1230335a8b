#include "Logic/Core/LandmarkPairs.h"

#include <map>

#include "Logic/Core/Errors.h"

namespace falciform {

namespace {

/// Truth in the order of the targets.
Landmarks paired(const Landmarks& targets, const Landmarks& truth) {
  std::map<std::string, Landmark> byName;
  for (const Landmark& point : truth.points) byName[point.name] = point;
  Landmarks ordered;
  std::map<std::string, int> seen;
  for (const Landmark& target : targets.points) {
    const auto found = byName.find(target.name);
    if (found == byName.end() || seen[target.name]++ > 0) return truth;
    ordered.points.push_back(found->second);
  }
  return ordered;
}

}  // namespace

Points positionsOf(const Landmarks& landmarks) {
  Points points(static_cast<Index>(landmarks.points.size()), 3);
  for (Index i = 0; i < points.rows(); ++i)
    points.row(i) = landmarks.points[static_cast<std::size_t>(i)].position.transpose();
  return points;
}

PairedTargets pairTargets(const Landmarks& targets, const Landmarks& truth) {
  if (targets.points.empty() || targets.points.size() != truth.points.size())
    throw InputError("there are " + std::to_string(targets.points.size()) + " targets and " +
                     std::to_string(truth.points.size()) +
                     " true positions; give as many of both, at least one");
  return {positionsOf(targets), positionsOf(paired(targets, truth))};
}

}  // namespace falciform
