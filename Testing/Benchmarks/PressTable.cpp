// ./run bench update-press: a liver pressed in steps by another group, updated from virtual scans of one side
// and from the depth camera's frames. Truth at all nodes of the pressed mesh, which is not ours. No patches,
// no start; the virtual scans are moved rigidly by a drawn pose.
#include <cstdio>
#include <filesystem>
#include <string>

#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Benchmarks/PressedLiverFiles.h"
#include "Testing/Benchmarks/UpdateTrial.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

namespace fs = std::filesystem;

struct View {
  const char* name;
  double azimuthDeg, elevationDeg;
};
/// The depth camera's side, and the other one.
constexpr View kViews[] = {{"camera's side", 0, -80}, {"other side", 0, 80}};

class PressedLiver {
 public:
  explicit PressedLiver(fs::path folder) : folder_(std::move(folder)), preop_(surface(0)), liver_(preop_) {}

  [[nodiscard]] Surface surface(int state) const {
    return readSurface(folder_ / ("surface_" + std::to_string(state) + ".stl")).value;
  }
  [[nodiscard]] Points nodes(int state) const {
    return readNodes(folder_ / ("volume_" + std::to_string(state) + ".vtk"));
  }
  [[nodiscard]] UpdateTrial scanned(int state, const View& view, double& coverage) const {
    VirtualScannerSettings scanner;
    scanner.azimuthDeg = view.azimuthDeg;
    scanner.elevationDeg = view.elevationDeg;
    scanner.windowShare = 1;
    scanner.seed = state + 1;
    VirtualScan seen = scanSurface(surface(state), scanner);
    coverage = seen.coverage;
    return {std::move(seen.scan), nodes(0), transformed(nodes(state), seen.scanFromPreop)};
  }
  /// Frame K shows state 4 K.
  [[nodiscard]] UpdateTrial filmed(int k) const {
    const std::string number = std::to_string(k);
    return {readDepthFrame(folder_ / ("rgbd_" + number + ".rgbd")), nodes(0), nodes(4 * k)};
  }
  [[nodiscard]] const ReadyLiver& ready() const { return liver_; }

 private:
  fs::path folder_;
  Surface preop_;
  ReadyLiver liver_;
};

void printRow(int state, const char* scan, double coverage, const TrialResult& r) {
  const std::string seen = coverage > 0 ? std::to_string(static_cast<int>(100 * coverage + 0.5)) + " %" : "";
  std::printf("| %d | %s | %s | %s | %s | %s | %.2f | %.2f | %.1f | %.2f | %d%s |\n", state, scan,
              seen.c_str(), withoutSpread(r.optimal, 2).c_str(), withoutSpread(r.registered, 2).c_str(),
              withoutSpread(r.updated, 2).c_str(), r.expectedMm, r.update.noiseMm, r.update.bendMm,
              r.update.minDetJ, r.update.iterations, r.update.converged ? "" : "!");
  std::fflush(stdout);
}

int run() {
  const fs::path folder = test::realData() / "press";
  if (!fs::exists(folder)) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  const PressedLiver liver(folder);
  std::puts(
      "| state | scan | coverage | optimal rigid | registered | updated | expected | noise | bending | min "
      "det J | steps |\n|---|---|---|---|---|---|---|---|---|---|---|");
  for (const View& view : kViews)
    for (const int state : {25, 50, 75, 100, 125, 150, 175, 200}) {
      double coverage = 0;
      const UpdateTrial trial = liver.scanned(state, view, coverage);
      printRow(state, view.name, coverage, runTrial(liver.ready(), trial, withoutPatches()));
    }
  for (const int k : {0, 25, 50}) {
    const UpdateTrial trial = liver.filmed(k);
    printRow(4 * k, "depth camera", 0, runTrial(liver.ready(), trial, withoutPatches()));
    printRow(4 * k, "depth camera, tracked", 0, runTrialFrom(liver.ready(), trial, Isometry3d::Identity()));
  }
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::bench::run();
}
