#include "Logic/Acquisition/LiverShape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Logic/Core/Draws.h"

namespace falciform {
namespace {

/// The liver whose places and lengths stand in this file, mm.
constexpr double kWidth = 210, kDepth = 150, kHeight = 160, kLeftShare = 0.35;

struct Dent {
  double x, y, widthX, widthY, mm;  ///< nominal centre and widths, depth upwards into the liver
};
/// Impressions of the neighbours on the visceral surface. The gallbladder's fossa and the fissure come apart
/// from these.
constexpr Dent kImpressions[] = {
    {-22, 14, 24, 13, 13},    // porta hepatis
    {-80, 58, 32, 28, 24},    // right kidney
    {-62, -34, 24, 20, 6},    // colon
    {-120, -12, 24, 30, -9},  // the right lobe's lower tip hangs down
    {46, -22, 26, 22, 7},     // stomach
    {22, 22, 14, 22, 10},     // oesophagus and cardia
};

}  // namespace

LiverShape::LiverShape(const SyntheticLiverSettings& settings) {
  // Sizes vary by half of what details may, so that the volume stays that of a liver.
  Draws draws(static_cast<std::uint64_t>(settings.seed), 1);
  const auto vary = [&](double value, double share) {
    return value * (1 + settings.variation * draws.uniform(-share, share));
  };
  const double width = vary(settings.widthMm, 0.5), depth = vary(settings.depthMm, 0.5),
               height = vary(settings.heightMm, 0.5),
               leftShare = std::clamp(vary(settings.leftLobeShare, 1), 0.15, 0.65);
  grooveDepth_ = vary(settings.grooveDepthMm, 1);
  ridgeRadius_ = vary(settings.ridgeRadiusMm, 1);
  fossaDepth_ = vary(settings.fossaDepthMm, 1);
  const double dome = vary(settings.domeShare, 0.5);
  tilt_ = settings.variation * draws.uniform(-0.5, 0.5);
  for (Wave& wave : waves_) {
    wave.k = draws.direction() * (2 * std::numbers::pi / draws.uniform(90, 180));
    wave.phase = draws.uniform(0, 2 * std::numbers::pi);
    wave.mm = settings.variation * draws.uniform(2, 8);
  }

  scale_ = {width / kWidth, depth / kDepth, height / kHeight};
  leftScale_ = leftShare / kLeftShare;
  rightScale_ = (1 - leftShare) / (1 - kLeftShare);

  // Each body reaches from its right to its left end, wherever the falciform groove divides the width.
  const auto span = [&](DomedBody& body, double rightEnd, double leftEnd, double y, double z) {
    const double from = place(rightEnd, 0, 0).x(), to = place(leftEnd, 0, 0).x();
    body.centre = {0.5 * (from + to), y * scale_.y(), z * scale_.z()};
    body.radii.x() = 0.5 * (to - from);
  };
  span(right_, -136, 8, 4, -2);
  right_.radii.tail<2>() << 72 * scale_.y(), 80 * scale_.z() * dome;
  right_.radiusBelow = 122 * scale_.z();
  right_.exponent = 2.3;
  span(left_, -124, 76, -22, 10);
  left_.radii.tail<2>() << 48 * scale_.y(), 52 * scale_.z();
  left_.radiusBelow = 110 * scale_.z();
  left_.rise = 0.10 * scale_.z() / scale_.x();
  left_.sweep = 0.15 * scale_.y() / scale_.x();

  double air = 15;  // mm, for the blends, and room for a grid's border
  for (const Wave& wave : waves_) air += wave.mm;
  const Eigen::Matrix<double, 2, 3> right = right_.box(), left = left_.box();
  bounds_.row(0) = right.row(0).cwiseMin(left.row(0)).array() - air;
  bounds_.row(1) = right.row(1).cwiseMax(left.row(1)).array() + air;
}

Vector3d LiverShape::place(double x, double y, double z) const {
  return {x * scale_.x() * (x < 0 ? rightScale_ : leftScale_), y * scale_.y(), z * scale_.z()};
}

double LiverShape::bumps(const Vector3d& p) const {
  double mm = 0;
  for (const Wave& wave : waves_)
    if (wave.mm > 0) mm += wave.mm * std::sin(wave.k.dot(p) + wave.phase);
  return mm;
}

double LiverShape::leftOfGroove(const Vector3d& p) const {
  // The attachment leans to the left on its way up, in a slight curve.
  const double z = p.z() / scale_.z() + 20;
  return p.x() - 0.18 * z + 3 * std::sin(z * 0.045);
}

double LiverShape::grooveStrength(const Vector3d& p) const {
  return 1 - smoothStep(-30, 0, p.y() / scale_.y());
}

double LiverShape::diaphragmatic(const Vector3d& p) const {
  double d = smoothUnion(right_.distance(p), left_.distance(p), 45);
  const double groove = leftOfGroove(p);
  if (std::abs(groove) < 30) d += grooveDepth_ * bell(groove, 6) * grooveStrength(p);
  // The heart's impression on top of the left half.
  const Vector3d heart = p - place(26, -14, 68);
  d += 7 * bell(heart.x(), 26) * bell(heart.y(), 24) * bell(heart.z(), 25);
  // The bed of the vena cava, high on the back.
  const Vector3d cava = place(-18, 62, 0);
  d = smoothDifference(d, std::hypot(p.x() - cava.x(), p.y() - cava.y()) - 16, 24);
  return d;
}

double LiverShape::visceralHeight(double x, double y) const {
  // To nominal coordinates: impressions keep their places among the lobes.
  const double u = x / (scale_.x() * (x < 0 ? rightScale_ : leftScale_)), v = y / scale_.y();
  double z =
      -11 + (0.52 + tilt_) * (u < 0 ? u : 0.9 * u) + 0.40 * (v + 20) - 0.0022 * std::pow(std::max(v, 0.0), 2);
  for (const Dent& dent : kImpressions)
    z += dent.mm * bell(u - dent.x, dent.widthX) * bell(v - dent.y, dent.widthY);
  // The gallbladder's fossa, from the margin to the porta hepatis.
  const double along = smoothStep(-90, -40, v) * (1 - smoothStep(-8, 12, v));
  z += 1.7 * fossaDepth_ * bell(u + 38 - 0.3 * (v + 40), 11) * along;
  // The fissure of the round ligament, from the notch to the porta hepatis.
  z += (6 + 1.2 * grooveDepth_) * bell(u + 1 - 0.12 * (v + 50) + 0.0016 * (v + 50) * (v + 50), 6.5) *
       (1 - smoothStep(-5, 25, v));
  return z * scale_.z();
}

double LiverShape::visceral(const Vector3d& p) const {
  constexpr double kStep = 0.5;
  const double z = visceralHeight(p.x(), p.y());
  const double dx = (visceralHeight(p.x() + kStep, p.y()) - z) / kStep,
               dy = (visceralHeight(p.x(), p.y() + kStep) - z) / kStep;
  return (z - p.z()) / std::sqrt(1 + dx * dx + dy * dy);
}

double LiverShape::distance(const Vector3d& p) const {
  return roundIntersection(diaphragmatic(p), visceral(p), ridgeRadius_) + bumps(p);
}

Vector3d LiverShape::normal(const Vector3d& p) const {
  constexpr double kStep = 1e-3;  // mm
  Vector3d g;
  for (int k = 0; k < 3; ++k) {
    const Vector3d step = kStep * Vector3d::Unit(k);
    g[k] = distance(p + step) - distance(p - step);
  }
  return g.normalized();
}

}  // namespace falciform
