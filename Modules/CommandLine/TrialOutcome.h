#pragma once
#include <string>
#include <vector>

#include "Logic/Registration/Trials/TrialSummary.h"

namespace falciform::commandline {

/// All that a set of trials has to tell.
struct TrialOutcome {
  std::vector<TrialMethod> methods;
  std::string scaleName;  ///< "small", "large" or the name of a settings file
  TrialScale scale;
  TrialSettings settings;
  GoldStandard gold;
  Index targets = 0, preopPoints = 0, scanPoints = 0;
  double optimalRigidMm = 0;  ///< mean target error of the rigid motion fitted to the targets; NaN below 3
  double preparationSeconds = 0;  ///< of the pre-op side, once for all registrations
  int threads = 1;
  std::vector<TrialRecord> records;     ///< by method, then trial
  std::vector<int> basins;              ///< one a record, from 1
  std::vector<TrialSummary> summaries;  ///< one a method
};

}  // namespace falciform::commandline
