#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "Logic/Acquisition/ScanPreparation.h"
#include "Logic/Core/Case.h"

namespace falciform {

/// Labels by which the scan of the case shows what is to become of its points, so that views draw them and
/// the brush mends them: kFirst + ScanMark for those that go, kSeed where the user says "here is liver".
namespace scan_label {
inline constexpr int kFirst = 200;
inline constexpr int kByHand = kFirst + static_cast<int>(ScanMark::ByHand);
inline constexpr int kSeed = kByHand + 1;
[[nodiscard]] inline bool goes(int label) { return label > kFirst && label <= kByHand; }
}  // namespace scan_label

/// Prepares the case's scan in steps that can be looked at: mark, mend by brush, finish, or back to the raw
/// scan. Main thread only; the jobs that it prepares may run anywhere.
class ScanPreparationLogic {
 public:
  explicit ScanPreparationLogic(Case& document);

  ScanPreparationSettings settings;

  /// "Open a scan first.", or empty.
  [[nodiscard]] std::string missingInput() const;
  /// "Mark what goes first.", or empty.
  [[nodiscard]] std::string missingMarks() const;

  /// Marks the raw scan: by the settings, from where the user painted kSeed. Throws as markScan does.
  [[nodiscard]] std::function<MarkedScan(const Progress&)> prepareMarks();
  /// Puts the marks into the case as labels of its scan. What was painted by hand since the last marks
  /// stands, also against the new ones. Ignored if another scan was opened meanwhile.
  void acceptMarks(MarkedScan marked);

  /// Takes the marks' labels off the case's scan, so that no other step takes them for patches, and puts them
  /// back. The scan keeps its unit.
  void hideMarks();
  void showMarks();

  /// The scan without the points that carry a label that goes; other patches are kept.
  [[nodiscard]] std::function<Surface(const Progress&)> prepareFinish();
  void acceptFinish(Surface prepared);

  /// The scan as it was opened, marks and patches painted here forgotten.
  void restoreRaw();
  [[nodiscard]] bool canRestore() const;

  /// What the marks as they stand, brush included, say; nullptr before the first.
  [[nodiscard]] const MarkedScan* marked() const;
  [[nodiscard]] Index count(ScanMark mark) const;  ///< as the scan's labels stand
  [[nodiscard]] UnitGuess unitGuess() const;       ///< of the raw scan

 private:
  void follow();
  void gatherHandwork();
  [[nodiscard]] Points seeds() const;
  [[nodiscard]] ScanMark markAt(Index point) const;

  enum class ByHand : char { No, Stays, Goes, Seed };

  Case& case_;
  std::shared_ptr<const Surface> raw_;    ///< as opened
  std::shared_ptr<const Surface> shown_;  ///< the last one that we put into the case
  std::shared_ptr<const Surface> finished_;
  std::unique_ptr<MarkedScan> marked_;
  std::vector<ByHand> byHand_;
  std::vector<int> shownLabels_;
  Connection watching_;
};

}  // namespace falciform
