// Prints the table of Docs/OtherRegistrationMethods.md: the methods of the literature on the real livers of
// `update/`, from starts near the answer, and ours from no start.   ./run bench methods-table

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "Logic/Registration/ClosestPointTransform.h"
#include "Logic/Registration/Dirr.h"
#include "Logic/Registration/NonRigidRegistration.h"
#include "Logic/Registration/PointRegistration.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"

namespace falciform {
namespace {

constexpr int kStarts = 5;
constexpr double kTurnDeg = 10, kShiftMm = 15;

/// `preopFromScan` turned by 10 deg about an axis through the scan's middle and shifted by 15 mm, both
/// directions drawn from `seed`.
Isometry3d offBy(const Isometry3d& preopFromScan, const Surface& scan, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vector3d(x, y, z).normalized();
  };
  const Vector3d middle = preopFromScan * scan.points.colwise().mean().transpose();
  const Eigen::AngleAxisd turn(kTurnDeg * EIGEN_PI / 180, direction());
  return Eigen::Translation3d(middle + kShiftMm * direction()) * turn * Eigen::Translation3d(-middle) *
         preopFromScan;
}

/// Mean target error, mm, from one start.
using Method = std::function<double(const test::UpdateCase&, const PreparedPreop&, const Isometry3d& start)>;

double rigidError(const test::UpdateCase& c, const PatchIcpResult& run) {
  return targetErrors(c.targetsPreop, c.targetsScanner, run.preopFromScan.inverse()).mean();
}

double warpError(const test::UpdateCase& c, const NonRigidResult& found) {
  return (found.scanFromPreopWarp(c.targetsPreop) - c.targetsScanner).rowwise().norm().mean();
}

PatchIcpResult icp(const test::UpdateCase& c, const PreparedPreop& preop, const Isometry3d& start) {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  const LabelledSource source{c.scan.points, std::vector<int>(static_cast<std::size_t>(c.scan.size()))};
  return runPatchIcp(preop.target(), source, settings, start);
}

std::vector<std::pair<const char*, Method>> methods() {
  using Case = test::UpdateCase;
  using Preop = PreparedPreop;
  return {
      {"start",
       [](const Case& c, const Preop&, const Isometry3d& start) {
         return targetErrors(c.targetsPreop, c.targetsScanner, start.inverse()).mean();
       }},
      {"icp", [](const Case& c, const Preop& p, const Isometry3d& s) { return rigidError(c, icp(c, p, s)); }},
      {"dirr", [](const Case& c, const Preop& p,
                  const Isometry3d& s) { return rigidError(c, registerDirr(p, c.scan, {}, s)); }},
      {"cpt",
       [](const Case& c, const Preop& p, const Isometry3d& s) {
         return rigidError(c, registerClosestPointTransform(p, c.scan, {}, s));
       }},
      {"tps", [](const Case& c, const Preop& p,
                 const Isometry3d& s) { return warpError(c, registerTpsIcp(p, c.scan, {}, s)); }},
      {"tps, its rigid part",
       [](const Case& c, const Preop& p, const Isometry3d& s) {
         return rigidError(c, registerTpsIcp(p, c.scan, {}, s).rigid);
       }},
      {"rpm", [](const Case& c, const Preop& p,
                 const Isometry3d& s) { return warpError(c, registerRobustPoints(p, c.scan, {}, s)); }},
      {"rpm, its rigid part",
       [](const Case& c, const Preop& p, const Isometry3d& s) {
         return rigidError(c, registerRobustPoints(p, c.scan, {}, s).rigid);
       }},
      {"ours, both patches, no start",
       [](const Case& c, const Preop& p, const Isometry3d&) {
         return targetErrors(c.targetsPreop, c.targetsScanner, registerSurfaces(p, c.scan, {}).scanFromPreop)
             .mean();
       }},
  };
}

void printTable(const std::vector<test::UpdateCase>& cases) {
  std::printf("| method |");
  for (const auto& c : cases) std::printf(" %s |", c.name.c_str());
  std::printf(" time |\n|---|");
  for (std::size_t k = 0; k <= cases.size(); ++k) std::printf("---|");
  std::printf("\n| *optimal rigid* |");
  for (const auto& c : cases) std::printf(" *%.1f* |", c.optimalRigidMm);
  std::printf(" |\n");
  std::vector<PreparedPreop> prepared;
  for (const auto& c : cases) prepared.emplace_back(c.preop);
  double icpSeconds = 0;
  for (const auto& [name, method] : methods()) {
    std::printf("| %s |", name);
    double seconds = 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const test::UpdateCase& c = cases[k];
      const Isometry3d best = fitRigid(c.targetsScanner, c.targetsPreop);
      std::vector<double> errors;
      for (unsigned seed = 1; seed <= kStarts; ++seed) {
        const auto began = std::chrono::steady_clock::now();
        errors.push_back(method(c, prepared[k], offBy(best, c.scan, seed)));
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      }
      std::sort(errors.begin(), errors.end());
      std::printf(" %.1f (%.1f) |", errors[kStarts / 2], errors.back());
      std::fflush(stdout);
    }
    if (std::string_view(name) == "icp") icpSeconds = seconds;
    std::printf(icpSeconds > 0 ? " %.1f |\n" : " |\n", seconds / icpSeconds);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace falciform

int main() {
  using namespace falciform;
  if (!std::filesystem::exists(test::realData() / "update")) {
    std::puts("the real cases are not here; set FALCIFORM_DATA");
    return 2;
  }
  std::printf(
      "Mean target error, mm: median of %d starts %.0f deg and %.0f mm off the optimal rigid pose "
      "(worst of them); time as a multiple of icp's.\n\n",
      kStarts, kTurnDeg, kShiftMm);
  std::vector<test::UpdateCase> cases;
  for (const std::string& name : test::updateCaseNames()) cases.push_back(test::readUpdateCase(name));
  printTable(cases);
}
