#include "Testing/Benchmarks/Truths/CohortPlan.h"

#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"

namespace falciform::bench {
namespace {

constexpr double kGravityMPerS2 = 9.81;
enum Stream : std::uint64_t { kFront = 400, kTissue, kGravity, kScanner };

FrontPattern drawFront(std::uint64_t seed, Procedure procedure) {
  Draws draws(seed, kFront);
  FrontPattern front;
  const double middle = procedure == Procedure::LeftHepatectomy ? 0.15
                        : procedure == Procedure::RightLobe     ? -0.5
                                                                : -0.15;
  front.centreU = middle + draws.uniform(-0.1, 0.1);
  front.centreV = draws.uniform(-0.2, 0.2);
  front.widthU = draws.uniform(0.28, 0.4);
  front.widthV = draws.uniform(0.45, 0.65);
  const double sign = procedure == Procedure::Bilobar ? 1 : -1;
  front.bumpMm = sign * draws.uniform(8, 15);
  front.rimMm = -sign * draws.uniform(3, 7);
  for (FrontPattern::Wave& wave : front.waves)
    wave = {.amplitudeMm = 1.5 * draws.normal(),
            .u = draws.uniform(1, 4),
            .v = draws.uniform(-3, 3),
            .phase = draws.uniform(0, 2 * std::numbers::pi)};
  return front;
}

/// Gravity when patient and table are turned about an axis that lies in it; a heading of 0: to the left,
/// 90 degrees: head up.
Vector3d gravityChange(double turnDeg, double headingDeg) {
  const double turn = turnDeg * std::numbers::pi / 180, heading = headingDeg * std::numbers::pi / 180;
  return kGravityMPerS2 * Vector3d(std::sin(turn) * std::cos(heading), std::cos(turn) - 1,
                                   -std::sin(turn) * std::sin(heading));
}

ScannerPlan drawScanner(std::uint64_t seed) {
  Draws draws(seed, kScanner);
  ScannerPlan scanner;
  scanner.seed = seed;
  scanner.azimuthDeg = draws.uniform(-10, 20);
  scanner.elevationDeg = draws.uniform(-20, 10);
  scanner.distanceMm = draws.uniform(450, 600);  // thesis: 45 to 60 cm
  scanner.coverage = draws.uniform(0.3, 0.42);
  scanner.noiseMm = draws.uniform(0.3, 0.7);  // thesis: about 0.5 mm
  scanner.raster = true;
  return scanner;
}

nlohmann::json toJson(const FrontPattern& front) {
  nlohmann::json waves = nlohmann::json::array();
  for (const FrontPattern::Wave& wave : front.waves)
    waves.push_back(
        {{"amplitude_mm", wave.amplitudeMm}, {"u", wave.u}, {"v", wave.v}, {"phase", wave.phase}});
  return {{"centre_u", front.centreU},
          {"centre_v", front.centreV},
          {"width_u", front.widthU},
          {"width_v", front.widthV},
          {"bump_mm", front.bumpMm},
          {"rim_mm", front.rimMm},
          {"waves", waves}};
}

}  // namespace

std::string groupOf(Procedure procedure) {
  switch (procedure) {
    case Procedure::LeftHepatectomy:
      return "A";
    case Procedure::Bilobar:
      return "B";
    case Procedure::RightLobe:
      return "C";
    case Procedure::TurnedLeft:
    case Procedure::HeadUp:
      break;
  }
  return "";
}

double FrontPattern::at(double u, double v) const {
  const double du = (u - centreU) / widthU, dv = (v - centreV) / widthV,
               bump = std::exp(-(du * du + dv * dv) / 2);
  double mm = rimMm + (bumpMm - rimMm) * bump;
  for (const Wave& wave : waves) mm += wave.amplitudeMm * std::cos(wave.u * u + wave.v * v + wave.phase);
  return mm;
}

CohortPlan drawCohortCase(Procedure procedure, std::uint64_t seed) {
  CohortPlan plan;
  plan.procedure = procedure;
  plan.scanner = drawScanner(seed);
  Draws tissue(seed, kTissue);
  plan.liverKPa = tissue.uniform(10, 20);
  plan.heldRadiusMm = tissue.uniform(30, 45);

  Draws gravity(seed, kGravity);
  double turnDeg = gravity.uniform(2, 12), headingDeg = gravity.uniform(0, 360);
  switch (procedure) {
    case Procedure::LeftHepatectomy:
    case Procedure::RightLobe:
    case Procedure::Bilobar:
      plan.front = drawFront(seed, procedure);
      break;
    case Procedure::TurnedLeft:
      turnDeg = gravity.uniform(20, 30);
      headingDeg = gravity.uniform(-15, 15);
      break;
    case Procedure::HeadUp:
      turnDeg = gravity.uniform(20, 30);
      headingDeg = gravity.uniform(75, 105);
      break;
  }
  plan.gravityChangeMPerS2 = gravityChange(turnDeg, headingDeg);
  return plan;
}

nlohmann::json toJson(const CohortPlan& plan) {
  const Vector3d& g = plan.gravityChangeMPerS2;
  return {{"liver_kpa", plan.liverKPa},
          {"front", plan.front ? toJson(*plan.front) : nlohmann::json()},
          {"gravity_change_m_per_s2", {g.x(), g.y(), g.z()}},
          {"held_radius_mm", plan.heldRadiusMm},
          {"scanner_azimuth_deg", plan.scanner.azimuthDeg},
          {"scanner_elevation_deg", plan.scanner.elevationDeg},
          {"scanner_distance_mm", plan.scanner.distanceMm},
          {"coverage_aimed_at", plan.scanner.coverage}};
}

const std::vector<CohortMember>& cohortMembers() {
  using enum Procedure;
  static const std::vector<CohortMember> members{
      {2, LeftHepatectomy}, {3, RightLobe}, {4, Bilobar},         {5, LeftHepatectomy}, {6, RightLobe},
      {7, TurnedLeft},      {8, Bilobar},   {9, LeftHepatectomy}, {10, RightLobe},      {17, HeadUp}};
  return members;
}

}  // namespace falciform::bench
