#pragma once
#include <vector>

#include "Logic/Deformation/Normalisation/FieldSamples.h"

namespace falciform {

/// A measure of how alike target and source are at a set of samples, as least squares see it.
class Similarity {
 public:
  /// Three values and a zero: one register.
  using Row = Eigen::Vector4f;

  virtual ~Similarity() = default;
  /// For each sample, moved to `places` in the source's frame: what is to be brought to zero, and its slope
  /// per mm (zero where it says nothing). Returns the cost, lower is more alike. The same for any number of
  /// threads.
  virtual double linearise(const Points& places, std::vector<float>& off, std::vector<Row>& slope) const = 0;
};

/// Differences of signed distances, each clamped to +-`bandMm`; the cost is the sum of their squares.
class DistanceSimilarity final : public Similarity {
 public:
  /// Holds what it is given by reference. `wanted`: the target's distances at the samples.
  DistanceSimilarity(const GridField& source, const std::vector<float>& wanted, double bandMm)
      : source_(source), wanted_(wanted), band_(bandMm) {}
  double linearise(const Points& places, std::vector<float>& off, std::vector<Row>& slope) const override;

 private:
  const GridField& source_;
  const std::vector<float>& wanted_;
  double band_;
};

/// Mutual information of two images (Viola, Wells 1997; Mattes 2003), natural logarithm: joint histogram of
/// the target's values in boxes and the source's by cubic B-splines. The cost is minus the information; what
/// is to be brought to zero is its slope by a sample's value, scaled by the spread that is left.
class MutualInformation final : public Similarity {
 public:
  /// Values outside [lowest, highest] count as these.
  MutualInformation(const GridField& source, const std::vector<float>& target, double lowest, double highest);
  double linearise(const Points& places, std::vector<float>& off, std::vector<Row>& slope) const override;

 private:
  const GridField& source_;
  double lowest_, highest_;
  std::vector<int> box_;  ///< of each sample's value in the target
};

}  // namespace falciform
