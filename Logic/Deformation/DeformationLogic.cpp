#include "Logic/Deformation/DeformationLogic.h"

#include <utility>

#include "Logic/Core/Errors.h"

namespace falciform {

std::string DeformationLogic::missingInput() const {
  if (!case_.preop()) return "Import or open the pre-operative surface first.";
  if (case_.preop()->triangles.rows() == 0)
    return "The pre-operative surface is a cloud of points: import a surface with triangles.";
  if (!case_.scan() || case_.scan()->size() == 0) return "Open a scan first.";
  if (!case_.registration()) return "Register the scan to the pre-operative surface first.";
  return {};
}

std::function<DistanceMap(const Progress&)> DeformationLogic::prepare() const {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  return [preop = case_.preop(), scan = case_.scan(), registration = case_.registration(),
          chosen = settings](const Progress& progress) {
    return mapDistances(*preop, *scan, registration->scanFromPreop, chosen, progress);
  };
}

void DeformationLogic::accept(DistanceMap map) {
  case_.setDistance(std::make_shared<const DistanceMap>(std::move(map)));
}

const DistanceMap& DeformationLogic::run(const Progress& progress) {
  accept(prepare()(progress));
  return *case_.distance();
}

}  // namespace falciform
