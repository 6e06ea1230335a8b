#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "Logic/Core/Parallel.h"
#include "Logic/Deformation/Normalisation/LiverRegistration.h"
#include "Logic/Deformation/Normalisation/Similarity.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::test {
namespace {

/// A smooth field on 40^3 corners, 3 mm apart, between about 0 and 200.
GridField waves(double phase) {
  GridField field;
  field.cellMm = 3;
  field.counts = {40, 40, 40};
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const Vector3d p = field.place(x, y, z) / 20;
        field.values.push_back(static_cast<float>(
            100 + 40 * (std::sin(p.x() + phase) + std::cos(1.3 * p.y()) * std::sin(0.7 * p.z()))));
      }
  return field;
}

FieldSamples samplesIn(const GridField& field) { return samplesOf(field, 1e9, 4); }

TEST(MutualInformation, OfAnImageWithItselfIsItsEntropyAndWithNoiseNone) {
  const GridField field = waves(0);
  FieldSamples samples = samplesIn(field);
  std::vector<float> off;
  std::vector<Similarity::Row> slope;
  const double self = -MutualInformation(field, samples.values, 0, 200).linearise(samples.places, off, slope);
  std::mt19937 random(3);
  std::shuffle(samples.values.begin(), samples.values.end(), random);
  const double none = -MutualInformation(field, samples.values, 0, 200).linearise(samples.places, off, slope);
  EXPECT_GT(self, 1.5);  // of at most ln 32 = 3.5
  EXPECT_LT(none, 0.05);
  EXPECT_GT(none, 0);
}

TEST(MutualInformation, DoesNotCareForTheScaleOfTheTargetsValues) {
  const GridField field = waves(0);
  const FieldSamples samples = samplesIn(field);
  std::vector<float> inverted(samples.values);
  for (float& value : inverted) value = 200 - value;
  std::vector<float> off;
  std::vector<Similarity::Row> slope;
  const double as = MutualInformation(field, samples.values, 0, 200).linearise(samples.places, off, slope);
  const double other = MutualInformation(field, inverted, 0, 200).linearise(samples.places, off, slope);
  EXPECT_NEAR(as, other, 0.01);  // boxes meet values from the other side
}

TEST(MutualInformation, SlopeIsItsDerivativeByPlaces) {
  const GridField source = waves(0.3);
  const FieldSamples samples = samplesIn(waves(0));
  const MutualInformation information(source, samples.values, 0, 200);
  std::vector<float> off;
  std::vector<Similarity::Row> slope;
  (void)information.linearise(samples.places, off, slope);
  // Along a common shift the cost changes as the sum of off * slope, up to one factor for all.
  Vector3d predicted = Vector3d::Zero(), measured;
  for (std::size_t i = 0; i < off.size(); ++i) predicted += (off[i] * slope[i].head<3>()).cast<double>();
  std::vector<float> other;
  std::vector<Similarity::Row> unused;
  constexpr double kStep = 0.02;  // mm
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::RowVector3d step = kStep * Eigen::RowVector3d::Unit(axis);
    measured[axis] = information.linearise(samples.places.rowwise() + step, other, unused) -
                     information.linearise(samples.places.rowwise() - step, other, unused);
  }
  EXPECT_GT(predicted.normalized().dot(measured.normalized()), 0.99);
}

/// A CT whose inner pattern is bent by millimetres in the other patient and whose greys are turned round:
/// the surfaces, alike, say nothing of it.
TEST(MutualInformation, FindsABendingInsideThatTheSurfacesDoNotShow) {
  const Surface liver = sphere(50, 4);
  const auto bend = [](const Vector3d& p) {
    const double fade = std::max(0.0, 1 - p.squaredNorm() / (45 * 45));
    return Vector3d(p + 5 * fade * fade * Vector3d(1, std::sin(p.x() / 15), 0));
  };
  const auto grey = [](const Vector3d& p) {
    return 100 * std::sin(p.x() / 6) * std::sin(p.y() / 7) * std::sin(p.z() / 8);
  };
  Image target;
  target.size = {60, 60, 60};
  target.worldFromIndex.topLeftCorner<3, 3>() *= 2;
  target.worldFromIndex.topRightCorner<3, 1>().setConstant(-59);
  target.voxels.resize(60 * 60 * 60);
  Image source = target;
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 60; ++i) {
        const Vector3d p = target.world(Vector3d(i, j, k));
        target.at(i, j, k) = static_cast<float>(grey(bend(p)));
        source.at(i, j, k) = static_cast<float>(50 - 0.8 * grey(p));
      }
  NormalisationSettings settings;
  settings.levels = 6;
  settings.finestMm = 12;
  const LiverMap map = registerLivers(liver, liver, CtPair{target, source}, settings);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-25, 25);
  double before = 0, after = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3d p(uniform(random), uniform(random), uniform(random));
    before += (bend(p) - p).norm() / 300;
    after += (map.toSource(p.transpose()).transpose() - bend(p)).norm() / 300;
  }
  EXPECT_GT(before, 2);
  EXPECT_LT(after, 0.35 * before);
}

}  // namespace
}  // namespace falciform::test
