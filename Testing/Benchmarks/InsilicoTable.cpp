// ./run bench update-insilico: one liver bent by another group (LiverMatch), over size of bending, visible
// share and noise. Truth at all surface vertices; each scan moved rigidly by a drawn pose first; no patches,
// no start.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Registration/PointRegistration.h"
#include "Testing/Benchmarks/UpdateTrial.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kReachMm = 200;

/// The numbers N of the files PREFIX N SUFFIX in a folder, as they are written, ascending.
std::vector<std::string> numbersIn(const fs::path& folder, const std::string& prefix,
                                   const std::string& suffix) {
  std::vector<std::string> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > prefix.size() + suffix.size() && name.starts_with(prefix) && name.ends_with(suffix))
      found.push_back(name.substr(prefix.size(), name.size() - prefix.size() - suffix.size()));
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::stod(a) < std::stod(b); });
  return found;
}

Points pointsIn(const fs::path& file) { return readSurface(file).value.points; }

UpdateTrial movedTrial(const Points& before, const Points& after, const Surface& scan, std::uint64_t seed) {
  const Isometry3d pose = drawnPose(seed, kReachMm);
  return {transformed(scan, pose, "scanner"), before, transformed(after, pose)};
}

void printRow(const char* varied, const std::string& value, const ReadyLiver& liver,
              const UpdateTrial& trial) {
  const TrialResult r = runTrial(liver, trial, withoutPatches());
  std::printf("| %s | %s | %ld | %s | %s | %s | %.2f | %.2f | %.2f | %.2f | %d%s |\n", varied, value.c_str(),
              static_cast<long>(trial.scan.size()), withoutSpread(r.optimal, 2).c_str(),
              withoutSpread(r.registered, 2).c_str(), withoutSpread(r.updated, 2).c_str(), r.expectedMm,
              r.update.noiseMm, r.update.bendMm, r.update.minDetJ, r.update.iterations,
              r.update.converged ? "" : "!");
  std::fflush(stdout);
}

int run() {
  const fs::path root = test::realData() / "insilico";
  if (!fs::exists(root)) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  const Surface preop = readSurface(root / "deformation" / "src.ply").value;
  const ReadyLiver liver(preop);
  std::puts(
      "| varied | value | scan points | optimal rigid | registered | updated | expected | noise | bending "
      "| min det J | steps |\n|---|---|---|---|---|---|---|---|---|---|---|");
  std::uint64_t seed = 1;
  for (const std::string& d : numbersIn(root / "deformation", "gt_tf_", ".ply"))
    printRow("bending, mm", d, liver,
             movedTrial(preop.points, pointsIn(root / "deformation" / ("gt_tf_" + d + ".ply")),
                        readSurface(root / "deformation" / ("tgt_tf_" + d + ".ply")).value, seed++));
  const Points bent = pointsIn(root / "visibility" / "gt.ply");
  for (const std::string& f : numbersIn(root / "visibility", "", "_tgt.ply"))
    printRow(
        "visible share", f, liver,
        movedTrial(preop.points, bent, readSurface(root / "visibility" / (f + "_tgt.ply")).value, seed++));
  // The noisy scans were moved rigidly too; their clean copy, point by point, tells how.
  const Points clean = pointsIn(root / "noise" / "tgt.ply");
  for (const std::string& n : numbersIn(root / "noise", "tgt_tf_", ".ply")) {
    const Surface scan = readSurface(root / "noise" / ("tgt_tf_" + n + ".ply")).value;
    printRow("noise, mm", n, liver,
             movedTrial(preop.points, transformed(bent, fitRigid(clean, scan.points)), scan, seed++));
  }
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::bench::run();
}
