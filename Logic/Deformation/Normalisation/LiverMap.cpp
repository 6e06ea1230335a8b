#include "Logic/Deformation/Normalisation/LiverMap.h"

#include <Eigen/Dense>

#include "Logic/Core/Parallel.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 256;

template <class Place>
void forEachPlace(const Points& places, Place&& of) {
  forEachChunk(static_cast<std::size_t>(places.rows()), kChunk, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i) of(i);
  });
}

}  // namespace

Points LiverMap::toSource(const Points& target) const {
  Points source(target.rows(), 3);
  forEachPlace(target, [&](Index i) {
    Vector3d place = sourceFromTarget * Vector3d(target.row(i).transpose());
    for (const BasisWarp& warp : warps) place = warp.move(place);
    source.row(i) = place.transpose();
  });
  return source;
}

Points LiverMap::toTarget(const Points& source) const {
  const Eigen::Affine3d back = sourceFromTarget.inverse();
  Points target(source.rows(), 3);
  forEachPlace(source, [&](Index i) {
    Vector3d place = source.row(i).transpose();
    for (auto warp = warps.rbegin(); warp != warps.rend(); ++warp) place = warp->moveBack(place);
    target.row(i) = (back * place).transpose();
  });
  return target;
}

VectorXd LiverMap::determinants(const Points& target) const {
  VectorXd determinants(target.rows());
  forEachPlace(target, [&](Index i) {
    Vector3d place = sourceFromTarget * Vector3d(target.row(i).transpose());
    double determinant = sourceFromTarget.linear().determinant();
    for (const BasisWarp& warp : warps) {
      determinant *= warp.gradient(place).determinant();
      place = warp.move(place);
    }
    determinants[i] = determinant;
  });
  return determinants;
}

}  // namespace falciform
