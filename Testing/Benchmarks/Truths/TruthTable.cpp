#include "Testing/Benchmarks/Truths/TruthTable.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Crossings.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/SurfaceFiles.h"

namespace falciform::bench {
namespace {

/// A pack as "38 mm, slides": what reached the liver, which is the drawn push by the share of the load.
std::string pack(const nlohmann::json& truth, const char* name) {
  const nlohmann::json& drawn = truth.at("drawn");
  if (!drawn.contains(name)) return "";
  const double share = truth.at("load_share").get<double>();
  char text[64];
  std::snprintf(text, sizeof text, "%.0f over %.0f, %s", drawn[name].at("push_mm").get<double>() * share,
                2 * drawn[name].at("extent_mm").get<double>(),
                drawn[name].at("sticks").get<bool>() ? "sticks" : "slides");
  return text;
}

std::string held(const nlohmann::json& truth) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f%s%s", 100 * truth.at("held_share").get<double>(),
                truth.at("drawn").at("vena_cava_held").get<bool>() ? " c" : "",
                truth.at("drawn").at("ligament_held").get<bool>() ? " l" : "");
  return text;
}

/// Pairs of triangles that cut through each other, before and after: imported surfaces have some in narrow
/// fissures.
std::string crossings(const std::filesystem::path& folder) {
  return std::to_string(selfCrossings(readSurface(folder / "preop.vtp").value).size()) + ", " +
         std::to_string(selfCrossings(readSurface(folder / "truth_surface.vtp").value).size());
}

std::string row(const std::string& name, const nlohmann::json& truth, const std::string& crossing) {
  const nlohmann::json& drawn = truth.at("drawn");
  const auto number = [](const nlohmann::json& from, const char* key) { return from.at(key).get<double>(); };
  char text[512];
  std::snprintf(text, sizeof text,
                "| %s | %.1f | %s | %s | %.0f | %s | %.2f | %.1f | %.1f | %.2f | %.2f | %.2f | %.1f | %.1f | "
                "%d, %d | %s |\n",
                name.c_str(), number(drawn, "liver_kpa"), pack(truth, "pack_left").c_str(),
                pack(truth, "pack_right").c_str(), number(drawn, "gravity_turn_deg"), held(truth).c_str(),
                number(truth, "load_share"), number(truth, "target_displacement_mean_mm"),
                number(truth, "target_displacement_max_mm"),
                number(truth, "optimal_rigid_target_error_mean_mm"), number(truth, "min_det_j"),
                number(truth, "coverage"), number(truth, "noise_mm"), 100 * number(truth, "outlier_fraction"),
                truth.at("scan_patch_points").at(1).get<int>(),
                truth.at("scan_patch_points").at(2).get<int>(), crossing.c_str());
  return text;
}

}  // namespace

std::string truthTable(const std::filesystem::path& cases) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(cases, ignored))
    if (entry.path().extension() != ".unfinished" && std::filesystem::exists(entry.path() / "truth.json"))
      names.push_back(entry.path().filename().string());
  if (names.empty())
    throw InputError("'" + cases.string() + "' holds no case: make some with make-truths --out " +
                     cases.string());
  std::sort(names.begin(), names.end());
  std::string table =
      "| case | liver kPa | left pack mm | right pack mm | turned deg | held % | load | targets moved mm | "
      "farthest mm | optimal rigid mm | min det J | coverage | noise mm | outliers % | scan points, patches "
      "1, 2 | crossing pairs |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  double moved = 0, rigid = 0;
  for (const std::string& name : names) {
    const nlohmann::json truth = readJsonFile(cases / name / "truth.json");
    table += row(name, truth, crossings(cases / name));
    moved += truth.at("target_displacement_mean_mm").get<double>();
    rigid += truth.at("optimal_rigid_target_error_mean_mm").get<double>();
  }
  const auto count = static_cast<double>(names.size());
  char means[128];
  std::snprintf(means, sizeof means,
                "\n%zu cases; targets moved %.1f mm, optimal rigid error %.2f mm on average.\n", names.size(),
                moved / count, rigid / count);
  return table + means;
}

}  // namespace falciform::bench
