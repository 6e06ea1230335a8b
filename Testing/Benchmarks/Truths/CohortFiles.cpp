#include "Testing/Benchmarks/Truths/CohortFiles.h"

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"

namespace falciform::bench {
namespace {

Landmarks named(const Points& places, const std::string& frame) {
  Landmarks landmarks;
  landmarks.frame = frame;
  for (Index i = 0; i < places.rows(); ++i)
    landmarks.points.push_back({"target " + std::to_string(i + 1), places.row(i).transpose()});
  return landmarks;
}

}  // namespace

std::string nameOf(const CohortMember& member) { return "ircad" + std::to_string(member.liver); }

void writeCohortCase(const std::filesystem::path& folder, const CohortCaseMade& made) {
  nlohmann::json truth = truthOf(made.plan.scanner, made.preop, made.scan, made.targets);
  truth.update(
      {{"liver", "3Dircadb-" + std::to_string(made.member.liver)},
       {"group", groupOf(made.member.procedure)},
       {"procedure", kProcedureNames[static_cast<std::size_t>(made.member.procedure)]},
       {"solver", "linear elasticity, T10, turns made true (Logic/Biomechanics)"},
       {"mesh_nodes", made.meshNodes},
       {"held_share", made.heldShare},
       {"load_share", made.loadShare},
       {"min_det_j", made.minDetJ},
       {"surface_displacement_max_mm", (made.moved.points - made.preop.points).rowwise().norm().maxCoeff()},
       {"drawn", toJson(made.plan)}});
  const std::filesystem::path unfinished = folder.string() + ".unfinished";
  std::filesystem::remove_all(unfinished);
  std::filesystem::create_directories(unfinished);
  writeTruthSurfaces(unfinished, made.preop, made.moved, made.scan);
  writeLandmarks(unfinished / "targets.mrk.json", named(made.targets.preop, "LPS"), Overwrite::Replace);
  writeLandmarks(unfinished / "truth_targets.mrk.json",
                 named(transformed(made.targets.moved, made.scan.scannerFromPreop), "scanner"),
                 Overwrite::Replace);
  writeJsonFile(unfinished / "truth.json", truth, Overwrite::Replace);
  CaseDescription description;
  description.folder = unfinished;
  description.name = nameOf(made.member);
  description.preop = "preop.vtp";
  description.scan = "scan.vtp";
  description.targets = "targets.mrk.json";
  description.truthTargets = "truth_targets.mrk.json";
  writeCaseDescription(description, Overwrite::Replace);
  std::filesystem::rename(unfinished, folder);
}

void writeCohortFile(const std::filesystem::path& folder, int targetLiver) {
  nlohmann::json cases = nlohmann::json::array();
  std::string target;
  for (const CohortMember& member : cohortMembers()) {
    cases.push_back({{"case", nameOf(member)}, {"group", groupOf(member.procedure)}});
    if (member.liver == targetLiver) target = nameOf(member);
  }
  writeJsonFile(folder / "cohort.json",
                {{"name", "Ten livers in three procedure groups"},
                 {"target", target},
                 {"cases", cases},
                 {"settings", {{"distance", {{"reachMm", 25.0}}}}}},
                Overwrite::Replace);
}

}  // namespace falciform::bench
