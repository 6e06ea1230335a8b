#pragma once

namespace falciform {

/// Wu's compactly supported radial function, C2 and positive definite in space, scaled to 1 at the centre:
/// (1 - r)^4 (1 + 4 r + 3 r^2 + 3/4 r^3) for r < 1, 0 beyond (Wu 1995; thesis eq. IV.1).
[[nodiscard]] inline double wu(double r) {
  if (r >= 1) return 0;
  const double rest = (1 - r) * (1 - r);
  return rest * rest * (1 + r * (4 + r * (3 + r * 0.75)));
}

/// Its slope divided by r, finite at the centre: the gradient of wu(|x|) is wuSlope(|x|) x.
[[nodiscard]] inline double wuSlope(double r) {
  if (r >= 1) return 0;
  const double rest = 1 - r;
  return -rest * rest * rest * (14 + r * (15.75 + r * 5.25));
}

}  // namespace falciform
