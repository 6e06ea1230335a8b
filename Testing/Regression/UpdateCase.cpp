#include "Testing/Regression/UpdateCase.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Support/RealData.h"

namespace falciform::test {

namespace {

Points pointsFrom(const nlohmann::json& rows) {
  Points points(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t a = 0; a < 3; ++a)
      points(static_cast<Index>(i), static_cast<Index>(a)) = rows[i][a].get<double>();
  return points;
}

}  // namespace

std::filesystem::path updateCasesFolder() { return realData() / "update"; }

std::vector<std::string> updateCaseNames(const std::filesystem::path& cases) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(cases))
    if (std::filesystem::exists(entry.path() / "truth.json"))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

UpdateCase readUpdateCase(const std::string& name, const std::filesystem::path& cases) {
  const std::filesystem::path folder = cases / name;
  UpdateCase read;
  read.name = name;
  read.preop = readSurface(folder / "preop.vtp").value;
  read.scan = readSurface(folder / "scan.vtp").value;
  std::ifstream stream(folder / "truth.json");
  const nlohmann::json truth = nlohmann::json::parse(stream);
  read.targetsPreop = pointsFrom(truth.at("targets_preop_mm"));
  read.targetsScanner = pointsFrom(truth.at("targets_scanner_mm"));
  read.optimalRigidMm = truth.at("optimal_rigid_target_error_mean_mm").get<double>();
  read.coverage = truth.at("coverage").get<double>();
  return read;
}

}  // namespace falciform::test
