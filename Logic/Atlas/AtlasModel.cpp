#include "Logic/Atlas/AtlasModel.h"

#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Subdivision.h"

namespace falciform {

AtlasModel::AtlasModel(const Surface& preop, std::shared_ptr<const Atlas> atlas)
    : preop_(preop), atlas_(std::move(atlas)) {
  checkSurface(preop, "the pre-operative surface");
  if (atlas_->modes.empty())
    throw InputError("the atlas has no deformations: every member leaves the liver as it is; build another");
  constexpr double kFineEdgeMm = 2.5;
  fine_ = subdividedTo(preop, kFineEdgeMm);
  constexpr Index kMostBytes = Index{2} << 30;
  if (const Index most = kMostBytes / (3 * fine_.size() * static_cast<Index>(sizeof(float)));
      atlas_->rank() > most)
    throw InputError("the atlas has " + std::to_string(atlas_->rank()) + " modes; on this surface at most " +
                     std::to_string(most) + " can be fitted: build it with a lower 'energy'");
  const MeshPlaces places(atlas_->mesh, fine_.points);
  modes_.resize(3 * fine_.size(), atlas_->rank());
  forEachChunk(atlas_->modes.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Points there(places.interpolate(atlas_->modes[k]));
      modes_.col(static_cast<Index>(k)) =
          Eigen::Map<const VectorXd>(there.data(), there.size()).cast<float>();
    }
  });
}

Eigen::Matrix<double, 3, Eigen::Dynamic> AtlasModel::modesAt(const Counterpart& place) const {
  Eigen::Matrix<float, 3, Eigen::Dynamic> sum =
      static_cast<float>(place.shares[0]) * modesAt(place.vertices[0]);
  for (int k = 1; k < 3; ++k)
    if (place.shares[k] != 0) sum += static_cast<float>(place.shares[k]) * modesAt(place.vertices[k]);
  return sum.cast<double>();
}

Points AtlasModel::movedPoints(const VectorXd& coefficients) const {
  Points moved = fine_.points;
  const Eigen::VectorXf c = coefficients.cast<float>();
  forEachChunk(static_cast<std::size_t>(moved.rows()), 2048, [&](std::size_t first, std::size_t last) {
    for (auto p = static_cast<Index>(first); p < static_cast<Index>(last); ++p)
      moved.row(p) += (modesAt(p) * c).cast<double>().transpose();
  });
  return moved;
}

Points AtlasModel::displacements(const VectorXd& coefficients) const {
  return fieldOf(atlas_->modes, coefficients.transpose());
}

}  // namespace falciform
