#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// What stands for values beyond the ends of the scale.
enum class OutOfRange {
  Grey,  ///< dark grey, so that only values on the scale have colours
  Ends,  ///< a darker shade of the scale's end, so that the sign stays visible
};

/// Which colours a scale runs through; both are safe for the colour blind.
enum class Palette {
  Diverging,   ///< for signed values: blue, pale yellow in the middle, red
  Sequential,  ///< for magnitudes: dark violet, green, yellow
};

/// How an analysis array becomes colours. The middle of the diverging colours is 0 whatever the ends are, and
/// as much above it as below looks alike: ends that differ cut the longer side's colours short.
struct ScalarMap {
  std::string array;  ///< a key of Surface::arrays
  std::string title;  ///< of the colour bar, "Signed distance"
  std::string unit;   ///< "mm"
  double low = -1, high = 1;
  OutOfRange outOfRange = OutOfRange::Grey;
  Palette palette = Palette::Diverging;
  double threshold = 0;              ///< values of a smaller size are pale grey; 0: none are
  std::string noValue = "no value";  ///< what the bar calls NaN

  bool operator==(const ScalarMap&) const = default;
};

/// Grey of places without a value (NaN), lighter than the grey of values off the scale.
inline const Vector3d kNoValueColour{0.66, 0.66, 0.66};
inline const Vector3d kOffScaleColour{0.30, 0.30, 0.30};
/// Of values below the threshold.
inline const Vector3d kBelowThresholdColour{0.88, 0.88, 0.88};

/// The colour of `value`, in [0, 1]: of ColorBrewer's RdYlBu or of Matplotlib's viridis, on which no colour
/// is grey; kNoValueColour for NaN.
[[nodiscard]] Vector3d colourOf(const ScalarMap& map, double value);

/// A map that is symmetric around 0 and holds every finite value of `array` on all `surfaces`, its end
/// rounded up to 1, 1.5, 2, 3, 4, 5, 6, 8 x 10^k; +-1 where there is no value. One range for surfaces that
/// are to be compared.
[[nodiscard]] ScalarMap symmetricMap(const std::string& array, const std::string& title,
                                     const std::string& unit, const std::vector<const Surface*>& surfaces);

/// The end of a symmetric scale that holds `share` of the finite values, rounded up in the same way: a few
/// stray ones do not flatten all others. 1 where there is no value, or all are 0.
[[nodiscard]] double symmetricEnd(const VectorXd& values, double share = 0.98);

/// A sequential map from 0 to an end that holds `largest`, rounded up in the same way.
[[nodiscard]] ScalarMap magnitudeMap(const std::string& array, const std::string& title,
                                     const std::string& unit, double largest);

/// Values at which a colour bar is labelled: round, ascending, both ends among them where they are round.
[[nodiscard]] std::vector<double> tickValues(double low, double high, int atMost = 9);

}  // namespace falciform
