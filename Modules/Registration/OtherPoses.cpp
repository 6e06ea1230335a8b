// The panel's poses beside the stored one: by hand, in replay, of other basins.
#include <algorithm>

#include <QGroupBox>
#include <QLabel>
#include <QPushButton>

#include "Logic/Geometry/RigidSteps.h"
#include "Modules/Registration/BasinTable.h"
#include "Modules/Registration/ConvergenceReplay.h"
#include "Modules/Registration/RegistrationPanel.h"

namespace falciform {

Isometry3d RegistrationPanel::startPreopFromScan() const {
  if (hand_) return *hand_;
  if (logic_.startFromLandmarks)
    if (const auto fit = logic_.landmarkFit()) return fit->targetFromSource.inverse();
  return Isometry3d::Identity();
}

void RegistrationPanel::moveByHand(bool on) {
  if (!on) {
    preview_.endIf(PosePreview::Reason::Hand);
    // What was placed is seen where a start is seen.
    bench().view.edit([](ViewOptions& options) { options.afterRegistration = false; });
    return refresh();
  }
  // The hand takes the scan from where it is seen.
  const ViewOptions& options = bench().view.options();
  const auto& result = document().registration();
  if (options.livePreopFromScan)
    setHandPose(Isometry3d(*options.livePreopFromScan));
  else if (result && options.afterRegistration)
    setHandPose(result->scanFromPreop.inverse());
  else
    setHandPose(startPreopFromScan());
}

void RegistrationPanel::setHandPose(const Isometry3d& preopFromScan) {
  hand_ = preopFromScan;
  handScan_ = document().scan();
  convergence_->stop();
  preview_.show(PosePreview::Reason::Hand, preopFromScan, tr("Moved by hand, not registered"));
  refresh();
}

void RegistrationPanel::showReplay(int iteration) {
  const auto& result = document().registration();
  if (!result || iteration > static_cast<int>(result->history.size())) return;
  const Isometry3d pose = iteration == 0
                              ? Isometry3d(runStart_.inverse())
                              : result->history[static_cast<std::size_t>(iteration) - 1].preopFromScan;
  const bool begins = preview_.reason() != PosePreview::Reason::Replay;
  preview_.show(PosePreview::Reason::Replay, pose,
                iteration == 0 ? tr("Replay: the start")
                               : tr("Replay: iteration %1 of %2").arg(iteration).arg(result->history.size()));
  if (begins) refresh();
}

std::size_t RegistrationPanel::bestBasin() const {
  const auto& basins = found_->basins;
  const auto best = std::min_element(basins.begin(), basins.end(),
                                     [](const auto& a, const auto& b) { return a.score < b.score; });
  return static_cast<std::size_t>(best - basins.begin());
}

void RegistrationPanel::showBasin(int row) {
  if (row < 0 || !found_) return preview_.endIf(PosePreview::Reason::Basin);
  convergence_->stop();
  preview_.show(PosePreview::Reason::Basin,
                found_->basins[static_cast<std::size_t>(row)].scanFromPreop.inverse(),
                tr("Pose %1 of %2, to look at").arg(row + 1).arg(found_->basins.size()));
  refresh();
}

void RegistrationPanel::useBasin(std::size_t row) {
  if (row != bestBasin() || row != 0) return evaluate(withBasin(*found_, row));
  // The very result that was found: it knows its history and what target error to expect.
  choosing_ = true;
  document().setRegistration(found_);
  choosing_ = false;
}

void RegistrationPanel::refreshBasins() {
  const auto& result = document().registration();
  const bool several = found_ && result && found_->basins.size() > 1 && !document().registrationStale();
  basinGroup_->setVisible(several);
  if (!several) {
    preview_.endIf(PosePreview::Reason::Basin);
    basins_->show(nullptr, nullptr, 0, 0);
    return;
  }
  // A row that is being looked at stays selected through changes that leave the poses as they are.
  const int chosen = preview_.reason() == PosePreview::Reason::Basin ? basins_->chosen() : -1;
  std::size_t used = 0;
  for (std::size_t i = 0; i < found_->basins.size(); ++i)
    if (found_->basins[i].scanFromPreop.isApprox(result->scanFromPreop, 1e-12)) used = i;
  basins_->show(found_.get(), document().scan().get(), bestBasin(), used);
  if (chosen >= 0) basins_->choose(chosen);
  const bool busy = bench().runner.busy();
  const bool other = chosen >= 0 && static_cast<std::size_t>(chosen) != used;
  basinWords_->setText(chosen < 0 ? tr("Select a pose to see the scan there. The bold one is the result.")
                       : other    ? tr("Not the result: only shown.")
                                  : tr("This pose is the result."));
  useBasin_->setVisible(other);
  useBasin_->setEnabled(!busy);
  backToBest_->setVisible(used != bestBasin());
  backToBest_->setEnabled(!busy);
}

}  // namespace falciform
