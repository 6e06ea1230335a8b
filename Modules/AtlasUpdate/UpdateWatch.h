#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <string>

#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Core/Case.h"
#include "Widgets/Jobs/LiveRecords.h"

namespace falciform {

/// Where the liver and what is in it are at one iteration, pre-op frame, mm: as an UpdateMaps has them.
struct UpdateShape {
  Points liver;
  std::map<std::string, Points> structures;
};

/// One iteration of a running update, as the panel shows it.
struct UpdateRecord {
  int iteration = 0;
  double rmsMm = 0, bendMm = 0;
  double expectedMm = 0;  ///< mean over a sample of the surface; NaN where it was not reckoned
  std::shared_ptr<const UpdateShape> shape;
};

/// Lets a window look on while an update runs, and end it early. The job holds observer(); the window the
/// rest.
class UpdateWatch {
 public:
  /// Of the case as it is now, which must be registered.
  UpdateWatch(const Case& document, std::shared_ptr<const UpdateModel> model);

  /// Notes each iteration, on the job's thread; outlives the watch.
  [[nodiscard]] UpdateObserver observer() const;
  /// The job ends after the iteration that it is at, with what there is.
  void stop() { shared_->stop = true; }
  [[nodiscard]] bool stopping() const { return shared_->stop; }
  [[nodiscard]] std::vector<UpdateRecord> records() const { return shared_->records.records(); }
  [[nodiscard]] std::size_t size() const { return shared_->records.size(); }

 private:
  struct Shared {
    std::shared_ptr<const UpdateModel> model;
    Isometry3d preopFromScan;
    Points before;                            ///< of the liver, then of each structure
    std::map<std::string, Index> structures;  ///< number of points
    Points sample;                            ///< where the expected error is reckoned
    std::atomic<bool> stop{false};
    LiveRecords<UpdateRecord> records;
  };
  std::shared_ptr<Shared> shared_;
};

}  // namespace falciform
