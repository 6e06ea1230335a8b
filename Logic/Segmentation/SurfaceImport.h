#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/Segmentation/SurfaceQuality.h"

namespace falciform {

/// How a label map becomes a clean surface.
struct SurfaceImportSettings {
  std::vector<int> labels;       ///< values that are the organ; empty: every value above 0
  bool largestComponent = true;  ///< keep the largest 6-connected piece only
  bool fillCavities = true;      ///< background that the organ encloses becomes organ
  int smoothingIterations = 30;  ///< windowed-sinc iterations
  double passBand = 0.03;        ///< windowed-sinc pass band, lower is smoother
  double edgeLengthMm = 0;       ///< mean edge length aimed at; 0 keeps marching cubes' own triangles
};

template <class Visitor>
void describe(SurfaceImportSettings& s, Visitor&& field) {
  field(FieldInfo{"labels", "Labels", "", 0, 65535,
                  "Values that are the organ; none means every value above 0."},
        s.labels);
  field(FieldInfo{"largestComponent", "Largest piece only", "", 0, 1, "Drop every piece but the largest."},
        s.largestComponent);
  field(FieldInfo{"fillCavities", "Fill cavities", "", 0, 1,
                  "Fill holes that the organ encloses on all sides."},
        s.fillCavities);
  field(FieldInfo{"smoothingIterations", "Smoothing iterations", "", 0, 200,
                  "Windowed-sinc iterations; 0 leaves the voxel steps."},
        s.smoothingIterations);
  field(FieldInfo{"passBand", "Pass band", "", 0.001, 2, "Windowed-sinc pass band; lower is smoother."},
        s.passBand);
  field(FieldInfo{"edgeLengthMm", "Edge length", "mm", 0, 50,
                  "Mean edge length aimed at; 0 keeps one triangle a voxel face."},
        s.edgeLengthMm);
}

struct SurfaceImportResult {
  Surface surface;  ///< closed manifold, LPS mm, triangles outwards
  TopologyReport topology;
  SurfaceQuality quality;     ///< beside the voxels it was made of
  double voxelVolumeMm3 = 0;  ///< selected voxels (after component and cavities) x voxel volume
  double surfaceVolumeMm3 = 0;
  std::size_t selectedVoxels = 0, droppedVoxels = 0, filledVoxels = 0;
  std::vector<std::string> warnings;  ///< touches the volume's border, pieces dropped, ...
};

/// Label map -> surface (thesis ch. II, "Pre-operative image data"): selection, largest component, marching
/// cubes, windowed-sinc smoothing with the volume kept within 1 %, remeshing to the edge length, closed
/// manifold checked. The grid is first brought to axes nearest LPS, so that the same volume stored flipped or
/// permuted gives the same surface. Throws InputError if a label is not there, the map is empty, or its
/// extent is not that of an organ in mm.
[[nodiscard]] SurfaceImportResult importSurface(const LabelMap& map, const SurfaceImportSettings& settings,
                                                const Progress& progress = {});

/// Distinct values above 0 and their voxel counts, ascending.
[[nodiscard]] std::vector<std::pair<int, std::size_t>> labelCounts(const LabelMap& map);

/// The same volume with axes permuted and flipped so that i, j, k run nearest to L, P, S. World positions are
/// unchanged.
[[nodiscard]] LabelMap canonicalAxes(const LabelMap& map);

}  // namespace falciform
