#include "Modules/CommandLine/CohortChain.h"

#include <cmath>

#include "Logic/Deformation/Cohort/MapCorrelation.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/PointRegistration.h"

namespace falciform::commandline {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Every case's settings with nothing typed: what the cohort's file says, then what the case's own does.
CaseSettings settingsOf(const CohortFile& cohort, CohortMember& member) {
  nlohmann::json both = cohort.caseSettings;
  both.merge_patch(member.description.settings);
  member.description.settings = std::move(both);
  Syntax syntax("cohort", "", "");
  declareCaseSettings(syntax);
  CaseSettings settings = caseSettings(member.description, ParsedArguments(syntax, {}));
  settings.withUpdate = false;
  return settings;
}

/// Where the pre-op vertices truly are, in the frame of the scan.
std::optional<Points> readTruth(const CohortMember& member, const Surface& preop, CommandRun& run) {
  if (member.truth.empty()) return {};
  Points moved = run.surface(member.truth).points;
  if (moved.rows() != preop.size())
    throw InputError("truth_surface.vtp of '" + member.name + "' has " + std::to_string(moved.rows()) +
                     " points where the pre-op surface has " + std::to_string(preop.size()) +
                     "; it must be the same vertices");
  return moved;
}

MeasuredCase measure(const CohortFile& cohort, CohortMember member, CommandRun& run,
                     const Progress& progress) {
  MeasuredCase measured;
  measured.name = member.name;
  measured.group = member.group;
  CaseSettings settings = settingsOf(cohort, member);
  CommandRun own;  // for its warnings, which do not name the case
  own.progress = progress;
  try {
    measured.outcome = runCase(member.description, settings, own, progress);
  } catch (const InputError& error) {
    throw InputError("case '" + member.name + "': " + error.what());
  }
  const CaseOutcome& outcome = measured.outcome;
  auto surface = std::make_shared<Surface>(*outcome.preop);
  surface->arrays.clear();
  for (const char* array : {kSignedDistance, kCurvatureDifference}) {
    const auto found = outcome.distance->preop.arrays.find(array);
    surface->arrays[array] = found != outcome.distance->preop.arrays.end()
                                 ? found->second
                                 : VectorXd::Constant(surface->size(), kNone);
  }
  if (const std::optional<Points> truth = readTruth(member, *surface, own)) {
    surface->arrays[kCohortMetrics[2].array] = normalDisplacement(*surface, *truth);
    const Isometry3d best = fitRigid(surface->points, *truth, vertexAreas(*surface));
    const Points apart = transformed(surface->points, best) -
                         transformed(surface->points, outcome.registration->scanFromPreop);
    measured.poseErrorMm = std::sqrt(apart.rowwise().squaredNorm().mean());
  }
  measured.own = std::move(surface);
  for (const std::string& warning : own.provenance.warnings) run.warn(member.name + ": " + warning);
  for (const auto& input : own.provenance.inputSha256)
    run.provenance.inputSha256.emplace_back(member.name + "/" + input.first, input.second);
  return measured;
}

/// Columns as kCohortMetrics; NaN where there is no such array.
Eigen::MatrixXd valuesOf(const Surface& surface) {
  Eigen::MatrixXd values = Eigen::MatrixXd::Constant(surface.size(), kCohortMetrics.size(), kNone);
  for (std::size_t k = 0; k < kCohortMetrics.size(); ++k)
    if (const auto found = surface.arrays.find(kCohortMetrics[k].array); found != surface.arrays.end())
      values.col(static_cast<Index>(k)) = found->second;
  return values;
}

/// Names the case that makes the overlap small, where one alone does.
void warnOfSmallOverlap(const Eigen::MatrixXd& maps, Index overlap, const std::vector<std::string>& names,
                        CommandRun& run) {
  const Index columns = maps.cols() / static_cast<Index>(names.size());
  Index most = 0;
  std::size_t which = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Eigen::MatrixXd others = maps;
    others.middleCols(columns * static_cast<Index>(i), columns).setZero();
    const auto without = static_cast<Index>(commonCoverage(others).size());
    if (without > most) most = without, which = i;
  }
  if (most > 2 * overlap)
    run.warn("all cases cover " + std::to_string(overlap) + " vertices of the target liver; without '" +
             names[which] + "' it would be " + std::to_string(most));
}

}  // namespace

CohortOutcome runCohort(const CohortFile& cohort, const PermutationSettings& settings, CommandRun& run,
                        const Progress& progress) {
  const auto normalisation = settingsFromJson(cohort.normalisation, NormalisationSettings{});
  run.settings["normalisation"] = settingsToJson(normalisation);
  run.settings["cases"] = cohort.caseSettings;
  CohortOutcome outcome;
  outcome.target = cohort.target;
  const auto n = static_cast<double>(cohort.members.size());
  std::vector<std::string> names;
  for (const CohortMember& member : cohort.members) {
    const auto done = static_cast<double>(outcome.cases.size());
    const Progress part = progress.part(0.4 * done / n, 0.4 * (done + 1) / n);
    part.report(0, member.name + ": registering");
    outcome.cases.push_back(measure(cohort, member, run, part));
    names.push_back(member.name);
  }
  const Surface& target = *outcome.cases[outcome.target].own;
  bool truth = true;
  Index done = 0;
  for (MeasuredCase& measured : outcome.cases) {
    const double from = 0.4 + 0.55 * static_cast<double>(done++) / n;
    const Progress part = progress.part(from, from + 0.55 / n);
    part.report(0, measured.name + ": onto the target liver");
    const Eigen::MatrixXd values = valuesOf(*measured.own);
    if (measured.own.get() == &target)
      measured.carried.values = values;
    else
      measured.carried = carryCase(target, *measured.own, values, normalisation, part);
    truth = truth && measured.poseErrorMm.has_value();
  }
  std::size_t metrics = truth ? 3 : 2;
  Eigen::MatrixXd all(target.size(), static_cast<Index>(2 * outcome.cases.size()));
  for (std::size_t i = 0; i < outcome.cases.size(); ++i)
    all.middleCols(static_cast<Index>(2 * i), 2) = outcome.cases[i].carried.values.leftCols(2);
  outcome.overlap = commonCoverage(all);
  warnOfSmallOverlap(all, static_cast<Index>(outcome.overlap.size()), names, run);
  const CohortGroups groups = groupsOf(cohort);
  for (std::size_t k = 0; k < metrics; ++k) {
    MetricResult result{.info = kCohortMetrics[k], .input = {}, .analysis = {}};
    Eigen::MatrixXd maps(target.size(), static_cast<Index>(outcome.cases.size()));
    for (std::size_t i = 0; i < outcome.cases.size(); ++i)
      maps.col(static_cast<Index>(i)) = outcome.cases[i].carried.values.col(static_cast<Index>(k));
    result.input.name = cohort.name;
    result.input.vertices = target.size();
    result.input.overlap = static_cast<Index>(outcome.overlap.size());
    result.input.cohort = {.cases = names,
                           .correlation = mapCorrelation(maps, outcome.overlap, names),
                           .groups = groups.names,
                           .groupOf = groups.of};
    result.analysis = analyseCohort(
        result.input.cohort, settings,
        progress.part(0.95 + 0.016 * static_cast<double>(k), 0.966 + 0.016 * static_cast<double>(k)));
    for (const std::string& warning : result.analysis.warnings) run.warn(warning);
    outcome.metrics.push_back(std::move(result));
  }
  return outcome;
}

}  // namespace falciform::commandline
