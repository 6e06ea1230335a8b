#include "Logic/Registration/Trials/GoldStandard.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"

namespace falciform {

namespace {

/// Three or more points that span a plane: fewer leave a turn about their line open.
bool fixAPose(const Points& points) {
  if (points.rows() < 3) return false;
  const Points centred = points.rowwise() - points.colwise().mean();
  const auto spread = Eigen::JacobiSVD<Eigen::MatrixXd>(centred).singularValues();
  return spread[1] > 1e-3 * spread[0];
}

double rmsAt(const PreparedPreop& preop, const Points& onPreop) {
  std::vector<double> squares(static_cast<std::size_t>(onPreop.rows()));
  forEachChunk(squares.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      squares[i] =
          preop.target().closest(onPreop.row(static_cast<Index>(i)).transpose(), 0, 1).squaredDistance;
  });
  double sum = 0;
  for (const double square : squares) sum += square;
  return std::sqrt(sum / static_cast<double>(squares.size()));
}

/// "falciform and inferior ridge"
std::string sharedPatches(const Surface& preop, const Surface& scan) {
  const std::vector<int> onScan = patchLabels(scan);
  std::string names;
  for (const int label : patchLabels(preop))
    if (std::binary_search(onScan.begin(), onScan.end(), label))
      names += (names.empty() ? "" : " and ") + patchName(preop, label);
  return names;
}

}  // namespace

GoldStandard goldStandard(const PreparedPreop& preop, const Surface& scan, const TrialTargets& targets,
                          const std::optional<Isometry3d>& given, const Progress& progress) {
  checkSurface(scan, "scan");
  GoldStandard gold;
  if (given) {
    gold.scanFromPreop = *given;
    gold.source = "the transform that was given";
  } else if (fixAPose(targets.preop) && fixAPose(targets.scan)) {
    gold.scanFromPreop = fitRigid(targets.preop, targets.scan);
    gold.source =
        "the best rigid fit of " + std::to_string(targets.preop.rows()) + " targets to their true places";
  } else {
    const std::string patches = sharedPatches(preop.surface(), scan);
    if (patches.empty())
      throw InputError(
          "there is no gold standard: no transform, no three targets with truth and no patch that both "
          "surfaces have; give one of them");
    gold.scanFromPreop =
        registerSurfaces(preop, scan, registrationPreset("default"), Isometry3d::Identity(), progress)
            .scanFromPreop;
    gold.source = "the default registration from the patches " + patches;
  }
  gold.rmsMm = rmsAt(preop, transformed(scan.points, gold.scanFromPreop.inverse()));
  if (targets.preop.rows() > 0)
    gold.targetErrorMm = targetErrors(targets.preop, targets.scan, gold.scanFromPreop).mean();
  return gold;
}

}  // namespace falciform
