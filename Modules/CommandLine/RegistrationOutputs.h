#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Core/Results.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/StartPose.h"

namespace falciform::commandline {

// What `register` and `run` share.

inline constexpr char kScanFromPreopInWords[] = "maps pre-op LPS mm to scan mm";

/// --init and the landmark lists.
void declareStart(Syntax& syntax, const std::string& group);
/// --preset.
void declarePreset(Syntax& syntax, const std::string& group);

/// The start that the arguments ask for; see resolveStart. Warns of landmarks that are given and not used.
[[nodiscard]] StartPose startOf(const ParsedArguments& arguments, RegistrationSettings& settings,
                                const Landmarks& preopLandmarks, const Landmarks& scanLandmarks,
                                CommandRun& run);

/// scan_from_preop.tfm, .txt, .json and preop_on_scan.vtp.
[[nodiscard]] std::vector<std::string> registrationFiles();
/// Writes them into `folder`, where they were announced.
void writeRegistration(const Surface& preop, const Surface& scan, const RegistrationResult& result,
                       const std::filesystem::path& folder, CommandRun& run);
/// scan_from_preop.tfm, .txt and .json.
[[nodiscard]] std::vector<std::string> poseFiles();
void writePose(const Isometry3d& scanFromPreop, const std::filesystem::path& folder, CommandRun& run);
void describeFrames(CommandRun& run);
/// The figures on stdout.
void tellRegistration(const RegistrationResult& result, const StartPose& start, CommandRun& run);

}  // namespace falciform::commandline
