#include "Logic/Registration/Trials/TrialSummary.h"

#include <algorithm>
#include <map>

namespace falciform {

namespace {

constexpr double kAlikeMm = 1e-6;  // rounding of a pose that does not depend on where the scan lies

using Chosen = std::vector<const TrialRecord*>;

template <class Value>
SampleStatistics statisticsOf(const Chosen& records, const Value& value) {
  std::vector<double> values;
  values.reserve(records.size());
  for (const TrialRecord* record : records) values.push_back(value(*record));
  return sampleStatistics(std::move(values));
}

double rms(const TrialRecord& record) { return record.rmsMm; }
double targetError(const TrialRecord& record) { return record.targetErrorMm; }
double goldDistance(const TrialRecord& record) { return record.goldDistanceMm; }
double seconds(const TrialRecord& record) { return record.seconds; }

}  // namespace

TrialSummary summarise(const std::vector<TrialRecord>& records, const std::vector<int>& basins, int method,
                       const TrialSettings& settings) {
  TrialSummary summary;
  Chosen all, successes;
  std::map<int, Index> members;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const TrialRecord& record = records[i];
    if (record.method != method) continue;
    all.push_back(&record);
    if (record.success) successes.push_back(&record);
    if (record.goldDistanceMm < settings.goldWithinMm) ++summary.nearGold;
    if (record.warnings > 0) ++(record.success ? summary.successesFlagged : summary.failuresFlagged);
    summary.inLargestBasin = std::max(summary.inLargestBasin, ++members[basins[i]]);
  }
  summary.basins = static_cast<int>(members.size());
  summary.trials = static_cast<Index>(all.size());
  summary.successes = static_cast<Index>(successes.size());
  const auto rangeOf = [&](auto value) {
    const SampleStatistics up = statisticsOf(all, value),
                           down = statisticsOf(all, [&](const TrialRecord&r) { return -value(r); });
    return up.max + down.max;
  };
  summary.alike = all.size() > 1 && rangeOf(rms) < kAlikeMm && rangeOf(goldDistance) < kAlikeMm;
  summary.success = proportionInterval(summary.successes, summary.trials);
  summary.rmsMm = statisticsOf(all, rms);
  summary.rmsOfSuccessesMm = statisticsOf(successes, rms);
  summary.targetErrorMm = statisticsOf(all, targetError);
  summary.targetErrorOfSuccessesMm = statisticsOf(successes, targetError);
  summary.seconds = statisticsOf(all, seconds);
  summary.secondsOfSuccesses = statisticsOf(successes, seconds);
  summary.secondsPerIterationOfSuccesses = statisticsOf(
      successes, [](const TrialRecord& record) { return record.seconds / std::max(1, record.iterations); });
  summary.iterationsOfSuccesses = statisticsOf(
      successes, [](const TrialRecord& record) { return static_cast<double>(record.iterations); });
  return summary;
}

}  // namespace falciform
