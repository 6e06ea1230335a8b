#include "Logic/Registration/PatchIcp.h"
#include "Logic/Registration/PreparedPreop.h"
#include "Testing/Benchmarks/Comparisons.h"
#include "Testing/Benchmarks/Peers.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Benchmarks/Table.h"
#ifdef FALCIFORM_BENCH_OPEN3D
#include "Testing/Benchmarks/Open3dPeer.h"
#endif

namespace falciform::bench {

namespace {

constexpr int kRuns = 3, kMore = 10;

/// `run(k)` makes k iterations.
template <class Run>
Row perIteration(const std::string& who, Run&& run) {
  Row row{who, {}, false};
  for (int repeat = 0; repeat < kRuns; ++repeat) {
    const Spent one = measured([&] { run(1); }), many = measured([&] { run(1 + kMore); });
    row.tally.addTime((many.wallMs - one.wallMs) / kMore, (many.cpuMs - one.cpuMs) / kMore);
  }
  return row;
}

}  // namespace

void comparePreparation(const BenchCase& c) {
  Row ours{"ours", {}, false};
  for (int run = 0; run < kRuns; ++run) {
    const Spent spent = measured([&] { const PreparedPreop made(c.preop); });
    ours.tally.addTime(spent.wallMs, spent.cpuMs);
  }
  std::vector<Row> rows{ours};
#ifdef FALCIFORM_BENCH_OPEN3D
  Row open3d{"Open3D", {}, false};
  for (int run = 0; run < kRuns; ++run) {
    const Spent spent = measured([&] { const Open3dTarget made(c.preop); });
    open3d.tally.addTime(spent.wallMs, spent.cpuMs);
  }
  rows.push_back(open3d);
#endif
  printRows(c.name + ": preparing the pre-op side", rows, "Open3D");
}

void compareIterations(const BenchCase& c) {
  const PreparedPreop preop(c.preop);
  const Isometry3d start =
      c.bestRigid.inverse() * Eigen::Translation3d(9, -9, 9) * Eigen::AngleAxisd(0.17, Vector3d::UnitX());
  const Surface near = transformed(c.scan, start, "start");
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.motionToleranceMm = 1e-9;  // so that it does not stop before
  const LabelledSource source{near.points, std::vector<int>(static_cast<std::size_t>(near.size()), 0)};
  std::vector<Row> rows{perIteration("ours", [&](int k) {
    settings.maxIterations = k;
    (void)runPatchIcp(preop.target(), source, settings, Isometry3d::Identity());
  })};
  rows.push_back(perIteration("VTK", [&](int k) { (void)vtkIcp(c.preop, near, k); }));
#ifdef FALCIFORM_BENCH_PCL
  rows.push_back(perIteration("PCL", [&](int k) { (void)pclIcp(c.preop, near, k); }));
#endif
#ifdef FALCIFORM_BENCH_OPEN3D
  const Open3dTarget target(c.preop);
  rows.push_back(
      perIteration("Open3D", [&](int k) { (void)target.icp(near, Isometry3d::Identity(), k, 30); }));
#endif
  printRows(c.name + ": one iteration", rows, "Open3D");
}

}  // namespace falciform::bench
