#pragma once
#include <utility>
#include <vector>

#include "Logic/Atlas/DeformedSurface.h"
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Atlas/ScanChoice.h"
#include "Logic/Geometry/KdTree.h"

namespace falciform {

/// A model update at work: one scan, iteration by iteration. Inside Logic/Atlas only.
class ModelFit {
 public:
  ModelFit(const UpdateModel& model, const Surface& scan, const Isometry3d& scanFromPreopStart,
           const UpdateSettings& settings, std::uint64_t seed);

  UpdateResult run(const Progress& progress, const UpdateObserver& observer);

 private:
  struct Correspondence {
    SurfaceMeeting at;
    double residual = 0;  ///< along at.normal, mm
  };

  void look(double reachMm);
  void correspond(std::size_t count);
  double step(std::size_t count);
  void addPatches(std::size_t count, const Vector3d& centre, double weight);
  void meetingRow(std::size_t j, const SurfaceMeeting& meeting, const Vector3d& along, const Vector3d& centre,
                  double weight, double* row) const;
  [[nodiscard]] Vector3d posed(std::size_t j) const;
  void learnSamples();
  void addRows(Eigen::MatrixXd& rows);
  void placeRow(int place, const Vector3d& along, double* row) const;
  double solve(const Vector3d& centre);
  void learn(const Eigen::MatrixXd& covariance, const VectorXd& whitened);
  [[nodiscard]] VectorXd perLoad() const;
  void finish(UpdateResult& result) const;

  const UpdateModel& model_;
  const UpdateSettings& settings_;
  Isometry3d pose_;  ///< pre-op from scan
  ScanChoice scan_;  ///< in random order
  VectorXd coefficients_;
  VectorXd seen_;            ///< 1 or the share, for each load
  VectorXd strength_;        ///< of each centre's loads beside the others, as learnt
  double sinceTreesMm_ = 0;  ///< how far the surface has moved since its trees were made
  double bendMm_ = 10, noiseMm_ = 2, rmsMm_ = 0, known_ = 0;
  double samples_ = 0;  ///< independent measurements that the scan is worth
  double relax_ = 1;    ///< share of each step that is taken
  DeformedSurface surface_;
  std::vector<Correspondence> found_;
  std::vector<double> weights_;
  Eigen::MatrixXd normal_;  ///< J' W J
  VectorXd right_;
  Eigen::MatrixXd covariance_;
  Vector3d turnCentre_ = Vector3d::Zero();
};

}  // namespace falciform
