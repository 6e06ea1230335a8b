#include "Logic/Acquisition/ScannerView.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace falciform {

namespace {

constexpr double kRadians = std::numbers::pi / 180;

}  // namespace

Vector3d towardsScanner(const VirtualScannerSettings& s) {
  const double az = s.azimuthDeg * kRadians, el = s.elevationDeg * kRadians;
  // LPS: the front is -y, the patient's right is -x, the head is +z.
  return {-std::sin(az) * std::cos(el), -std::cos(az) * std::cos(el), std::sin(el)};
}

ScannerView aimScanner(const Vector3d& lookAt, const VirtualScannerSettings& s) {
  ScannerView view;
  const Vector3d outwards = towardsScanner(s);
  view.eye = lookAt + s.distanceMm * outwards;
  view.forward = -outwards;
  view.right = view.forward.cross(Vector3d::UnitZ()).normalized();
  view.down = view.forward.cross(view.right);
  // The window keeps the central share of lines and samples, the stride every n-th of these.
  const auto kept = [&](int count) {
    return (static_cast<int>(std::ceil(count * s.windowShare)) + s.stride - 1) / s.stride;
  };
  view.rows = kept(s.lines);
  view.columns = kept(s.samples);
  const double side = 2 * std::tan(0.5 * s.fieldOfViewDeg * kRadians);
  view.step = side / std::max(s.lines, s.samples) * s.stride;
  view.u0 = -0.5 * view.step * (view.columns - 1);
  view.v0 = -0.5 * view.step * (view.rows - 1);
  return view;
}

}  // namespace falciform
