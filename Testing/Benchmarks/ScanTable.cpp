// ./run bench scans: how well raw scans are prepared. An operating scene with known truth, and real frames of
// a depth camera. ./run bench scans --scene FOLDER writes the scene's raw scan instead.
#include <cstdio>
#include <filesystem>
#include <string>

#include "Logic/Acquisition/ScanPreparation.h"
#include "Logic/Geometry/SurfaceDistances.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Logic/Acquisition/OperatingScene.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

namespace fs = std::filesystem;
using test::OperatingScene;

std::vector<char> keptOf(const MarkedScan& marked) {
  std::vector<char> kept;
  for (const ScanMark mark : marked.marks) kept.push_back(mark == ScanMark::Kept);
  return kept;
}

double percentOf(const std::vector<char>& of, const std::vector<char>& in) {
  double all = 0, found = 0;
  for (std::size_t i = 0; i < of.size(); ++i)
    if (of[i]) {
      ++all;
      found += in[i] != 0;
    }
  return all > 0 ? 100 * found / all : 0;
}

void sceneRow(double noiseMm, double outlierShare) {
  const OperatingScene scene = test::makeOperatingScene({.noiseMm = noiseMm, .outlierShare = outlierShare});
  ScanPreparationSettings cleanOnly;
  cleanOnly.extract = false;
  const std::vector<char> clean = keptOf(markScan(scene.scan, Points(0, 3), std::nullopt, cleanOnly));
  const std::vector<char> byItself = keptOf(markScan(scene.scan, Points(0, 3), std::nullopt, {}));
  const std::vector<char> clicked =
      keptOf(markScan(scene.scan, Points(scene.onLiver.transpose()), std::nullopt, {}));
  const std::string removed =
      outlierShare > 0 ? std::to_string(100 - percentOf(scene.outlier, clean)).substr(0, 5) : "-";
  std::printf("| %.1f | %.0f | %td | %s | %.2f | %.3f | %.3f |\n", noiseMm, 100 * outlierShare,
              static_cast<std::ptrdiff_t>(scene.scan.size()), removed.c_str(), percentOf(scene.liver, clean),
              test::diceOf(byItself, scene.liver), test::diceOf(clicked, scene.liver));
}

void sceneTable() {
  std::puts(
      "| noise, mm | outliers, % | points | outliers removed, % | liver kept, % | Dice, by itself | Dice, "
      "one "
      "click |\n|---|---|---|---|---|---|---|");
  for (const double noise : {0.3, 0.5, 1.0})
    for (const double share : {0.0, 0.02, 0.05}) sceneRow(noise, share);
}

/// Frame K shows state 4 K. No colours, and nothing but liver in view: false returns alone are taken out.
void frameRow(const fs::path& folder, int k) {
  const Surface truth = readSurface(folder / ("surface_" + std::to_string(4 * k) + ".stl")).value;
  const Surface raw = readSurface(folder / ("rgbd_" + std::to_string(k) + ".rgbd")).value;
  ScanPreparationSettings settings;
  settings.extract = false;
  const MarkedScan marked = markScan(raw, Points(0, 3), std::nullopt, settings);
  const Surface scan = finishScan(marked, settings);
  const RegistrationResult fit = registerSurfaces(truth, scan, registrationPreset("default"));
  const VectorXd tracked = distancesTo(truth, scan.points);
  const VectorXd registered = distancesTo(truth, transformed(scan.points, fit.scanFromPreop.inverse()));
  std::printf("| %d | %td | %td | %.2f | %.2f | %.2f |\n", 4 * k, static_cast<std::ptrdiff_t>(raw.size()),
              static_cast<std::ptrdiff_t>(scan.size()), tracked.mean(), registered.mean(),
              registered.maxCoeff());
}

int run(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--scene") {
    fs::create_directories(argv[2]);
    OperatingScene scene = test::makeOperatingScene({.outlierShare = 0.01, .stride = 2});
    scene.scan.patch.clear();
    scene.scan.normals.resize(0, 3);
    writeSurface(fs::path(argv[2]) / "scan.ply", scene.scan, Overwrite::Replace);
    std::printf("liver at %.1f,%.1f,%.1f, falciform ligament at %.1f,%.1f,%.1f\n", scene.onLiver.x(),
                scene.onLiver.y(), scene.onLiver.z(), scene.onLigament.x(), scene.onLigament.y(),
                scene.onLigament.z());
    return 0;
  }
  sceneTable();
  const fs::path folder = test::realData() / "press";
  if (!fs::exists(folder)) {
    std::puts("\nthe real cases are not here; set FALCIFORM_DATA");
    return 0;
  }
  std::puts(
      "\n| state | points of the frame | kept | mean distance as tracked, mm | registered, mm | largest, mm "
      "|\n|---|---|---|---|---|---|");
  for (const int k : {0, 25, 50}) frameRow(folder, k);
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int argc, char** argv) { return falciform::bench::run(argc, argv); }
