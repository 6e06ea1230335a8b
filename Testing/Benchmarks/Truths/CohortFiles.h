#pragma once
#include <filesystem>

#include "Testing/Benchmarks/Truths/CohortBody.h"
#include "Testing/Benchmarks/Truths/TruthFiles.h"

namespace falciform::bench {

/// A case of the cohort, solved and scanned. `moved`: in the pre-operative frame.
struct CohortCaseMade {
  CohortMember member;
  CohortPlan plan;
  Surface preop, moved;
  TruthScan scan;
  TruthTargets targets;
  double heldShare = 0, loadShare = 0, minDetJ = 0;
  Index meshNodes = 0;
};

/// "ircad5".
[[nodiscard]] std::string nameOf(const CohortMember& member);

/// A case folder that `falciform run` takes (case.json, preop.vtp, scan.vtp, targets and where they truly
/// are), with truth_surface.vtp and truth.json. Whoever watches sees a whole folder or none.
void writeCohortCase(const std::filesystem::path& folder, const CohortCaseMade& made);

/// cohort.json, which `falciform cohort` takes: all members with their groups, the target liver.
void writeCohortFile(const std::filesystem::path& folder, int targetLiver);

}  // namespace falciform::bench
