#pragma once
#include <vector>

#include "Logic/Registration/Trials/Proportion.h"
#include "Logic/Registration/Trials/SampleStatistics.h"
#include "Logic/Registration/Trials/Trials.h"

namespace falciform {

/// One method over all its trials: a row of the thesis's Tables III.1, III.2, III.5, III.6 and III.7, and
/// more.
struct TrialSummary {
  Index trials = 0, successes = 0;
  ProportionInterval success;  ///< 95 %
  SampleStatistics rmsMm, rmsOfSuccessesMm;
  SampleStatistics targetErrorMm, targetErrorOfSuccessesMm;  ///< of no values without targets
  SampleStatistics seconds, secondsOfSuccesses;
  SampleStatistics secondsPerIterationOfSuccesses;
  SampleStatistics iterationsOfSuccesses;
  Index nearGold = 0;  ///< within TrialSettings::goldWithinMm of the gold standard
  Index failuresFlagged = 0, successesFlagged = 0;  ///< with a warning: caught, and cried wolf
  int basins = 0;                                   ///< different poses that the trials ended in
  Index inLargestBasin = 0;
  bool alike =
      false;  ///< all results are one to 1e-6 mm wherever the scan lay: the trials are one experiment
};

/// Of the records of method `method`; `basins` belong to `records` row by row.
[[nodiscard]] TrialSummary summarise(const std::vector<TrialRecord>& records, const std::vector<int>& basins,
                                     int method, const TrialSettings& settings);

}  // namespace falciform
