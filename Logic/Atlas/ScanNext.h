#pragma once
#include "Logic/Atlas/ModelUpdate.h"

namespace falciform {

/// Where more scanning would help: by how many mm the expected error at some places (K x 3 pre-op mm, root
/// mean square over them) would fall if the surface around each load centre were scanned too, as densely as
/// the rest. One value for each of responses().centres. Small where there is a scan already. The scan's own
/// worth counts, not whether a scanner can see the place. Throws InputError without places, or as
/// expectedErrorMm does.
[[nodiscard]] VectorXd scanGainMm(const UpdateModel& model, const UpdateResult& update,
                                  const Points& preopMm);

}  // namespace falciform
