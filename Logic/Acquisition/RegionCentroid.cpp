#include "Logic/Acquisition/RegionCentroid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/Core/PlaceText.h"

namespace falciform {
namespace {

constexpr double kOverNoise = 4, kSdOfMad = 1.4826;
constexpr int kSummedLayers = 2;  // a voxel that the body only touches lies next to one that is half full

bool inside(const Image& image, const Vector3i& at) {
  return at.minCoeff() >= 0 && (image.size - at).minCoeff() >= 1;
}

std::size_t offsetOf(const Image& image, const Vector3i& at) { return image.offset(at.x(), at.y(), at.z()); }

float valueAt(const Image& image, const Vector3i& at) { return image.voxels[offsetOf(image, at)]; }

Vector3i voxelAt(const Image& image, const Vector3d& world) {
  const Eigen::Vector4d index = image.worldFromIndex.inverse() * world.homogeneous();
  if (!index.allFinite() || index.head<3>().cwiseAbs().maxCoeff() > 1e6) return Vector3i::Constant(-1);
  return index.head<3>().array().round().cast<int>();
}

/// Voxels that are new, joined to `from` by a face, an edge or a corner.
std::vector<Vector3i> layerAround(const Image& image, const std::vector<Vector3i>& from,
                                  std::unordered_set<std::size_t>& taken) {
  std::vector<Vector3i> layer;
  for (const Vector3i& at : from)
    for (int n = 0; n < 27; ++n) {
      const Vector3i next = at + Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if (inside(image, next) && taken.insert(offsetOf(image, next)).second) layer.push_back(next);
    }
  return layer;
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> valuesOf(const Image& image, const std::vector<Vector3i>& voxels) {
  std::vector<double> values;
  for (const Vector3i& at : voxels) values.push_back(valueAt(image, at));
  return values;
}

const std::array<Vector3i, 6>& faces() {
  static const std::array<Vector3i, 6> six{Vector3i(1, 0, 0),  Vector3i(-1, 0, 0), Vector3i(0, 1, 0),
                                           Vector3i(0, -1, 0), Vector3i(0, 0, 1),  Vector3i(0, 0, -1)};
  return six;
}

/// Centre and volume of a body whose voxels are `taken`; moments are taken about `start`, for small numbers.
GrownRegion measured(const Image& image, std::vector<Vector3i> body, const Vector3i& start,
                     std::unordered_set<std::size_t>& taken) {
  GrownRegion found;
  found.voxels = body.size();
  const double inner = medianOf(valuesOf(image, body));  // of a ball of some voxels' radius: its inside
  std::vector<Vector3i> layer = body;
  for (int n = 0; n < kSummedLayers; ++n) {
    layer = layerAround(image, layer, taken);
    body.insert(body.end(), layer.begin(), layer.end());
  }
  std::vector<double> around = valuesOf(image, layerAround(image, layer, taken));
  const double surroundings = medianOf(around);
  for (double& value : around) value = std::abs(value - surroundings);
  const double noise = kSdOfMad * medianOf(around);

  double sum = 0;
  Vector3d moment = Vector3d::Zero();
  for (const Vector3i& at : body) {
    const double weight = valueAt(image, at) - surroundings;
    if (weight < kOverNoise * noise) continue;
    sum += weight;
    moment += weight * (at - start).cast<double>();
  }
  if (sum > 0) moment /= sum;
  found.centre = image.world(start.cast<double>() + moment);
  found.volumeMm3 = inner > surroundings ? sum / (inner - surroundings) * image.voxelVolume() : 0;
  return found;
}

std::vector<Vector3i> flood(const Image& image, const Vector3i& seed, double threshold, double largestMm3,
                            std::unordered_set<std::size_t>& taken) {
  const double most = largestMm3 / image.voxelVolume();
  std::vector<Vector3i> region{seed};
  taken.insert(offsetOf(image, seed));
  for (std::size_t next = 0; next < region.size(); ++next) {
    if (static_cast<double>(region.size()) > most)
      throw InputError("the region grew beyond " + std::to_string(std::lround(largestMm3)) +
                       " mm3: it leaks into its neighbours; raise the threshold");
    for (const Vector3i& face : faces()) {
      const Vector3i at = region[next] + face;
      if (inside(image, at) && valueAt(image, at) >= threshold && taken.insert(offsetOf(image, at)).second)
        region.push_back(at);
    }
  }
  return region;
}

}  // namespace

GrownRegion growRegion(const Image& image, const Vector3d& seed, double threshold, double largestMm3) {
  const Vector3i start = voxelAt(image, seed);
  if (!inside(image, start))
    throw InputError("the seed at " + placeText(seed) + " lies outside the volume; place it on the body");
  if (!(valueAt(image, start) >= threshold))
    throw InputError("the seed at " + placeText(seed) + " holds " +
                     std::to_string(std::lround(valueAt(image, start))) + ", below the threshold of " +
                     std::to_string(std::lround(threshold)) + "; place it on the body");
  std::unordered_set<std::size_t> taken;
  std::vector<Vector3i> body = flood(image, start, threshold, largestMm3, taken);
  return measured(image, std::move(body), start, taken);
}

std::vector<GrownRegion> findBodies(const Image& image, double threshold, double smallestMm3,
                                    double largestMm3) {
  const auto most = static_cast<std::size_t>(largestMm3 / image.voxelVolume());
  std::vector<char> seen(image.voxels.size());
  std::vector<GrownRegion> bodies;
  std::vector<Vector3i> front;
  for (int k = 0; k < image.size.z(); ++k)
    for (int j = 0; j < image.size.y(); ++j)
      for (int i = 0; i < image.size.x(); ++i) {
        if (seen[image.offset(i, j, k)] || !(image.at(i, j, k) >= threshold)) continue;
        std::vector<Vector3i> body;
        std::size_t count = 0;  // what is too large is flooded, but not kept
        front.assign(1, Vector3i(i, j, k));
        seen[image.offset(i, j, k)] = 1;
        while (!front.empty()) {
          const Vector3i at = front.back();
          front.pop_back();
          if (++count <= most) body.push_back(at);
          for (const Vector3i& face : faces()) {
            const Vector3i next = at + face;
            if (!inside(image, next) || !(valueAt(image, next) >= threshold)) continue;
            char& mark = seen[offsetOf(image, next)];
            if (!mark) front.push_back(next);
            mark = 1;
          }
        }
        if (count > most || static_cast<double>(count) * image.voxelVolume() < smallestMm3) continue;
        std::unordered_set<std::size_t> taken;
        for (const Vector3i& at : body) taken.insert(offsetOf(image, at));
        bodies.push_back(measured(image, std::move(body), Vector3i(i, j, k), taken));
      }
  return bodies;
}

}  // namespace falciform
