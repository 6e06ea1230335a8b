#include "Modules/CommandLine/TrialTables.h"

#include <cmath>

#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/HtmlText.h"

namespace falciform::commandline {

namespace {

std::string percent(double share, int decimals = 1) { return fixed(100 * share, decimals) + " %"; }

/// "132 (52.8 %)"
std::string countOf(Index part, Index whole) {
  if (whole == 0) return "-";
  return std::to_string(part) + " (" + percent(static_cast<double>(part) / static_cast<double>(whole)) + ")";
}

/// "3.0 ± 2.9"; a spread below the last place is told as the thesis does: "3.4 ± 5e-4".
std::string meanAndSpread(const SampleStatistics& s, int decimals = 2) {
  if (s.count == 0) return "-";
  if (s.count == 1) return fixed(s.mean, decimals);
  if (s.sd >= std::pow(10.0, -decimals) || s.sd == 0)
    return fixed(s.mean, decimals) + " ± " + fixed(s.sd, decimals);
  const int power = static_cast<int>(std::floor(std::log10(s.sd)));
  return fixed(s.mean, decimals) + " ± " + fixed(s.sd / std::pow(10.0, power), 0) + "e" +
         std::to_string(power);
}

/// A row a method: its name and what `cells` makes of its summary.
template <class Cells>
std::string methodTable(const TrialOutcome& outcome, std::vector<std::string> head, const Cells& cells) {
  head.insert(head.begin(), "Registration method");
  HtmlTable table(std::move(head), 1);
  for (std::size_t i = 0; i < outcome.methods.size(); ++i) {
    std::vector<std::string> row = cells(outcome.summaries[i]);
    row.insert(row.begin(), outcome.methods[i].name);
    table.row(std::move(row));
  }
  return table.html();
}

}  // namespace

std::string successTable(const TrialOutcome& outcome) {
  if (outcome.targets == 0)
    return methodTable(
        outcome, {"Success (No.)", "Residual (mm)", "Residual, successes (mm)"},
        [](const TrialSummary& s) -> std::vector<std::string> {
          return {countOf(s.successes, s.trials), meanAndSpread(s.rmsMm), meanAndSpread(s.rmsOfSuccessesMm)};
        });
  return methodTable(
      outcome,
      {"Success (No.)", "Residual (mm)", "TRE (mm)", "Residual, successes (mm)", "TRE, successes (mm)"},
      [](const TrialSummary& s) -> std::vector<std::string> {
        return {countOf(s.successes, s.trials), meanAndSpread(s.rmsMm), meanAndSpread(s.targetErrorMm),
                meanAndSpread(s.rmsOfSuccessesMm), meanAndSpread(s.targetErrorOfSuccessesMm)};
      });
}

std::string proofTable(const TrialOutcome& outcome) {
  return methodTable(
      outcome, {"95 % interval of success", "Proves at least", "Failures flagged", "Successes flagged"},
      [](const TrialSummary& s) -> std::vector<std::string> {
        return {percent(s.success.low, 2) + " to " + percent(s.success.high, 2),
                percent(s.success.atLeast, 2), countOf(s.failuresFlagged, s.trials - s.successes),
                countOf(s.successesFlagged, s.successes)};
      });
}

std::string alikeNote(const TrialOutcome& outcome) {
  std::string names;
  for (std::size_t i = 0; i < outcome.methods.size(); ++i)
    if (outcome.summaries[i].alike) names += (names.empty() ? "" : ", ") + outcome.methods[i].name;
  if (names.empty()) return "";
  return names +
         ": the result is the same to 1e-6 mm wherever the scan lies, so these trials are one experiment, "
         "and "
         "their interval tells nothing of another scan; --keep-share or --noise makes trials that differ.";
}

std::string poseTable(const TrialOutcome& outcome) {
  return methodTable(
      outcome,
      {"Poses", "In the commonest",
       "Within " + fixed(outcome.settings.goldWithinMm, 1) + " mm of the gold standard"},
      [](const TrialSummary& s) -> std::vector<std::string> {
        return {std::to_string(s.basins), countOf(s.inLargestBasin, s.trials), countOf(s.nearGold, s.trials)};
      });
}

std::string spreadTable(const TrialOutcome& outcome) {
  const auto quantiles = [](const SampleStatistics& s) -> std::vector<std::string> {
    return {fixed(s.median, 2), fixed(s.p95, 2), fixed(s.p99, 2), fixed(s.max, 2)};
  };
  const auto table = [&](const std::string& what, const auto& choose) {
    return methodTable(outcome, {what + ": median", "P95", "P99", "Largest"},
                       [&](const TrialSummary& s) { return quantiles(choose(s)); });
  };
  return (outcome.targets > 0 ? table("TRE (mm)", [](const TrialSummary& s) { return s.targetErrorMm; })
                              : "") +
         table("Residual (mm)", [](const TrialSummary& s) { return s.rmsMm; });
}

std::string timeTable(const TrialOutcome& outcome) {
  return methodTable(
      outcome,
      {"Successes: s / s an iteration", "Iterations", "All: median (s)", "P95 (s)", "P99 (s)", "Largest (s)"},
      [](const TrialSummary& s) -> std::vector<std::string> {
        return {fixed(s.secondsOfSuccesses.mean, 3) + " / " + fixed(s.secondsPerIterationOfSuccesses.mean, 5),
                meanAndSpread(s.iterationsOfSuccesses, 1),
                fixed(s.seconds.median, 3),
                fixed(s.seconds.p95, 3),
                fixed(s.seconds.p99, 3),
                fixed(s.seconds.max, 3)};
      });
}

std::string methodSettingsTable(const TrialOutcome& outcome) {
  std::vector<nlohmann::json> used;
  std::vector<std::string> head{"Setting", "Unit"};
  for (const TrialMethod& method : outcome.methods) {
    used.push_back(settingsToJson(method.settings));
    head.push_back(method.name);
  }
  HtmlTable table(head);
  RegistrationSettings any;
  describe(any, [&](const FieldInfo& info, auto&) {
    std::vector<std::string> row{std::string(info.label), std::string(info.unit)};
    for (const nlohmann::json& settings : used) {
      const nlohmann::json& value = settings[std::string(info.key)];
      row.push_back(value.is_string()                   ? value.get<std::string>()
                    : value.is_array() && value.empty() ? "all"
                    : value.is_number_float()           ? numberText(value.get<double>())
                                                        : value.dump());
    }
    table.row(row);
  });
  return table.html();
}

}  // namespace falciform::commandline
