#pragma once
#include <filesystem>

#include "Testing/Benchmarks/Truths/TruthBody.h"
#include "Testing/Benchmarks/Truths/TruthScan.h"

namespace falciform::bench {

/// Where targets inside the liver were and are, K x 3, mm.
struct TruthTargets {
  Points preop, moved;  ///< both in the pre-operative frame
};

/// `count` places drawn evenly over the mesh's volume.
[[nodiscard]] TruthTargets drawTargets(const TetrahedralMesh& mesh, const Points& displacements, int count,
                                       std::uint64_t seed);

/// Mean distance that the best rigid motion leaves, mm.
[[nodiscard]] double optimalRigidMm(const TruthTargets& targets);

/// What truth.json says of every made case: frames, pose, coverage, noise, targets, patches.
[[nodiscard]] nlohmann::json truthOf(const ScannerPlan& plan, const Surface& preop, const TruthScan& scan,
                                     const TruthTargets& targets);

/// Writes preop.vtp, scan.vtp and truth_surface.vtp (the pre-op vertices where they truly are, in the
/// scanner's frame). `moved`: in the pre-operative frame.
void writeTruthSurfaces(const std::filesystem::path& folder, const Surface& preop, const Surface& moved,
                        const TruthScan& scan);

/// The case's four files, in the layout that readUpdateCase reads: preop.vtp, scan.vtp, truth_surface.vtp
/// and truth.json, whose `drawn` tells everything about how it was made. `moved`: in the pre-operative frame.
void writeTruth(const std::filesystem::path& folder, int liver, double edgeMm, const TruthPlan& plan,
                const Surface& preop, const Surface& moved, const TruthScan& scan,
                const TruthTargets& targets, const TruthBody& body, const TruthState& state);

}  // namespace falciform::bench
