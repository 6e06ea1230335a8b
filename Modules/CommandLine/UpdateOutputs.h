#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Core/Results.h"
#include "Modules/CommandLine/LiverInput.h"
#include "Modules/CommandLine/TargetError.h"
#include "Modules/CommandLine/UpdateInput.h"
#include "Modules/CommandLine/UpdateTargets.h"

namespace falciform::commandline {

/// All that an update's outputs are made of, whatever method it was.
struct UpdatedLiver {
  const LiverInput& liver;
  const UpdateInput& input;
  const RegistrationResult& rigid;  ///< what the update began from
  const UpdateResult& update;       ///< of liver.mesh
  const UpdateModel* model;         ///< of a method that expects an error, else nullptr
  falciform::Surface moved;  ///< the pre-op surface where it is now, with kDisplacement and, where there is a
                             ///< model, kExpectedError
  std::optional<TargetError> targetError;  ///< where the truth is known
  std::vector<TargetRow> targets;          ///< targetRows of all the rest
};

inline constexpr char kTargetTable[] = "targets_updated.csv";

/// Moves the surface and works out its expected error.
[[nodiscard]] UpdatedLiver updatedLiver(const LiverInput& liver, const UpdateInput& input,
                                        const RegistrationResult& rigid, const UpdateResult& update,
                                        const UpdateModel* model);

/// Says which files may come, before any computation.
void announceUpdate(const ParsedArguments& arguments, CommandRun& run);
void announceUpdate(const std::filesystem::path& folder, bool targets, CommandRun& run);
/// The same for what is known once the input is read.
void announceStructures(const UpdateInput& input, const std::filesystem::path& folder, CommandRun& run);

/// Writes them: updated.vtp, structures, targets, pose; --picture.
void writeUpdate(const UpdatedLiver& updated, const ParsedArguments& arguments, CommandRun& run);
/// The same without a picture.
void writeUpdate(const UpdatedLiver& updated, const std::filesystem::path& folder, CommandRun& run);

/// All figures of an update, target error where there is truth among them.
[[nodiscard]] nlohmann::json updateFigures(const UpdatedLiver& updated);
/// What is to be said in plain words: an update that expects to be worse than what it began
/// from.
[[nodiscard]] std::vector<std::string> updateWarnings(const UpdatedLiver& updated);
/// The figures that matter, on stdout.
void sayUpdate(const UpdatedLiver& updated, CommandRun& run);
/// All three, the figures into the sidecar.
void tellUpdate(const UpdatedLiver& updated, CommandRun& run);

}  // namespace falciform::commandline
