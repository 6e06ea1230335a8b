#pragma once
#include <vector>

#include "Logic/Acquisition/ScanFaultSettings.h"
#include "Logic/Acquisition/ScannerView.h"

namespace falciform {

/// What a scanner's return came from; the values of the scan's array "structure".
namespace structure {
inline constexpr int kOrgan = 0, kDrape = 1, kInstrument = 2, kSmoke = 3, kTeflon = 4;
inline constexpr char kArray[] = "structure";
}  // namespace structure

/// Everything that the scanner's rays may hit, in the organ's frame.
struct ScanScene {
  Surface surface;             ///< the organ's vertices and triangles first, as they were
  std::vector<int> structure;  ///< by vertex, values of `structure`; empty: all organ
};

/// The organ with the cloth and the rods that the faults ask for. An array "structure" of its own says which
/// of its points are none of the organ. The cloth lies across the line of sight,
/// 10 mm behind the organ's centroid, and waves by some 5 mm; rods of 8 mm stand with their tips 3 to 12 mm
/// over the organ and lean outwards. Drawn by the faults' seed.
[[nodiscard]] ScanScene makeScanScene(const Surface& organ, const ScannerView& view,
                                      const ScanFaultSettings& faults);

/// mm2 of the organ itself.
[[nodiscard]] double organArea(const ScanScene& scene);

/// Whether the faults put anything into the scan that is not the organ.
[[nodiscard]] bool hasRoom(const ScanFaultSettings& faults);

/// The points of a scan that come from the organ, with the triangles between them; the whole scan where it
/// says nothing of where its points come from.
[[nodiscard]] Surface organOf(const Surface& scan);

/// How the camera sees what is there: the organ as tissueColour(), blue-green cloth, grey steel, pale
/// smoke, white Teflon.
[[nodiscard]] std::array<std::uint8_t, 3> sceneColour(int structure, const Vector3d& place, int patchLabel);

}  // namespace falciform
