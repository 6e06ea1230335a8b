#pragma once
#include <array>
#include <optional>

#include "Logic/Deformation/Cohort/CarriedCase.h"
#include "Logic/Deformation/Cohort/CohortAnalysis.h"
#include "Modules/CommandLine/CaseRun.h"
#include "Modules/CommandLine/CohortFile.h"
#include "Modules/CommandLine/CohortInput.h"

namespace falciform::commandline {

/// What is compared between cases.
enum class CohortMetric { SignedDistance, CurvatureDifference, TrueDisplacement };
struct CohortMetricInfo {
  CohortMetric metric;
  const char *array, *folder, *title, *unit;
};
inline constexpr std::array<CohortMetricInfo, 3> kCohortMetrics{
    {{CohortMetric::SignedDistance, kSignedDistance, "signed_distance", "Signed distance", "mm"},
     {CohortMetric::CurvatureDifference, kCurvatureDifference, "curvature_difference",
      "Mean-curvature difference", "1/mm"},
     {CohortMetric::TrueDisplacement, "true_normal_displacement_mm", "true_displacement",
      "True normal displacement", "mm"}}};

/// One patient measured, and its maps on the target liver.
struct MeasuredCase {
  std::string name, group;
  CaseOutcome outcome;                 ///< registration by patches, maps on the own surface
  std::shared_ptr<const Surface> own;  ///< pre-op, LPS, with an array for each metric
  CarriedCase carried;                 ///< columns as kCohortMetrics
  std::optional<double> poseErrorMm;   ///< rms over the liver, of the pose to the best rigid one
};

/// The correlations of one metric and what they say of the groups.
struct MetricResult {
  CohortMetricInfo info;
  CohortInput input;
  CohortAnalysis analysis;
};

struct CohortOutcome {
  std::vector<MeasuredCase> cases;
  std::size_t target = 0;
  std::vector<Index> overlap;         ///< vertices of the target that every case covers in every metric
  std::vector<MetricResult> metrics;  ///< the true one where every case has its truth
};

/// The chain of thesis ch. IV: each case registered by patches, its maps on its own surface, these carried to
/// the target liver, correlated where all cover it, and the groups compared. Warnings name their case.
[[nodiscard]] CohortOutcome runCohort(const CohortFile& cohort, const PermutationSettings& settings,
                                      CommandRun& run, const Progress& progress);

}  // namespace falciform::commandline
