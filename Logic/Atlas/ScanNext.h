#pragma once
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// Array on surfaces: scanGainOnSurface, mm.
inline constexpr char kScanGain[] = "scan_here_gain_mm";

/// Where more scanning would help: by how many mm the expected error at some places (K x 3 pre-op mm, root
/// mean square over them) would fall if the surface around each load centre were scanned too, as densely as
/// the rest. One value for each of responses().centres. Small where there is a scan already. The scan's own
/// worth counts, not whether a scanner can see the place. Throws InputError without places, or as
/// expectedErrorMm does.
[[nodiscard]] VectorXd scanGainMm(const UpdateModel& model, const UpdateResult& update,
                                  const Points& preopMm);

/// The same smoothed over `surface`, pre-op N x 3 mm in, N out: a map of where to scan next for `targets`, or
/// without any for the whole liver.
[[nodiscard]] VectorXd scanGainOnSurface(const UpdateModel& model, const UpdateResult& update,
                                         const Points& targetsMm, const Points& surfaceMm);

}  // namespace falciform
