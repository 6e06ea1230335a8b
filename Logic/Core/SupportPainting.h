#pragma once
#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// How a painted part of the liver's surface is held.
enum class SupportRegionKind {
  Fixed,    ///< does not move
  Sliding,  ///< stays on its surface, moves freely along it
  Pushed,   ///< pushed inwards by a given distance, moves freely along its surface
};

inline std::span<const std::string_view> enumNames(SupportRegionKind) {
  static constexpr std::array<std::string_view, 3> names{"fixed", "sliding", "pushed"};
  return names;
}

struct SupportRegion {
  std::string name;
  SupportRegionKind kind = SupportRegionKind::Fixed;
  double pushMm = 0;  ///< of a pushed one: into the liver, in [-kMaxPushMm, kMaxPushMm]

  bool operator==(const SupportRegion&) const = default;
};

inline constexpr double kMaxPushMm = 60;

/// Labels of the regions that every painting knows, so that templates and the brush mean the same by them.
namespace support_label {
inline constexpr int kFree = 0, kVenaCava = 1, kPosteriorBed = 2, kLeftPacking = 3, kRightPacking = 4;
inline constexpr int kFirstNamed = 5;  ///< 5 to 255 are named by the user
inline constexpr int kMax = 255;
}  // namespace support_label

/// What holds and pushes the liver, painted on the pre-operative surface as a second layer of labels beside
/// the patches. Where nothing is painted the surface is free.
struct SupportPainting {
  std::vector<int> labels;               ///< one a point of the pre-operative surface; 0: free
  std::map<int, SupportRegion> regions;  ///< by label; painted labels are among them
  double turnDeg = 0;                    ///< of the patient onto the left side since the CT, in [-90, 90]

  bool operator==(const SupportPainting&) const = default;
};

/// The four regions of `support_label` and no point painted, for a surface of `points` points.
[[nodiscard]] SupportPainting emptySupportPainting(Index points);

/// Labels above 0 that occur, ascending.
[[nodiscard]] std::vector<int> paintedSupports(const SupportPainting& painting);

/// Checks that there is one label a point, that each has a region, and that numbers lie in their ranges;
/// throws InputError that names `what` otherwise.
void checkSupportPainting(const SupportPainting& painting, Index points, const std::string& what);

}  // namespace falciform
