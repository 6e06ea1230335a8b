#include "Logic/Atlas/ModelUpdate.h"

#include "Logic/Atlas/MethodResult.h"
#include "Logic/Atlas/ModelFit.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Subdivision.h"

namespace falciform {

UpdateModel::UpdateModel(const Surface& preop, LoadResponses responses)
    : preop_(preop), responses_(std::move(responses)), warp_(responses_.mesh), locator_(responses_.mesh) {
  checkSurface(preop, "the pre-operative surface");
  constexpr double kFineEdgeMm = 2.5;
  fine_ = subdividedTo(preop, kFineEdgeMm);
  places_ = MeshPlaces(locator_, fine_.points);
  centres_ = MeshPlaces(locator_, responses_.centres);
  const KdTree tree(responses_.centres);
  centreOf_.resize(static_cast<std::size_t>(fine_.size()));
  forEachChunk(centreOf_.size(), 1024, [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v)
      centreOf_[v] = tree.nearest(fine_.points.row(static_cast<Index>(v)).transpose()).index;
  });
}

UpdateResult updateModel(const UpdateModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
                         const UpdateSettings& settings, std::uint64_t seed, const Progress& progress,
                         const UpdateObserver& observer) {
  return timedUpdate(settings, [&] {
    return ModelFit(model, scan, scanFromPreopStart, settings, seed).run(progress, observer);
  });
}

Points scanFromPreop(const UpdateModel& model, const UpdateResult& update, const Points& preopMm) {
  const MeshPlaces places(model.locator(), preopMm);
  return transformed(preopMm + Points(places.interpolate(update.displacements)), update.scanFromPreop);
}

}  // namespace falciform
