#pragma once
#include <functional>
#include <string>

#include "Logic/Atlas/AtlasBuilding.h"
#include "Modules/Distributed/DistributedSolver.h"

namespace falciform::distributed {

/// What solveBatches (Logic/Atlas/AtlasSolves.h) does, by all ranks together, one set of grids a setup. On
/// the first rank calls `done(batch, fields)`, in `batches`' order; `told` hears of every solve there. Throws
/// InputError, on all ranks, for supports that do not hold the liver, if `done` does, and if an iteration
/// does not get there.
void solveTogether(const Ranks& ranks, const AtlasJob& job, const std::vector<int>& batches,
                   const IterationPlan& plan,
                   const std::function<void(int batch, std::vector<Points> fields)>& done,
                   const std::function<void(const std::string& line)>& told = {});

}  // namespace falciform::distributed
