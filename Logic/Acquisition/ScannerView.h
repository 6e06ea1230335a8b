#pragma once
#include "Logic/Acquisition/VirtualScanner.h"

namespace falciform {

/// The scanner's camera: a pinhole at `eye` that looks along `forward`; rays are forward + u right + v down.
/// In the frame of what is scanned, mm.
struct ScannerView {
  Vector3d eye, forward, right, down;
  int rows = 0, columns = 0;  ///< kept lines and samples
  double step = 0;            ///< of u and v between neighbours that are kept
  double u0 = 0, v0 = 0;      ///< of the first kept ray

  [[nodiscard]] Vector3d ray(int row, int column) const {
    return forward + (u0 + column * step) * right + (v0 + row * step) * down;
  }
};

/// The view of a scanner that is aimed at `lookAt`.
[[nodiscard]] ScannerView aimScanner(const Vector3d& lookAt, const VirtualScannerSettings& settings);

}  // namespace falciform
