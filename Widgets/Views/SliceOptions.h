#pragma once
#include <array>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// Which values are grey: black at level - width / 2, white at level + width / 2.
struct GreyWindow {
  double level = 80, width = 400;  ///< Hounsfield units; the usual ones for a liver

  bool operator==(const GreyWindow&) const = default;
};

struct GreyPreset {
  const char* name;
  GreyWindow window;
};
/// The windows that radiologists know by name, the first the one that slices begin with.
[[nodiscard]] const std::vector<GreyPreset>& greyPresets();

/// What the left mouse button does in slices.
enum class SliceTool {
  Look,   ///< moves the cursor, which all cuts share
  Seed,   ///< tells where the organ is
  Paint,  ///< a round brush adds to the label map,
  Erase,  ///< or takes away
};

/// The mouse at a place of the patient, with a tool in hand; or a key that takes back what a tool did.
struct SliceTouch {
  enum class What { Press, Move, Release, Undo, Redo } what = What::Press;
  Vector3d mm = Vector3d::Zero();  ///< LPS
};

/// Colour of a label above 0, red, green, blue in [0, 1]: the liver's for 1, then those of Okabe and Ito
/// (2008), which the colour blind can tell apart; repeats after the eighth.
[[nodiscard]] std::array<double, 3> labelColour(int label);

}  // namespace falciform
