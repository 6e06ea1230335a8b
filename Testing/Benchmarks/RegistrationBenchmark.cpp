// Whole registrations and nearest neighbours on the built-in liver against what a user has today, in one run,
// accuracy beside time.
//   ./run bench registration

#include <benchmark/benchmark.h>

#include <flann/flann.hpp>
#include <random>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/Peers.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

/// The built-in liver (about 60,000 points) and a scan of it (about 18,000) from a random pose, with the
/// truth.
struct BenchCase {
  Surface preop;
  VirtualScan scan;
};

const BenchCase& benchCase() {
  static const BenchCase made = [] {
    BenchCase c;
    c.preop = makeSyntheticLiver({}).surface;
    c.scan = scanSurface(c.preop, {});
    return c;
  }();
  return made;
}

/// A motion of the given turn and shift: what a start is off by.
Isometry3d startNear(double angleDeg, double shiftMm) {
  Isometry3d off = Isometry3d::Identity();
  off.rotate(Eigen::AngleAxisd(angleDeg * EIGEN_PI / 180, Vector3d(1, 2, -1).normalized()));
  off.translation() = shiftMm * Vector3d(1, -1, 0.5).normalized();
  return off;
}

void report(benchmark::State& state, const Isometry3d& scanFromPreop, const Isometry3d& truth) {
  const BenchCase& c = benchCase();
  state.counters["error_mm"] =
      (transformed(c.preop.points, scanFromPreop) - transformed(c.preop.points, truth))
          .rowwise()
          .norm()
          .mean();
  state.counters["preop"] = static_cast<double>(c.preop.size());
  state.counters["scan"] = static_cast<double>(c.scan.scan.size());
}

/// From the scanner's own random pose, nothing told.
void FalciformPatches(benchmark::State& state) {
  const BenchCase& c = benchCase();
  RegistrationResult result;
  for (auto _ : state) result = registerSurfaces(c.preop, c.scan.scan, {});
  report(state, result.scanFromPreop, c.scan.scanFromPreop);
}
BENCHMARK(FalciformPatches)->Unit(benchmark::kMillisecond)->MinTime(3)->UseRealTime();

/// Closest points alone, from a start 10 deg and 15 mm off, as the peers below.
void FalciformIcpNear(benchmark::State& state) {
  const BenchCase& c = benchCase();
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.start = RegistrationStart::Given;
  RegistrationResult result;
  for (auto _ : state)
    result = registerSurfaces(c.preop, c.scan.scan, settings, c.scan.scanFromPreop * startNear(10, 15));
  report(state, result.scanFromPreop, c.scan.scanFromPreop);
}
BENCHMARK(FalciformIcpNear)->Unit(benchmark::kMillisecond)->MinTime(2)->UseRealTime();

template <Isometry3d (*peer)(const Surface&, const Surface&)>
void peerFrom(benchmark::State& state, const Isometry3d& offset, bool fromScannerPose) {
  const BenchCase& c = benchCase();
  Surface scan = c.scan.scan;
  Isometry3d start = Isometry3d::Identity();
  if (!fromScannerPose) start = (c.scan.scanFromPreop * offset).inverse();
  scan = transformed(scan, start, "start");
  Isometry3d preopFromStart = Isometry3d::Identity();
  for (auto _ : state) preopFromStart = peer(c.preop, scan);
  report(state, (preopFromStart * start).inverse(), c.scan.scanFromPreop);
}

void VtkIcpNear(benchmark::State& state) { peerFrom<bench::vtkIcp>(state, startNear(10, 15), false); }
void VtkIcpAnyPose(benchmark::State& state) { peerFrom<bench::vtkIcp>(state, {}, true); }
BENCHMARK(VtkIcpNear)->Unit(benchmark::kMillisecond)->Iterations(2)->UseRealTime();
BENCHMARK(VtkIcpAnyPose)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();
#ifdef FALCIFORM_BENCH_PCL
void PclIcpNear(benchmark::State& state) { peerFrom<bench::pclIcp>(state, startNear(10, 15), false); }
void PclIcpAnyPose(benchmark::State& state) { peerFrom<bench::pclIcp>(state, {}, true); }
BENCHMARK(PclIcpNear)->Unit(benchmark::kMillisecond)->Iterations(2)->UseRealTime();
BENCHMARK(PclIcpAnyPose)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();
#endif

/// One thread, all scan points among all pre-op points, `state.range(0)` mm away from the answer.
Points queriesAt(double offMm) {
  const BenchCase& c = benchCase();
  Isometry3d pose = c.scan.scanFromPreop.inverse();
  pose.pretranslate(Vector3d(offMm, 0, 0));
  return transformed(c.scan.scan.points, pose);
}

void NeighboursOurs(benchmark::State& state) {
  const KdTree tree(benchCase().preop.points);
  const Points queries = queriesAt(static_cast<double>(state.range(0)));
  for (auto _ : state)
    for (Index i = 0; i < queries.rows(); ++i)
      benchmark::DoNotOptimize(tree.nearest(queries.row(i).transpose()));
}
BENCHMARK(NeighboursOurs)->Arg(0)->Arg(100)->Unit(benchmark::kMillisecond);

void NeighboursFlann(benchmark::State& state) {
  Points points = benchCase().preop.points, queries = queriesAt(static_cast<double>(state.range(0)));
  const auto n = static_cast<std::size_t>(points.rows()), m = static_cast<std::size_t>(queries.rows());
  flann::Index<flann::L2_Simple<double>> tree(flann::Matrix<double>(points.data(), n, 3),
                                              flann::KDTreeSingleIndexParams(10));
  tree.buildIndex();
  std::vector<int> ids(m);
  std::vector<double> distances(m);
  flann::Matrix<int> idMatrix(ids.data(), m, 1);
  flann::Matrix<double> distanceMatrix(distances.data(), m, 1);
  for (auto _ : state)
    tree.knnSearch(flann::Matrix<double>(queries.data(), m, 3), idMatrix, distanceMatrix, 1,
                   flann::SearchParams(-1));
}
BENCHMARK(NeighboursFlann)->Arg(0)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace falciform

BENCHMARK_MAIN();
