#include <functional>

#include "Logic/Core/Draws.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/Comparisons.h"
#include "Testing/Benchmarks/Peers.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Benchmarks/Table.h"
#ifdef FALCIFORM_BENCH_OPEN3D
#include "Testing/Benchmarks/Open3dPeer.h"
#endif

namespace falciform::bench {

namespace {

constexpr int kPoses = 100, kPeerPoses = 10;
constexpr double kShiftMm = 200, kNearDeg = 10, kNearMm = 15;

/// Registers the scan as moved; returns preopFromScan. The number is the pose's.
using Method = std::function<Isometry3d(const Surface& moved, int pose)>;

/// Any rotation, and a shift within a cube.
Isometry3d anyMotion(int pose) {
  Draws draws(static_cast<std::uint64_t>(pose), 31);
  Isometry3d motion = Isometry3d::Identity();
  motion.linear() = draws.rotation().toRotationMatrix();
  for (int k = 0; k < 3; ++k) motion.translation()[k] = draws.uniform(-kShiftMm, kShiftMm);
  return motion;
}

/// What brings the scan onto the pre-op surface, but for 10 deg about the scan's middle and 15 mm.
Isometry3d nearMotion(const BenchCase& c, int pose) {
  Draws draws(static_cast<std::uint64_t>(pose), 32);
  const Isometry3d answer = c.bestRigid.inverse();
  const Vector3d middle = answer * Vector3d(c.scan.points.colwise().mean().transpose());
  return Eigen::Translation3d(middle + kNearMm * draws.direction()) *
         Eigen::AngleAxisd(kNearDeg * EIGEN_PI / 180, draws.direction()) * Eigen::Translation3d(-middle) *
         answer;
}

Row timed(const std::string& who, const BenchCase& c, int poses, bool near, const Method& method) {
  Row row{who, {}, true};
  for (int pose = 1; pose <= poses; ++pose) {
    const Isometry3d motion = near ? nearMotion(c, pose) : anyMotion(pose);
    const Surface moved = transformed(c.scan, motion, "moved");
    Isometry3d preopFromMoved;
    const Spent spent = measured([&] { preopFromMoved = method(moved, pose); });
    Outcome o;
    o.errorMm = targetErrorMm(c, (preopFromMoved * motion).inverse());
    o.right = o.errorMm < c.limitMm;
    o.wallMs = spent.wallMs;
    o.cpuMs = spent.cpuMs;
    row.tally.add(o);
  }
  return row;
}

}  // namespace

void compareRegistrations(const BenchCase& c, int slowPeers) {
  const PreparedPreop preop(c.preop);
  const Method vtk = [&](const Surface& moved, int) { return vtkIcp(c.preop, moved); };
  Comparison anyPose(c.name + ": from any pose");
#ifdef FALCIFORM_BENCH_OPEN3D
  const Open3dTarget target(c.preop);
  anyPose.print(timed("Open3D FPFH + RANSAC + ICP", c, kPeerPoses, false,
                      [&](const Surface& moved, int pose) { return target.ransac(moved, pose); }));
  if (slowPeers > 1) {
    const Open3dTarget fine(c.preop, 3);
    anyPose.print(timed("the same, voxels of 3 mm, not 5", c, kPeerPoses, false,
                        [&](const Surface& moved, int pose) { return fine.ransac(moved, pose); }));
  }
  anyPose.print(timed("Open3D FPFH + FGR + ICP", c, kPeerPoses, false,
                      [&](const Surface& moved, int) { return target.fgr(moved); }));
#endif
  for (const OurMethod& ours : ourMethods())
    anyPose.print(timed(ours.name, c, kPoses, false, [&](const Surface& moved, int) {
      return registerSurfaces(preop, moved, ours.settings).scanFromPreop.inverse();
    }));
  const int slowAnyPose = slowPeers > 1 ? slowPeers : 0;
  if (slowAnyPose > 0) anyPose.print(timed("VTK ICP", c, slowAnyPose, false, vtk));
#ifdef FALCIFORM_BENCH_PCL
  const Method pcl = [&](const Surface& moved, int) { return pclIcp(c.preop, moved); };
  if (slowAnyPose > 0) anyPose.print(timed("PCL ICP", c, slowAnyPose, false, pcl));
#endif

  if (slowPeers == 0) return;

  Comparison near(c.name + ": from 10 deg, 15 mm off");
#ifdef FALCIFORM_BENCH_OPEN3D
  near.print(timed("Open3D point-to-plane ICP", c, kPeerPoses, true, [&](const Surface& moved, int) {
    return target.icp(moved, Isometry3d::Identity(), 1000, 30);
  }));
#endif
#ifdef FALCIFORM_BENCH_PCL
  near.print(timed("PCL ICP", c, slowPeers, true, pcl));
#endif
  near.print(timed("VTK ICP", c, slowPeers, true, vtk));
  RegistrationSettings icp;
  icp.method = RegistrationMethod::Icp;
  near.print(timed("ours, ICP", c, kPeerPoses, true, [&](const Surface& moved, int) {
    return registerSurfaces(preop, moved, icp).scanFromPreop.inverse();
  }));
}

}  // namespace falciform::bench
