#include "Logic/Acquisition/PhantomBody.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "Logic/Acquisition/ScanScene.h"

namespace falciform {
namespace {

/// Where a sphere stands in the scanner's picture: angle from the right, downwards, and depth, mm, from the
/// liver's middle towards the scanner.
struct Stand {
  double angleDeg, towardsMm;
};
constexpr std::array<Stand, 7> kStands{
    {{8, 25}, {57, -30}, {112, 30}, {160, -10}, {206, 40}, {262, -25}, {311, 10}}};

/// Least clearance between the liver and a cone about the sight line to `centre`, mm at the liver: the cone
/// that the sphere fills in the scanner's picture, carried on behind it.
double clearance(const LiverShape& liver, const Vector3d& eye, const Vector3d& centre, double radius) {
  constexpr int kSamples = 160;
  const double length = (centre - eye).norm(),
               reach = 0.5 * (liver.bounds().row(1) - liver.bounds().row(0)).norm();
  const double from = std::max(1 - 2 * reach / length, 0.0), to = 1 + 2 * reach / length;
  double least = 1e9;
  for (int n = 0; n <= kSamples; ++n) {
    const double t = from + (to - from) * n / kSamples;
    least = std::min(least, liver.distance(eye + t * (centre - eye)) - radius * t);
  }
  return least;
}

}  // namespace

Box PhantomBody::bounds() const {
  Box box = liver.bounds();
  const double reach = sphereRadiusMm + 8;  // mm of air: no body ends at the volume's border
  for (const Vector3d& centre : spheres) {
    box.row(0) = box.row(0).cwiseMin((centre.array() - reach).matrix().transpose());
    box.row(1) = box.row(1).cwiseMax((centre.array() + reach).matrix().transpose());
  }
  return box;
}

Vector3d middleOf(const LiverShape& liver) { return liver.bounds().colwise().mean().transpose(); }

PhantomBody placeSpheres(const LiverShape& liver, double sphereRadiusMm, double gapMm,
                         const VirtualScannerSettings& scanner) {
  PhantomBody body{.liver = liver, .spheres = {}, .sphereRadiusMm = sphereRadiusMm, .beads = {}};
  const Vector3d towards = towardsScanner(scanner), eye = middleOf(liver) + scanner.distanceMm * towards;
  const Vector3d right = (-towards).cross(Vector3d::UnitZ()).normalized(), down = (-towards).cross(right);
  for (const Stand& stand : kStands) {
    const double angle = stand.angleDeg * std::numbers::pi / 180;
    const Vector3d outwards = std::cos(angle) * right + std::sin(angle) * down;
    Vector3d centre = middleOf(liver) + stand.towardsMm * towards;
    constexpr double kStep = 1, kFarthest = 1000;  // mm; the field grows without end, so the loop ends sooner
    for (double out = kStep; out < kFarthest; out += kStep) {
      const Vector3d place = middleOf(liver) + stand.towardsMm * towards + out * outwards;
      centre = place;
      if (clearance(liver, eye, place, sphereRadiusMm) > gapMm) break;
    }
    body.spheres.push_back(centre);
  }
  return body;
}

Surface meshPhantom(const PhantomBody& body, double edgeLengthMm, const Progress& progress) {
  const auto& bounds = body.liver.bounds();
  Surface all = meshImplicit([&](const Vector3d& p) { return body.liver.distance(p); }, bounds,
                             std::clamp(1.3 * edgeLengthMm, 1.3, 4.0), edgeLengthMm, progress.part(0, 0.9));
  // Chords of a sphere with edges of 1/20 of its radius lie within 1/3200 of the radius below it.
  const double fine = body.sphereRadiusMm / 20;
  const Ellipsoid ball{Vector3d::Zero(), Vector3d::Constant(body.sphereRadiusMm)};
  Box box;
  box.row(0).setConstant(-body.sphereRadiusMm - 4 * fine);
  box.row(1) = -box.row(0);
  const Surface sphere = meshImplicit([&](const Vector3d& p) { return ball.distance(p); }, box, fine, fine,
                                      progress.part(0.9, 1));

  const Index liverPoints = all.size(), liverTriangles = all.triangles.rows();
  const auto count = static_cast<Index>(body.spheres.size());
  all.points.conservativeResize(liverPoints + count * sphere.size(), 3);
  all.triangles.conservativeResize(liverTriangles + count * sphere.triangles.rows(), 3);
  all.patch.assign(static_cast<std::size_t>(all.size()), patch::kNone);
  VectorXd& source = all.arrays[structure::kArray];
  source = VectorXd::Constant(all.size(), structure::kTeflon);
  source.head(liverPoints).setConstant(structure::kOrgan);
  for (Index s = 0; s < count; ++s) {
    const Index first = liverPoints + s * sphere.size();
    const int label = patch::kFirstNamed + static_cast<int>(s);
    all.points.middleRows(first, sphere.size()) =
        sphere.points.rowwise() + body.spheres[static_cast<std::size_t>(s)].transpose();
    all.triangles.middleRows(liverTriangles + s * sphere.triangles.rows(), sphere.triangles.rows()) =
        sphere.triangles.array() + static_cast<int>(first);
    std::fill_n(all.patch.begin() + first, sphere.size(), label);
    all.patchNames[label] = "sphere " + std::to_string(s + 1);
  }
  return all;
}

}  // namespace falciform
