// Prints the table of Docs/OtherRegistrationMethods.md: the methods of the literature on the real livers of
// `update/`, from starts near the answer, and ours from no start.   ./run bench methods-table

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "Logic/Registration/ClosestPointTransform.h"
#include "Logic/Registration/Dirr.h"
#include "Logic/Registration/NonRigidRegistration.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"
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

/// Mean target errors from one start, mm.
struct Errors {
  double whole = 0;
  double rigidPart = NAN;  ///< of a warp
};
using Method = std::function<Errors(const test::UpdateCase&, const PreparedPreop&, const Isometry3d& start)>;

double rigidError(const test::UpdateCase& c, const Isometry3d& scanFromPreop) {
  return targetErrors(c.targetsPreop, c.targetsScanner, scanFromPreop).mean();
}

Errors errorsOf(const test::UpdateCase& c, const PatchIcpResult& run) {
  return {rigidError(c, run.preopFromScan.inverse())};
}

Errors errorsOf(const test::UpdateCase& c, const NonRigidResult& found) {
  return {(found.scanFromPreopWarp(c.targetsPreop) - c.targetsScanner).rowwise().norm().mean(),
          rigidError(c, found.rigid.preopFromScan.inverse())};
}

PatchIcpResult icp(const test::UpdateCase& c, const PreparedPreop& preop, const Isometry3d& start) {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  const LabelledSource source{c.scan.points, std::vector<int>(static_cast<std::size_t>(c.scan.size()))};
  return runPatchIcp(preop.target(), source, settings, start);
}

std::vector<std::pair<std::string, Method>> methods() {
  using Case = test::UpdateCase;
  using Preop = PreparedPreop;
  using Pose = Isometry3d;
  return {
      {"start",
       [](const Case& c, const Preop&, const Pose& s) { return Errors{rigidError(c, s.inverse())}; }},
      {"icp", [](const Case& c, const Preop& p, const Pose& s) { return errorsOf(c, icp(c, p, s)); }},
      {"dirr", [](const Case& c, const Preop& p,
                  const Pose& s) { return errorsOf(c, registerDirr(p, c.scan, {}, s)); }},
      {"cpt", [](const Case& c, const Preop& p,
                 const Pose& s) { return errorsOf(c, registerClosestPointTransform(p, c.scan, {}, s)); }},
      {"tps", [](const Case& c, const Preop& p,
                 const Pose& s) { return errorsOf(c, registerTpsIcp(p, c.scan, {}, s)); }},
      {"rpm", [](const Case& c, const Preop& p,
                 const Pose& s) { return errorsOf(c, registerRobustPoints(p, c.scan, {}, s)); }},
      {"ours: both patches, no start",
       [](const Case& c, const Preop& p, const Pose&) {
         return Errors{rigidError(c, registerSurfaces(p, c.scan, {}).scanFromPreop)};
       }},
  };
}

/// "median (worst)".
std::string cell(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  char text[48];
  std::snprintf(text, sizeof text, " %.1f (%.1f) |", errors[errors.size() / 2], errors.back());
  return text;
}

void printTable(const std::vector<test::UpdateCase>& cases) {
  std::string header = "| method |", rule = "|---|", best = "| *optimal rigid* |";
  std::vector<PreparedPreop> prepared;
  for (const auto& c : cases) {
    char text[32];
    std::snprintf(text, sizeof text, " *%.1f* |", c.optimalRigidMm);
    header += " " + c.name + " |";
    rule += "---|";
    best += text;
    prepared.emplace_back(c.preop);
  }
  std::printf("%s time |\n%s---|\n%s |\n", header.c_str(), rule.c_str(), best.c_str());
  double icpSeconds = NAN;
  for (const auto& [name, method] : methods()) {
    std::string whole = "| " + name + " |", rigidPart = "| " + name + ", its rigid part |";
    double seconds = 0;
    bool warped = false;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const Isometry3d answer = fitRigid(cases[k].targetsScanner, cases[k].targetsPreop);
      std::vector<double> wholes, rigidParts;
      for (unsigned seed = 1; seed <= kStarts; ++seed) {
        const auto began = std::chrono::steady_clock::now();
        const Errors errors = method(cases[k], prepared[k], offBy(answer, cases[k].scan, seed));
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        wholes.push_back(errors.whole);
        rigidParts.push_back(errors.rigidPart);
      }
      warped = !std::isnan(rigidParts.front());
      whole += cell(wholes);
      if (warped) rigidPart += cell(rigidParts);
    }
    if (name == "icp") icpSeconds = seconds;
    std::printf(std::isnan(icpSeconds) ? "%s |\n" : "%s %.2f |\n", whole.c_str(), seconds / icpSeconds);
    if (warped) std::printf("%s |\n", rigidPart.c_str());
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
