#pragma once
#include <set>

#include "Testing/Gui/SmoothFixture.h"
#include "Widgets/Views/SliceView.h"

namespace falciform::test {

/// The import step, used by mouse in its slices; notes the fronts that it shows on the way.
struct ImportFixture : SmoothFixture {
  void SetUp() override;

  SliceView& slice(const char* plane) { return control<SliceView>(plane); }
  /// Brings all cuts to a place: a Ctrl-click in two of them, whatever tool is in hand.
  void goTo(const Vector3d& mm);
  void clickAxial(const Vector3d& mm);
  /// One seed at each place, by clicks.
  void seed(const std::vector<Vector3d>& places);
  void dragIn(SliceView& view, Qt::MouseButton button, const std::vector<QPoint>& way);

  /// Of all labels.
  [[nodiscard]] double volumeMl() const;
  [[nodiscard]] bool isLabelled(const Vector3d& mm) const;
  /// The value in the row of the quality table that begins with `row`.
  [[nodiscard]] QString quality(const QString& row);

  std::set<std::shared_ptr<const Surface>> fronts;

 private:
  Connection live_;
};

/// 2 |A and B| / (|A| + |B|) of the voxels above 0.
[[nodiscard]] double dice(const LabelMap& a, const LabelMap& b);

}  // namespace falciform::test
