#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform::commandline {

struct UpdatedLiver;

/// A place inside the liver: where it was, and where registration and update say it is now.
struct TargetRow {
  std::string name;
  bool structure = false;                       ///< the middle of a structure's points, not a target
  Vector3d preop, rigid, now;                   ///< pre-op mm; by the registration, by the update: scan mm
  std::optional<double> expectedMm;             ///< error of `now`, where the method expects one
  std::optional<double> errorMm, rigidErrorMm;  ///< where the truth is known
};

/// The targets in their order, then the structures.
[[nodiscard]] std::vector<TargetRow> targetRows(const UpdatedLiver& updated);

/// One line a row, C locale; what is not known is left empty.
[[nodiscard]] std::string targetsCsv(const std::vector<TargetRow>& rows);
[[nodiscard]] nlohmann::json toJson(const std::vector<TargetRow>& rows);

}  // namespace falciform::commandline
