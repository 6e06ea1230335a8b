// Prints the tables of Docs/DeformationTables.md: thesis Table IV.4 as printed, the same of the real livers
// of `update/`, of their Couinaud segments, and how far curvature differences can be told.
// ./run bench distance-tables

#include <cmath>
#include <cstdio>

#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/SegmentLabels.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

/// A row of thesis Table IV.4, mm.
struct PrintedRow {
  int patient;
  double mean, sd, median, greatest, least;
};

constexpr PrintedRow kThesis[] = {
    {1, -1.30, 4.20, -2.01, 18.15, -9.36},  {2, 0.74, 3.39, 0.79, 12.10, -7.60},
    {3, -0.82, 4.91, -1.85, 19.73, -19.75}, {4, -0.60, 4.32, -0.74, 8.39, -10.90},
    {5, -2.61, 4.71, -2.74, 12.79, -18.80}, {6, -1.17, 4.54, -1.44, 14.12, -13.92},
    {7, 1.61, 8.41, 0.77, 22.89, -16.40},   {8, -3.87, 4.27, -3.32, 9.33, -15.21},
    {9, -1.28, 6.20, -1.31, 18.86, -13.61}, {10, 1.35, 5.34, 2.01, 19.45, -15.61},
    {11, 0.06, 5.5, -0.71, 18.62, -12.52},  {12, 0.67, 4.73, -0.42, 19.55, -7.62}};

constexpr double kReachMm = 30;  // as far as the thesis's distances go, and some more
constexpr double kSegmentReachMm = 5;

void printThesis() {
  std::puts("| patient | mean ± SD | median | range |\n|---|---|---|---|");
  for (const PrintedRow& row : kThesis)
    std::printf("| %d | %.2f ± %.2f | %.2f | %.2f, %.2f |\n", row.patient, row.mean, row.sd, row.median,
                row.greatest, row.least);
  std::puts("");
}

/// "ircad17_both" -> the segment map of patient 17; none if it is not there.
std::filesystem::path segmentMapOf(const std::string& name) {
  const std::string patient = name.substr(5, name.find('_') - 5);
  return test::realData() / "cohort" / "couinaud" / ("3Dircadb-" + patient + ".nii.gz");
}

struct Measured {
  std::string name;
  DistanceMap map;
};

Measured measure(const std::string& name) {
  test::UpdateCase c = test::readUpdateCase(name);
  if (const std::filesystem::path file = segmentMapOf(name); std::filesystem::exists(file))
    c.preop.arrays[kCouinaudSegment] =
        labelsAtPoints(c.preop.points, readLabelMap(file).value, kSegmentReachMm);
  DistanceSettings settings;
  settings.reachMm = kReachMm;
  const RegistrationResult pose = registerSurfaces(c.preop, c.scan, {});
  return {name, mapDistances(c.preop, c.scan, pose.scanFromPreop, settings)};
}

void printRow(const std::string& name, const RegionFigures& region) {
  const DistanceStatistics& s = region.distance;
  std::printf("| %s | %s | %s | %.1f | ", name.c_str(), region.name.c_str(),
              region.areaMm2 > 0 ? std::to_string(std::lround(region.areaMm2 / 100)).c_str() : "",
              100 * region.coverage);
  if (s.count == 0) {
    std::puts("- | - | - | - | - | - |");
    return;
  }
  const DistanceStatistics& h = region.curvatureDifference;
  std::printf("%.2f ± %.2f | %.2f | %.2f, %.2f | %.2f | %.2f | ", s.mean, s.sd, s.median, s.max, s.min, s.rms,
              s.p95Absolute);
  if (h.count > 0)
    std::printf("%.4f ± %.4f |\n", h.mean, h.sd);
  else
    std::puts("- |");
}

void printHead() {
  std::puts(
      "| case | region | area, cm² | covered, % | mean ± SD, mm | median | range | RMS | P95 of magnitude | "
      "curvature difference, 1/mm |\n|---|---|---|---|---|---|---|---|---|---|");
}

void printTables(const std::vector<Measured>& cases) {
  printHead();
  for (const Measured& c : cases) printRow(c.name + ", vertices to scan", c.map.preopRegions.front());
  for (const Measured& c : cases) printRow(c.name + ", scan to surface", c.map.scanRegions.front());
  std::puts("");
  printHead();
  for (const Measured& c : cases)
    for (const RegionFigures& region : c.map.preopRegions)
      if (region.kind != RegionFigures::Kind::All && region.coverage > 0) printRow(c.name, region);
  std::puts("");
}

/// Of the curvature difference: what the liver truly did, and what a noisy scan of the liver where it truly
/// is makes of none.
void printCurvature(const std::string& name) {
  const test::UpdateCase c = test::readUpdateCase(name);
  Surface there = readSurface(test::updateCasesFolder() / name / "truth_surface.vtp").value;
  there.triangles = c.preop.triangles;
  for (const double radius : {5.0, 10.0, 15.0}) {
    DistanceSettings settings;
    settings.curvatureRadiusMm = radius;
    const DistanceMap map = mapDistances(there, c.scan, Isometry3d::Identity(), settings);
    CurvatureSettings fit;
    fit.radiusMm = radius;
    const VectorXd change = meanCurvature(there, fit) - meanCurvature(c.preop, fit);
    const VectorXd& error = map.preop.arrays.at(kCurvatureDifference);
    VectorXd truth = change;
    for (Index i = 0; i < truth.size(); ++i)
      if (std::isnan(error[i])) truth[i] = error[i];
    const DistanceStatistics t = distanceStatistics(truth), e = distanceStatistics(error);
    std::printf("| %s | %.0f | %.4f | %.4f | %.4f | %.4f |\n", name.c_str(), radius, t.meanAbsolute, t.rms,
                e.meanAbsolute, e.rms);
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace falciform

int main() {
  using namespace falciform;
  printThesis();
  if (!std::filesystem::exists(test::updateCasesFolder())) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  std::vector<Measured> cases;
  for (const std::string& name : test::updateCaseNames()) cases.push_back(measure(name));
  printTables(cases);
  std::puts(
      "| case | radius, mm | true change, mean magnitude, 1/mm | RMS | error of a scan, mean magnitude | RMS "
      "|\n"
      "|---|---|---|---|---|---|");
  for (const Measured& c : cases) printCurvature(c.name);
}
