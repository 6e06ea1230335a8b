#pragma once
#include "Logic/Acquisition/PhantomBody.h"

namespace falciform {

/// Hounsfield units of the phantom's materials at 120 kV: nominal values, air by definition.
namespace phantom {
inline constexpr double kAirHu = -1000, kSiliconeHu = 250, kTeflonHu = 950, kSteelHu = 20000;
/// The largest value that a CT of 12 bits stores: steel is cut there.
inline constexpr double kLargestHu = 3071;
/// Above both plastics and below the least that a voxel next to a bead of 1 mm holds at voxels of 1.1 mm.
inline constexpr double kBeadLevel = 1200;
/// Half-way between air and silicone, and between air and Teflon: where their surfaces run.
inline constexpr double kSiliconeLevel = 0.5 * (kAirHu + kSiliconeHu),
                        kTeflonLevel = 0.5 * (kAirHu + kTeflonHu);
/// Labels of labelPhantom.
inline constexpr int kSiliconeLabel = 1, kTeflonLabel = 2;
}  // namespace phantom

/// CT of the phantom, cubic voxels: each holds a weighted mean of what it sees (partial volume, one voxel's
/// edge to either side) and normal noise, rounded to whole units and cut at kLargestHu as a CT stores them.
[[nodiscard]] Image imagePhantom(const PhantomBody& body, double voxelMm, double noiseHu, int seed,
                                 const Progress& progress = {});

/// The silicone's surface: marching cubes at phantom::kSiliconeLevel, the piece with the largest area, with
/// normals. Grey values place it between the voxels' centres.
[[nodiscard]] Surface siliconeSurface(const Image& ct);

/// Voxels above phantom::kSiliconeLevel: Teflon within `sphereRadiusMm` + 3 mm of a located sphere, silicone
/// elsewhere.
[[nodiscard]] LabelMap labelPhantom(const Image& ct, const std::vector<Vector3d>& spheres,
                                    double sphereRadiusMm);

}  // namespace falciform
