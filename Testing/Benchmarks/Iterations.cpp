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

template <class Run>
Row repeated(const std::string& who, Run&& run) {
  Row row{who, {}, false};
  for (int repeat = 0; repeat < kRuns; ++repeat) {
    const Spent spent = measured(run);
    row.tally.addTime(spent.wallMs, spent.cpuMs);
  }
  return row;
}

}  // namespace

void comparePreparation(const BenchCase& c) {
  Comparison table(c.name + ": preparing the pre-op side");
#ifdef FALCIFORM_BENCH_OPEN3D
  table.print(repeated("Open3D", [&] { const Open3dTarget made(c.preop); }));
#endif
  table.print(repeated("ours", [&] { const PreparedPreop made(c.preop); }));
}

void compareIterations(const BenchCase& c) {
  const PreparedPreop preop(c.preop);
  const Isometry3d start =
      c.bestRigid.inverse() * Eigen::Translation3d(9, -9, 9) * Eigen::AngleAxisd(0.17, Vector3d::UnitX());
  const Surface near = transformed(c.scan, start, "start");
  Comparison table(c.name + ": one iteration");
#ifdef FALCIFORM_BENCH_OPEN3D
  const Open3dTarget target(c.preop);
  table.print(perIteration("Open3D, to planes",
                           [&](int k) { (void)target.icp(near, Isometry3d::Identity(), k, 30); }));
#endif
#ifdef FALCIFORM_BENCH_PCL
  table.print(perIteration("PCL", [&](int k) { (void)pclIcp(c.preop, near, k); }));
#endif
  table.print(perIteration("VTK, 2,000 points to triangles", [&](int k) { (void)vtkIcp(c.preop, near, k); }));
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.motionToleranceMm = 1e-9;  // so that it does not stop before
  const LabelledSource source{near.points, std::vector<int>(static_cast<std::size_t>(near.size()), 0)};
  table.print(perIteration("ours", [&](int k) {
    settings.maxIterations = k;
    (void)runPatchIcp(preop.target(), source, settings, Isometry3d::Identity());
  }));
}

}  // namespace falciform::bench
