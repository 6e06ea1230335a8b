#include <array>
#include <cmath>

#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/Normalisation/FieldSample.h"
#include "Logic/Deformation/Normalisation/Similarity.h"

namespace falciform {

namespace {

constexpr int kBoxes = 32, kKnots = 34;  // of the target's values; of the source's, a spline reaching one out
constexpr std::size_t kParts = 16;       // summed in order, whatever the number of threads
using Histogram = std::array<double, std::size_t{kBoxes} * kKnots>;

/// The four cubic B-splines over a place between knots, and their slopes.
struct Splines {
  int first = 0;
  std::array<double, 4> value{}, slope{};
};

Splines splinesAt(double place) {
  Splines s;
  s.first = std::min(static_cast<int>(place), kKnots - 4);
  const double t = place - s.first, r = 1 - t;
  s.value = {r * r * r / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * r * r * r - 6 * r * r + 4) / 6,
             t * t * t / 6};
  s.slope = {-r * r / 2, (3 * t * t - 4 * t) / 2, -(3 * r * r - 4 * r) / 2, t * t / 2};
  return s;
}

std::size_t at(int box, int knot) {
  return static_cast<std::size_t>(box) * kKnots + static_cast<std::size_t>(knot);
}

}  // namespace

MutualInformation::MutualInformation(const GridField& source, const std::vector<float>& target, double lowest,
                                     double highest)
    : source_(source), lowest_(lowest), highest_(highest), box_(target.size()) {
  for (std::size_t i = 0; i < target.size(); ++i) {
    const double share = (std::clamp<double>(target[i], lowest, highest) - lowest) / (highest - lowest);
    box_[i] = std::min(static_cast<int>(share * kBoxes), kBoxes - 1);
  }
}

double MutualInformation::linearise(const Points& places, std::vector<float>& off,
                                    std::vector<Row>& slope) const {
  const std::size_t count = box_.size();
  off.assign(count, 0);
  slope.assign(count, Row::Zero());
  const double perUnit = (kKnots - 3) / (highest_ - lowest_);
  std::vector<FieldSample> samples(count);
  std::vector<Histogram> parts(kParts);
  const auto placeOf = [&](std::size_t i) {
    return (std::clamp(samples[i].value, lowest_, highest_) - lowest_) * perUnit;
  };
  const auto forEachPart = [&](auto&& body) {
    forEachChunk(kParts, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part)
        for (std::size_t i = count * part / kParts; i < count * (part + 1) / kParts; ++i) body(part, i);
    });
  };
  forEachPart([&](std::size_t part, std::size_t i) {
    samples[i] = sampleField(source_, places.row(static_cast<Index>(i)).transpose());
    const Splines s = splinesAt(placeOf(i));
    for (int k = 0; k < 4; ++k) parts[part][at(box_[i], s.first + k)] += s.value[static_cast<std::size_t>(k)];
  });
  Histogram joint{};
  for (const Histogram& part : parts)
    for (std::size_t e = 0; e < joint.size(); ++e) joint[e] += part[e] / static_cast<double>(count);
  std::array<double, kBoxes> ofBox{};
  std::array<double, kKnots> ofKnot{};
  for (int b = 0; b < kBoxes; ++b)
    for (int k = 0; k < kKnots; ++k) {
      ofBox[static_cast<std::size_t>(b)] += joint[at(b, k)];
      ofKnot[static_cast<std::size_t>(k)] += joint[at(b, k)];
    }
  double information = 0, spread = 0;  // spread: variance of the source's value given the target's, in knots
  Histogram logarithm{};
  for (int b = 0; b < kBoxes; ++b) {
    const double box = ofBox[static_cast<std::size_t>(b)];
    double first = 0, second = 0;
    for (int k = 0; k < kKnots; ++k) {
      const double p = joint[at(b, k)];
      first += p * k;
      second += p * k * k;
      if (p <= 0) continue;
      logarithm[at(b, k)] = std::log(p / ofKnot[static_cast<std::size_t>(k)]);
      information += p * (logarithm[at(b, k)] - std::log(box));
    }
    if (box > 0) spread += second - first * first / box;
  }
  forEachPart([&](std::size_t, std::size_t i) {
    if (samples[i].value <= lowest_ || samples[i].value >= highest_) return;
    const Splines s = splinesAt(placeOf(i));
    double gain = 0;
    for (int k = 0; k < 4; ++k)
      gain += s.slope[static_cast<std::size_t>(k)] * logarithm[at(box_[i], s.first + k)];
    off[i] = static_cast<float>(-gain * spread / perUnit);
    slope[i].head<3>() = samples[i].slope.cast<float>();
  });
  return -information;
}

}  // namespace falciform
