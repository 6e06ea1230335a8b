#pragma once
#include "Testing/Benchmarks/BenchCases.h"

namespace falciform::bench {

// The comparisons of `./run bench registration`: each prints its rows of the table.

/// All scan points among all pre-op points, at the answer and 100 mm off, 1 and 2 threads. Error: how much
/// farther than the nearest point the answer is.
void compareNeighbours(const BenchCase& c);
/// What can be made ready before the scan is there.
void comparePreparation(const BenchCase& c);
/// One iteration of the closest-point loop: a run of 11 iterations less a run of 1, over 10.
void compareIterations(const BenchCase& c);
/// Whole registrations from any pose, and closest points alone from near. `slowPeers`: starts given to VTK's
/// and PCL's ICP, which take half a minute each from afar; with 1 they get none from afar.
void compareRegistrations(const BenchCase& c, int slowPeers);

}  // namespace falciform::bench
