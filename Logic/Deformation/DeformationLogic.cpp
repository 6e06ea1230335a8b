#include "Logic/Deformation/DeformationLogic.h"

#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/Deformation/SegmentLabels.h"

namespace falciform {

namespace {

constexpr double kSegmentReachMm = 5;  // the surface lies a voxel or two beside the labels it was made of

Surface withSegments(const Surface& preop, const LabelMap& segments) {
  Surface liver = preop;
  VectorXd found = labelsAtPoints(preop.points, segments, kSegmentReachMm);
  if ((found.array() > 0).count() == 0)
    throw InputError(
        "no point of the surface lies within 5 mm of a labelled voxel of the segment map; open that of the "
        "same CT");
  liver.arrays[kCouinaudSegment] = std::move(found);
  return liver;
}

}  // namespace

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
  return [preop = case_.preop(), scan = case_.scan(), registration = case_.registration(), chosen = settings,
          labels = segments](const Progress& progress) {
    if (labels)
      return mapDistances(withSegments(*preop, *labels), *scan, registration->scanFromPreop, chosen,
                          progress);
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
