#include "Testing/Benchmarks/Truths/TruthPlan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"

namespace falciform::bench {
namespace {

constexpr double kGravityMPerS2 = 9.81;
enum Stream : std::uint64_t { kTissue = 1, kLeftPack, kRightPack, kHeld, kGravity, kScanner, kPlaces };

double logUniform(Draws& draws, double low, double high) {
  return low * std::pow(high / low, draws.uniform());
}

Pack drawPack(std::uint64_t seed, Stream stream) {
  Draws draws(seed, stream);
  Pack pack;
  pack.pushMm = draws.uniform(10, 60);
  pack.extentMm = draws.uniform(std::max(20.0, 0.6 * pack.pushMm), 50);  // no towel is a stick
  pack.offCentre = draws.uniform(0, 0.7);
  pack.lean = draws.uniform(0, 1);
  pack.sticks = draws.uniform() < 0.5;
  pack.place = kPlaces + stream;
  return pack;
}

nlohmann::json toJson(const Pack& pack) {
  return {{"push_mm", pack.pushMm},
          {"extent_mm", pack.extentMm},
          {"off_centre", pack.offCentre},
          {"lean", pack.lean},
          {"sticks", pack.sticks}};
}

}  // namespace

TruthPlan drawTruth(std::uint64_t seed, PackedLobe lobe) {
  TruthPlan plan;
  plan.seed = seed;
  plan.lobe = lobe;

  Draws tissue(seed, kTissue);
  plan.liverKPa = logUniform(tissue, 4, 12);
  plan.poissonsRatio = tissue.uniform(0.45, 0.47);
  plan.tumourFactor = tissue.uniform(5, 10);
  plan.tumourRadiusMm = tissue.uniform(8, 20);

  if (lobe != PackedLobe::Right) plan.packs[0] = drawPack(seed, kLeftPack);
  if (lobe != PackedLobe::Left) plan.packs[1] = drawPack(seed, kRightPack);

  Draws held(seed, kHeld);
  plan.heldRadiusMm = held.uniform(30, 60);
  plan.heldTowardsVenaCava = held.uniform(0, 1);
  plan.venaCavaHeld = held.uniform() < 0.5;
  plan.ligamentHeld = held.uniform() < 0.25;

  // The table is turned about an axis that lies in it: to a side, head up or down.
  Draws gravity(seed, kGravity);
  plan.turnDeg = logUniform(gravity, 10, 50);
  const double heading = gravity.uniform(0, 2 * std::numbers::pi),
               turn = plan.turnDeg * std::numbers::pi / 180;
  plan.gravityChangeMPerS2 = kGravityMPerS2 * Vector3d(std::sin(turn) * std::cos(heading), std::cos(turn) - 1,
                                                       std::sin(turn) * std::sin(heading));

  Draws scanner(seed, kScanner);
  plan.azimuthDeg = scanner.uniform(-25, 40);
  plan.elevationDeg = scanner.uniform(-30, 25);
  plan.distanceMm = scanner.uniform(400, 600);
  plan.coverage = scanner.uniform(0.18, 0.4);
  plan.noiseMm = logUniform(scanner, 0.5, 2);
  plan.outlierShare = scanner.uniform(0, 0.02);
  return plan;
}

nlohmann::json toJson(const TruthPlan& plan) {
  nlohmann::json json = {
      {"liver_kpa", plan.liverKPa},
      {"poissons_ratio", plan.poissonsRatio},
      {"tumour_factor", plan.tumourFactor},
      {"tumour_radius_mm", plan.tumourRadiusMm},
      {"gravity_turn_deg", plan.turnDeg},
      {"gravity_change_m_per_s2",
       {plan.gravityChangeMPerS2.x(), plan.gravityChangeMPerS2.y(), plan.gravityChangeMPerS2.z()}},
      {"held_radius_mm", plan.heldRadiusMm},
      {"held_towards_vena_cava", plan.heldTowardsVenaCava},
      {"vena_cava_held", plan.venaCavaHeld},
      {"ligament_held", plan.ligamentHeld},
      {"scanner_azimuth_deg", plan.azimuthDeg},
      {"scanner_elevation_deg", plan.elevationDeg},
      {"scanner_distance_mm", plan.distanceMm},
      {"coverage_aimed_at", plan.coverage}};
  for (std::size_t side = 0; side < 2; ++side)
    if (plan.packs[side].pushMm > 0)
      json["pack_" + std::string(kPackedLobeNames[side])] = toJson(plan.packs[side]);
  return json;
}

}  // namespace falciform::bench
