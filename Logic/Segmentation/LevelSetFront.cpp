#include "Logic/Segmentation/LevelSetFront.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Segmentation/GridFilters.h"

namespace falciform {

namespace {

constexpr std::size_t kChunk = 8192;

/// Godunov's upwind slope for a front that moves towards larger values (`outward`) or smaller ones.
double upwindSlope(const double (&back)[3], const double (&ahead)[3], bool outward) {
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    const double left = outward ? std::max(back[a], 0.0) : std::min(back[a], 0.0),
                 right = outward ? std::min(ahead[a], 0.0) : std::max(ahead[a], 0.0);
    sum += std::max(left * left, right * right);
  }
  return std::sqrt(sum);
}

}  // namespace

Image signedDistance(const Volume<std::uint8_t>& flags) {
  Image distance = distanceTo(flags);
  const Image depth = depthWithin(flags);
  const auto half = static_cast<float>(0.5 * flags.spacing().minCoeff());
  const float limit = 1e6F;
  for (std::size_t i = 0; i < distance.voxels.size(); ++i)
    distance.voxels[i] = flags.voxels[i] != 0 ? half - std::min(depth.voxels[i], limit)
                                              : std::min(distance.voxels[i], limit) - half;
  return distance;
}

LevelSetFront::LevelSetFront(Image phi, const FrontPlan& plan)
    : plan_(plan), phi_(std::move(phi)), memory_(sameGrid(phi_, 0.0F)) {
  const Vector3d spacing = phi_.spacing();
  inverse_ = spacing.cwiseInverse();
  step_ = 0.4 * spacing.minCoeff();
  width_ = std::max(1.3 * spacing.maxCoeff(), 2.5 * spacing.minCoeff());
  stride_[0] = 1;
  stride_[1] = phi_.size.x();
  stride_[2] = static_cast<std::ptrdiff_t>(phi_.size.x()) * phi_.size.y();
  for (float& value : phi_.voxels)
    value = std::clamp(value, -static_cast<float>(width_), static_cast<float>(width_));
  rebuildBand();
}

/// The voxels within the band's width, and those beside them, so that the band moves with the front; never
/// the grid's outermost layer.
void LevelSetFront::rebuildBand() {
  const auto near = static_cast<float>(0.999 * width_);
  const int nx = phi_.size.x(), ny = phi_.size.y(), nz = phi_.size.z();
  std::vector<std::vector<std::size_t>> slices(static_cast<std::size_t>(nz));
  forEachChunk(static_cast<std::size_t>(nz), 1, [&](std::size_t begin, std::size_t) {
    const int k = static_cast<int>(begin);
    if (k == 0 || k == nz - 1) return;
    for (int j = 1; j + 1 < ny; ++j)
      for (int i = 1; i + 1 < nx; ++i) {
        const std::size_t v = phi_.offset(i, j, k);
        bool in = std::abs(phi_.voxels[v]) < near;
        for (int a = 0; a < 3 && !in; ++a) in = std::abs(at(v, a, -1)) < near || std::abs(at(v, a, 1)) < near;
        if (in) slices[begin].push_back(v);
      }
  });
  band_.clear();
  for (const auto& slice : slices) band_.insert(band_.end(), slice.begin(), slice.end());
  next_.resize(band_.size());
}

float LevelSetFront::at(std::size_t voxel, int axis, int side) const {
  return phi_.voxels[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(voxel) + side * stride_[axis])];
}

double LevelSetFront::advance(const Image& speed) {
  const double smallest = phi_.spacing().minCoeff(), bend = plan_.curvature * smallest;
  const std::size_t chunks = (band_.size() + kChunk - 1) / kChunk;
  std::vector<double> moved(chunks, 0), counted(chunks, 0);
  std::vector<float> lost(band_.size());
  forEachChunk(band_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t v = band_[n];
      const double here = static_cast<double>(phi_.voxels[v]);
      double back[3], ahead[3], first[3], second[3], square = 0;
      for (int a = 0; a < 3; ++a) {
        const double low = static_cast<double>(at(v, a, -1)), high = static_cast<double>(at(v, a, 1));
        back[a] = (here - low) * inverse_[a];
        ahead[a] = (high - here) * inverse_[a];
        first[a] = (back[a] + ahead[a]) / 2;
        second[a] = (ahead[a] - back[a]) * inverse_[a];
        square += first[a] * first[a];
      }
      double bendingTerm = 0;  // kappa |grad phi|
      if (square > 1e-6) {
        double sum = 0;
        for (int a = 0; a < 3; ++a) {
          const int b = (a + 1) % 3;
          const auto diagonal = [&](int s, int t) {
            return static_cast<double>(phi_.voxels[static_cast<std::size_t>(
                static_cast<std::ptrdiff_t>(v) + s * stride_[a] + t * stride_[b])]);
          };
          const double mixed = (diagonal(1, 1) - diagonal(1, -1) - diagonal(-1, 1) + diagonal(-1, -1)) / 4 *
                               inverse_[a] * inverse_[b];
          sum += second[a] * (square - first[a] * first[a]) - 2 * first[a] * first[b] * mixed;
        }
        bendingTerm = std::clamp(sum / square, -2 / smallest, 2 / smallest);
      }
      // The memory of the place is that of its neighbour on the front's side, if that has lost more.
      std::size_t from = v;
      float nearest = std::abs(phi_.voxels[v]), carried = memory_.voxels[v];
      for (int a = 0; a < 3; ++a)
        for (int side = -1; side <= 1; side += 2)
          if (const float value = std::abs(at(v, a, side)); value < nearest) {
            nearest = value;
            from = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(v) + side * stride_[a]);
          }
      carried = std::max(carried, memory_.voxels[from]);
      const double s = static_cast<double>(speed.voxels[v]);
      const double slope = s == 0 ? 0 : upwindSlope(back, ahead, s > 0);
      const double free = -s * slope + bend * bendingTerm,
                   change = free * std::exp(-static_cast<double>(carried) / plan_.patienceMm);
      next_[n] = static_cast<float>(here + step_ * change);
      lost[n] = carried + static_cast<float>(step_ * (1 - std::min(1.0, std::abs(free))));
      if (std::abs(here) < smallest) {
        moved[begin / kChunk] += std::min(1.0, std::abs(change));
        counted[begin / kChunk] += 1;
      }
    }
  });
  for (std::size_t n = 0; n < band_.size(); ++n) {
    phi_.voxels[band_[n]] = next_[n];
    memory_.voxels[band_[n]] = lost[n];
  }
  restoreDistance();
  repeatBorder();
  rebuildBand();
  double sum = 0, count = 0;
  for (std::size_t c = 0; c < chunks; ++c) {
    sum += moved[c];
    count += counted[c];
  }
  return count > 0 ? sum / count : 0;
}

/// The outermost layer repeats the one below it, so that the front meets the border at a right angle.
void LevelSetFront::repeatBorder() {
  for (int a = 0; a < 3; ++a) {
    const int u = (a + 1) % 3, v = (a + 2) % 3;
    for (int q = 0; q < phi_.size[v]; ++q)
      for (int p = 0; p < phi_.size[u]; ++p) {
        const std::ptrdiff_t first = p * stride_[u] + q * stride_[v],
                             last = first + (phi_.size[a] - 1) * stride_[a];
        phi_.voxels[static_cast<std::size_t>(first)] =
            phi_.voxels[static_cast<std::size_t>(first + stride_[a])];
        phi_.voxels[static_cast<std::size_t>(last)] =
            phi_.voxels[static_cast<std::size_t>(last - stride_[a])];
      }
  }
}

/// Two steps towards |grad phi| = 1 that leave the zero level where it is (Sussman), and the cut at the
/// band's width.
void LevelSetFront::restoreDistance() {
  const double tau = 0.4 * phi_.spacing().minCoeff(), soft = phi_.spacing().squaredNorm() / 3;
  for (int pass = 0; pass < 2; ++pass) {
    forEachChunk(band_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        const std::size_t v = band_[n];
        const double here = static_cast<double>(phi_.voxels[v]);
        double back[3], ahead[3];
        for (int a = 0; a < 3; ++a) {
          back[a] = (here - static_cast<double>(at(v, a, -1))) * inverse_[a];
          ahead[a] = (static_cast<double>(at(v, a, 1)) - here) * inverse_[a];
        }
        const double sign = here / std::sqrt(here * here + soft);
        next_[n] = static_cast<float>(
            std::clamp(here - tau * sign * (upwindSlope(back, ahead, here > 0) - 1), -width_, width_));
      }
    });
    for (std::size_t n = 0; n < band_.size(); ++n) phi_.voxels[band_[n]] = next_[n];
  }
}

}  // namespace falciform
