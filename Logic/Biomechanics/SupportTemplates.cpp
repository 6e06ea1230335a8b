#include "Logic/Biomechanics/SupportTemplates.h"

#include <cmath>
#include <numbers>

namespace falciform {
namespace {

constexpr double kGravityMPerS2 = 9.81;

Support support(const char* name, SupportKind kind, std::vector<int> faces, double pushMm = 0) {
  Support made;
  made.name = name;
  made.kind = kind;
  made.faces = std::move(faces);
  made.pushMm = pushMm;
  return made;
}

}  // namespace

std::vector<Support> lyingOnItsBack(const SupportSites& sites) {
  return {support("vena cava", SupportKind::Fixed, sites.venaCava),
          support("posterior bed", SupportKind::Sliding, sites.posteriorBed)};
}

std::vector<Support> leftLobePacked(const SupportSites& sites, double pushMm, double extentMm) {
  std::vector<Support> supports = lyingOnItsBack(sites);
  supports.push_back(support(
      "packing under left lobe", SupportKind::Pushed,
      packingSite(sites, centreOf(sites, sites.leftUnderside), extentMm, sites.leftUnderside), pushMm));
  return supports;
}

std::vector<Support> rightLobePacked(const SupportSites& sites, double pushMm, double extentMm) {
  return {support("vena cava", SupportKind::Fixed, sites.venaCava),
          support("packing under right lobe", SupportKind::Pushed,
                  packingSite(sites, centreOf(sites, sites.rightUnderside), extentMm, sites.rightUnderside),
                  pushMm)};
}

Vector3d gravityChangeOfTurn(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return kGravityMPerS2 * Vector3d(std::sin(angle), std::cos(angle) - 1, 0);
}

SupportHypothesis supportTemplate(const SupportSites& sites, const SupportTemplateSettings& settings) {
  checkSettings(settings);
  SupportHypothesis hypothesis;
  double turnDeg = settings.turnDeg;
  switch (settings.posture) {
    case SupportTemplate::LeftLobePacked:
      hypothesis.supports = leftLobePacked(sites, settings.pushMm, settings.extentMm);
      break;
    case SupportTemplate::RightLobePacked:
      hypothesis.supports = rightLobePacked(sites, settings.pushMm, settings.extentMm);
      break;
    case SupportTemplate::TurnedLeft:
      hypothesis.supports = lyingOnItsBack(sites);
      if (turnDeg == 0) turnDeg = kUsualTurnDeg;
      break;
  }
  hypothesis.gravityChangeMPerS2 = gravityChangeOfTurn(turnDeg);
  return hypothesis;
}

CandidateSupports candidatesOf(const SupportSites& sites) {
  CandidateSupports candidates;
  candidates.fixed = sites.venaCava;
  for (const std::vector<int>* region : {&sites.posteriorBed, &sites.leftUnderside, &sites.rightUnderside})
    candidates.sliding.insert(candidates.sliding.end(), region->begin(), region->end());
  return candidates;
}

}  // namespace falciform
