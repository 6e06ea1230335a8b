#include "Logic/Atlas/AtlasMembers.h"

#include <cmath>

#include "Logic/Atlas/DesignSampling.h"
#include "Logic/Core/NumberText.h"

namespace falciform {
namespace {

constexpr double kFacingCosine = 0.5;  // 60 degrees

const std::vector<int>& facesOf(const SupportSites& sites, const std::string& region) {
  if (region == "venaCava") return sites.venaCava;
  if (region == "posteriorBed") return sites.posteriorBed;
  return region == "leftUnderside" ? sites.leftUnderside : sites.rightUnderside;
}

std::vector<Support> supportsOf(const SupportSet& set, const SupportSites& sites) {
  std::vector<Support> supports;
  const auto add = [&](const std::vector<std::string>& regions, SupportKind kind) {
    for (const std::string& region : regions) {
      Support support;
      support.name = region;
      support.kind = kind;
      support.faces = facesOf(sites, region);
      supports.push_back(std::move(support));
    }
  };
  add(set.fixed, SupportKind::Fixed);
  add(set.sliding, SupportKind::Sliding);
  return supports;
}

/// Those of `faces` that look the way most of them do: a pack presses from one side, not both walls of a
/// fissure apart.
std::vector<int> facingAlike(const SupportSites& sites, const std::vector<int>& faces) {
  const auto areaVector = [&](int f) {
    const Surface& surface = sites.boundary.surface;
    const auto corner = [&](int k) {
      return Vector3d(surface.points.row(surface.triangles(f, k)).transpose());
    };
    return Vector3d((corner(1) - corner(0)).cross(corner(2) - corner(0)) / 2);
  };
  Vector3d sum = Vector3d::Zero();
  for (const int f : faces) sum += areaVector(f);
  std::vector<int> kept;
  for (const int f : faces)
    if (areaVector(f).normalized().dot(sum.normalized()) > kFacingCosine) kept.push_back(f);
  return kept.empty() ? faces : kept;
}

/// The set's supports, and a place on the underside that is pushed.
AtlasSetup packedSetup(const SupportSet& set, const SupportSites& sites, const Vector3d& centre,
                       double extentMm) {
  AtlasSetup setup{
      .name = set.name, .supports = supportsOf(set, sites), .centreMm = centre, .extentMm = extentMm};
  Support packing;
  packing.name = "packing";
  packing.kind = SupportKind::Pushed;
  packing.faces = facingAlike(sites, packingSite(sites, centre, extentMm));
  packing.pushMm = 1;
  setup.pushed = static_cast<int>(setup.supports.size());
  setup.supports.push_back(std::move(packing));
  return setup;
}

/// -max, ..., 0, ..., max by steps.
std::vector<double> turns(const GravityDesignSettings& settings) {
  const int each = static_cast<int>(std::floor(settings.maxAngleDeg / settings.stepDeg + 1e-9));
  std::vector<double> angles;
  for (int k = -each; k <= each; ++k) angles.push_back(k * settings.stepDeg);
  return angles;
}

AtlasMembers gravityMembers(const AtlasDesign& design, const SupportSites& sites) {
  const GravityDesignSettings& settings = design.gravityDirections;
  const Vector3d initial =
      kGravityMPerS2 * Vector3d(settings.initialX, settings.initialY, settings.initialZ).normalized();
  AtlasMembers result;
  for (const SupportSet& set : design.supportSets) {
    const int setup = static_cast<int>(result.setups.size());
    result.setups.push_back({.name = set.name, .supports = supportsOf(set, sites)});
    for (const double y : turns(settings))
      for (const double z : turns(settings)) {
        constexpr double kDegree = EIGEN_PI / 180;
        const Vector3d gravity = Eigen::AngleAxisd(z * kDegree, Vector3d::UnitZ()) *
                                 (Eigen::AngleAxisd(y * kDegree, Vector3d::UnitY()) * initial);
        const Vector3d change = !settings.changeOnly ? gravity
                                : y == 0 && z == 0   ? Vector3d(Vector3d::Zero())
                                                     : Vector3d(gravity - initial);
        result.members.push_back({.setup = setup, .gravityMPerS2 = gravity, .gravityChangeMPerS2 = change});
      }
  }
  return result;
}

AtlasMembers packingMembers(const AtlasDesign& design, const SupportSites& sites) {
  const PackingDesignSettings& settings = design.packing;
  const int pushes = static_cast<int>(std::floor(settings.maxPushMm / settings.stepMm + 1e-9));
  AtlasMembers result;
  for (const SupportSet& set : design.supportSets)
    for (const Vector3d& place : packingSites(sites, settings.places)) {
      for (int k = 1; k <= pushes; ++k)
        result.members.push_back(
            {.setup = static_cast<int>(result.setups.size()), .pushMm = k * settings.stepMm});
      result.setups.push_back(packedSetup(set, sites, place, settings.extentMm));
    }
  return result;
}

/// The i-th of `count` evenly from low to high by their logarithm.
double levelOf(int i, int count, double low, double high) {
  return count == 1 ? std::sqrt(low * high) : low * std::pow(high / low, i / (count - 1.0));
}

AtlasMembers sampledMembers(const AtlasDesign& design, const SupportSites& sites) {
  const SampledDesignSettings& s = design.sampled;
  const Vector3d initial = kGravityMPerS2 * Vector3d(s.gravityX, s.gravityY, s.gravityZ).normalized();
  const Matrix3d frame = frameAlong(initial.normalized());
  const std::vector<Vector3d> places = packingSites(sites, s.setups);
  // Setups: places are spread already; extent, support set and stiffness are drawn evenly over them.
  const Eigen::MatrixXd ofSetup = latinHypercube(s.setups, 3, design.seed, 0);
  const auto pick = [](double u, std::size_t count) {
    return std::min(static_cast<int>(u * static_cast<double>(count)), static_cast<int>(count) - 1);
  };
  std::vector<std::vector<int>> ofLevel(static_cast<std::size_t>(s.stiffnessLevels));
  for (int k = 0; k < s.setups; ++k)
    ofLevel[static_cast<std::size_t>(pick(ofSetup(k, 2), ofLevel.size()))].push_back(k);
  AtlasMembers result;
  for (int level = 0; level < s.stiffnessLevels; ++level)
    for (const int k : ofLevel[static_cast<std::size_t>(level)]) {
      const SupportSet& set =
          design.supportSets[static_cast<std::size_t>(pick(ofSetup(k, 1), design.supportSets.size()))];
      const double extent = s.minExtentMm + (s.maxExtentMm - s.minExtentMm) * ofSetup(k, 0);
      AtlasSetup setup = packedSetup(set, sites, places[static_cast<std::size_t>(k)], extent);
      setup.stiffnessRatio = levelOf(level, s.stiffnessLevels, s.minStiffnessRatio, s.maxStiffnessRatio);
      result.setups.push_back(std::move(setup));
    }
  // Loads: push, and gravity evenly over a cap of the sphere.
  const Eigen::MatrixXd ofMember = latinHypercube(s.members, 3, design.seed, 1);
  for (int setup = 0; setup < s.setups; ++setup)
    for (int m = setup; m < s.members; m += s.setups) {
      const double cosine = 1 - ofMember(m, 1) * (1 - std::cos(s.maxTurnDeg * EIGEN_PI / 180));
      const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)),
                   around = 2 * EIGEN_PI * ofMember(m, 2);
      const Vector3d local(cosine, sine * std::cos(around), sine * std::sin(around));
      const Vector3d gravity = kGravityMPerS2 * frame.transpose() * local;
      const Vector3d change = s.maxTurnDeg > 0 ? Vector3d(gravity - initial) : Vector3d(Vector3d::Zero());
      result.members.push_back({.setup = setup,
                                .pushMm = s.minPushMm + (s.maxPushMm - s.minPushMm) * ofMember(m, 0),
                                .gravityMPerS2 = gravity,
                                .gravityChangeMPerS2 = change});
    }
  return result;
}

}  // namespace

AtlasMembers membersOf(const AtlasDesign& design, const SupportSites& sites) {
  switch (design.kind) {
    case AtlasKind::GravityDirections:
      return gravityMembers(design, sites);
    case AtlasKind::Packing:
      return packingMembers(design, sites);
    case AtlasKind::SurfaceLoads:
      throw InputError("a design of surface loads has no members; fit it with falciform update");
    case AtlasKind::Sampled:
      break;
  }
  return sampledMembers(design, sites);
}

}  // namespace falciform
