#include "Logic/Segmentation/EnclosedTissue.h"

#include <algorithm>
#include <cmath>

#include "Logic/Segmentation/GridFilters.h"
#include "Logic/Segmentation/RegionPieces.h"

namespace falciform {

namespace {

constexpr double kLungHu = -300;      ///< smoothed: more than half air
constexpr double kMajorityMm = 2;     ///< Gaussian about a voxel whose majority decides what it is
constexpr double kTouchVoxels = 1.5;  ///< a blurred edge lies between two bodies that touch
constexpr double kDiaphragmMm = 6;    ///< with the blurred edges on both its sides
constexpr double kStepMm = 1.5;       ///< between the radii tried

using Flags = Volume<std::uint8_t>;

template <class Say>
Flags flagsWhere(const Image& image, const Say& say) {
  Flags flags = sameGrid<std::uint8_t>(image, 0);
  for (std::size_t i = 0; i < flags.voxels.size(); ++i) flags.voxels[i] = say(i);
  return flags;
}

/// The organ with what of its own brightness leads on from it, no farther than `reachMm` along the way: the
/// rim around a tumour is too thin for the first growth.
Flags rimsOf(const Flags& organ, const Flags& like, double reachMm) {
  Flags rims = organ;
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < organ.voxels.size(); ++i)
    if (organ.voxels[i] != 0) front.push_back(i);
  const int steps = static_cast<int>(std::lround(reachMm / organ.spacing().maxCoeff()));
  for (int step = 0; step < steps; ++step) {
    std::vector<std::size_t> next;
    for (const std::size_t voxel : front)
      eachFaceNeighbour(organ.size, voxel, [&](std::size_t there) {
        if (rims.voxels[there] != 0 || like.voxels[there] == 0) return;
        rims.voxels[there] = 1;
        next.push_back(there);
      });
    front.swap(next);
  }
  return rims;
}

/// What is known of every voxel.
struct Surroundings {
  Image depth;  // within the darker tissue
  Image toOrgan, toLung;
  const Flags& organ;
};

Vector3i indexOf(const Vector3i& size, std::size_t voxel) {
  const auto at = static_cast<int>(voxel);
  return {at % size.x(), at / size.x() % size.y(), at / size.x() / size.y()};
}

/// All that balls of `radius` about the middles cover, less the organ; ascending.
std::vector<std::size_t> covered(const Flags& organ, const std::vector<std::size_t>& middles, double radius) {
  const Vector3i margin = (radius / organ.spacing().array()).ceil().cast<int>();
  Vector3i low = organ.size, high = Vector3i::Zero();
  for (const std::size_t voxel : middles) {
    low = low.cwiseMin(indexOf(organ.size, voxel));
    high = high.cwiseMax(indexOf(organ.size, voxel));
  }
  low = (low - margin).cwiseMax(0);
  high = (high + margin).cwiseMin(organ.size - Vector3i::Ones());
  Flags box{high - low + Vector3i::Ones(), organ.worldFromIndex, {}};
  box.voxels.assign(static_cast<std::size_t>(box.size.cast<Index>().prod()), 0);
  for (const std::size_t voxel : middles) {
    const Vector3i at = indexOf(organ.size, voxel) - low;
    box.at(at.x(), at.y(), at.z()) = 1;
  }
  const Image away = distanceTo(box);
  std::vector<std::size_t> body;
  for (int k = 0; k < box.size.z(); ++k)
    for (int j = 0; j < box.size.y(); ++j)
      for (int i = 0; i < box.size.x(); ++i) {
        const std::size_t voxel = organ.offset(low.x() + i, low.y() + j, low.z() + k);
        if (static_cast<double>(away.at(i, j, k)) < radius && organ.voxels[voxel] == 0) body.push_back(voxel);
      }
  return body;
}

/// How much of the voxels around a body touch the organ: of all, and of those that are not at the lung.
struct Contact {
  double touching = 0, enclosed = 0;
};

Contact contactOf(const Surroundings& at, const std::vector<std::size_t>& body) {
  const double touch = kTouchVoxels * at.organ.spacing().maxCoeff();
  Flags seen = sameGrid<std::uint8_t>(at.organ, 0);
  for (const std::size_t voxel : body) seen.voxels[voxel] = 1;
  std::size_t all = 0, touching = 0, counted = 0;
  for (const std::size_t voxel : body)
    eachFaceNeighbour(at.organ.size, voxel, [&](std::size_t there) {
      if (seen.voxels[there] != 0) return;
      seen.voxels[there] = 1;
      const bool byOrgan = static_cast<double>(at.toOrgan.voxels[there]) <= touch;
      ++all;
      touching += byOrgan;
      counted += byOrgan || static_cast<double>(at.toLung.voxels[there]) > kDiaphragmMm;
    });
  if (counted == 0) return {};
  return {static_cast<double>(touching) / static_cast<double>(all),
          static_cast<double>(touching) / static_cast<double>(counted)};
}

}  // namespace

std::vector<EnclosedBody> enclosedBodies(const Image& image, const Flags& organ, const Flags& barred,
                                         const EnclosedPlan& plan) {
  const auto low = static_cast<float>(plan.lowHu), dark = static_cast<float>(plan.darkHu),
             bright = static_cast<float>(plan.brightHu), air = static_cast<float>(kLungHu);
  // One noisy voxel says little: the majority about each voxel decides.
  Image share = sameGrid(image, 0.0F);
  for (std::size_t i = 0; i < share.voxels.size(); ++i)
    share.voxels[i] = image.voxels[i] > low && image.voxels[i] < dark ? 1 : 0;
  smooth(share, kMajorityMm);
  const Flags open = flagsWhere(image, [&](std::size_t i) {
    return organ.voxels[i] == 0 && share.voxels[i] > 0.5F && (barred.voxels.empty() || barred.voxels[i] == 0);
  });
  const Flags withRims = rimsOf(
      organ,
      flagsWhere(image, [&](std::size_t i) { return image.voxels[i] >= dark && image.voxels[i] < bright; }),
      plan.rimMm);
  const Surroundings at{depthWithin(open), distanceTo(withRims),
                        distanceTo(flagsWhere(image, [&](std::size_t i) { return image.voxels[i] < air; })),
                        organ};
  const auto organVoxels = static_cast<double>(std::count(organ.voxels.begin(), organ.voxels.end(), 1));
  float deepest = 0;
  for (std::size_t i = 0; i < open.voxels.size(); ++i)
    if (open.voxels[i] != 0 && std::isfinite(at.depth.voxels[i]))
      deepest = std::max(deepest, at.depth.voxels[i]);

  // Bodies only grow as the balls get smaller: the last one that is enclosed holds those before it.
  Flags taken = sameGrid<std::uint8_t>(organ, 0);
  const double widest = std::max(plan.leastRadiusMm, static_cast<double>(deepest));
  const int steps = static_cast<int>(std::floor((widest - plan.narrowestMm) / kStepMm));
  for (int step = steps; step >= 0; --step) {
    const double radius = plan.narrowestMm + step * kStepMm;
    const Flags middles = flagsWhere(image, [&](std::size_t i) {
      return open.voxels[i] != 0 && static_cast<double>(at.depth.voxels[i]) >= radius;
    });
    for (const RegionPiece& piece : piecesOf(middles)) {
      float room = 0, nearest = at.toOrgan.voxels[piece.voxels.front()];
      for (const std::size_t voxel : piece.voxels) {
        room = std::max(room, at.depth.voxels[voxel]);
        nearest = std::min(nearest, at.toOrgan.voxels[voxel]);
      }
      if (static_cast<double>(room) < plan.leastRadiusMm || static_cast<double>(nearest) > 2 * radius ||
          static_cast<double>(piece.voxels.size()) > plan.mostShare * organVoxels)
        continue;
      const std::vector<std::size_t> body = covered(organ, piece.voxels, radius);
      if (static_cast<double>(body.size()) > plan.mostShare * organVoxels) continue;
      const Contact contact = contactOf(at, body);
      if (contact.enclosed < plan.enclosedShare || contact.touching < plan.touchingShare) continue;
      for (const std::size_t voxel : body)
        taken.voxels[voxel] = barred.voxels.empty() || barred.voxels[voxel] == 0;
    }
  }

  std::vector<EnclosedBody> bodies;
  for (const RegionPiece& piece : piecesOf(taken)) {
    EnclosedBody body;
    body.region = sameGrid<std::uint8_t>(organ, 0);
    std::vector<float> values;
    std::size_t middle = piece.voxels.front();
    for (const std::size_t voxel : piece.voxels) {
      body.region.voxels[voxel] = 1;
      if (open.voxels[voxel] == 0) continue;
      values.push_back(image.voxels[voxel]);
      if (at.depth.voxels[voxel] > at.depth.voxels[middle]) middle = voxel;
    }
    body.place = organ.world(indexOf(organ.size, middle).cast<double>());
    body.tissue = tissueOf(std::move(values));
    body.volumeMl = piece.volumeMl(organ);
    if (body.volumeMl < plan.leastMl) continue;
    body.enclosedShare = contactOf(at, piece.voxels).enclosed;
    bodies.push_back(std::move(body));
  }
  std::stable_sort(bodies.begin(), bodies.end(),
                   [](const EnclosedBody& a, const EnclosedBody& b) { return a.volumeMl > b.volumeMl; });
  return bodies;
}

}  // namespace falciform
