#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/IO/CaseFolder.h"

namespace falciform::commandline {

/// One patient of a cohort.
struct CohortMember {
  std::string name, group;      ///< an empty group: a procedure of its own
  CaseDescription description;  ///< read from the case's folder, or made of the files named
  std::filesystem::path truth;  ///< truth_surface.vtp in the case's folder; empty: there is none
};

/// What COHORT.json says (Docs/UserGuide/Cohort.md).
struct CohortFile {
  std::string name;
  std::vector<CohortMember> members;
  std::size_t target = 0;  ///< of the members: on whose liver all are compared
  /// Of every case's import, patches, registration and distance, before what its own case.json says.
  nlohmann::json caseSettings = nlohmann::json::object();
  nlohmann::json normalisation = nlohmann::json::object();
};

/// Throws InputError, in one line with file and key, for anything wrong: unknown keys, a case named twice,
/// fewer than three cases, a target that is no case.
[[nodiscard]] CohortFile readCohortFile(const std::filesystem::path& file);

/// Groups in the order of their names, and each member's place among them; -1: none.
struct CohortGroups {
  std::vector<std::string> names;
  std::vector<int> of;
};
[[nodiscard]] CohortGroups groupsOf(const CohortFile& cohort);

}  // namespace falciform::commandline
