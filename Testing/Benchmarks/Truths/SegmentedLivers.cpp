#include "Testing/Benchmarks/Truths/SegmentedLivers.h"

#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/Benchmarks/Truths/TruthPatches.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {

LabelMap readSegments(int liver) {
  return readLabelMap(test::realData() / "cohort" / "couinaud" /
                      ("3Dircadb-" + std::to_string(liver) + ".nii.gz"))
      .value;
}

Surface importPainted(const LabelMap& segments, double edgeMm) {
  SurfaceImportSettings settings;
  settings.edgeLengthMm = edgeMm;
  Surface surface = importSurface(segments, settings).surface;
  surface.normals.resize(0, 3);
  surface.patch = paintedBySegments(surface, segments);
  return surface;
}

}  // namespace falciform::bench
