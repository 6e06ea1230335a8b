#pragma once
#include <optional>
#include <string>
#include <vector>

#include "Logic/Acquisition/ScanUnits.h"
#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// How a raw range scan becomes the liver's surface (thesis ch. II and IV: "the liver parenchyma was
/// segmented from the raw LRS data").
struct ScanPreparationSettings {
  LengthUnit unit = LengthUnit::Automatic;  ///< of the file's numbers
  double outlierSpread = 5;                 ///< 0: off
  double grazingDeg = 80;                   ///< 90: off
  double smallestPieceShare = 0.02;         ///< 0: off
  bool extract = true;                      ///< keep the liver alone
  double colourLimit = 3.5;                 ///< 0: colours do not count
  double creaseDeg = 35;                    ///< 180: off
  double bridgeMm = 5;                      ///< 0: off
  double closeMm = 12;                      ///< 0: off
  bool smooth = false;
  double spacingMm = 0;  ///< 0: as scanned
};

template <class Visitor>
void describe(ScanPreparationSettings& s, Visitor&& field) {
  field(FieldInfo{"unit", "Unit", "", 0, 0,
                  "Of the file's numbers; auto takes m or um where nothing else is possible, and says so."},
        s.unit);
  field(FieldInfo{"outlierSpread", "Outlier limit", "SD", 0, 100,
                  "Points off the plane of their neighbours by more standard deviations are dropped; 0 keeps "
                  "them."},
        s.outlierSpread);
  field(FieldInfo{"grazingDeg", "Grazing limit", "deg", 30, 90,
                  "Points where the surface turns further away from the scanner are dropped; 90 keeps them."},
        s.grazingDeg);
  field(FieldInfo{"smallestPieceShare", "Smallest piece", "", 0, 1,
                  "Pieces with a smaller share of the largest one's area are dropped; 0 keeps them."},
        s.smallestPieceShare);
  field(FieldInfo{"extract", "Liver only", "", 0, 1,
                  "Keep the liver, by colour and folds, grown from seeds or found by itself."},
        s.extract);
  field(FieldInfo{"colourLimit", "Colour limit", "SD", 0, 20,
                  "How far from the colour at the seeds the liver may be, in its standard deviations; 0: "
                  "colours do not count."},
        s.colourLimit);
  field(FieldInfo{"creaseDeg", "Fold limit", "deg", 5, 180,
                  "The liver ends at valleys that bend more over 6 mm; 180: at none."},
        s.creaseDeg);
  field(FieldInfo{"bridgeMm", "Narrowest bridge", "mm", 0, 50,
                  "What hangs on the liver by less is cut off; 0: nothing is."},
        s.bridgeMm);
  field(FieldInfo{"closeMm", "Widest strip", "mm", 0, 50,
                  "Strips of other colour up to this width are taken in, such as the falciform ligament."},
        s.closeMm);
  field(FieldInfo{"smooth", "Smooth", "", 0, 1, "Windowed-sinc smoothing of the kept surface."}, s.smooth);
  field(FieldInfo{"spacingMm", "Spacing", "mm", 0, 20,
                  "Thin the points to this distance of each other; 0 keeps all."},
        s.spacingMm);
}

/// What becomes of a point.
enum class ScanMark : char { Kept, Outlier, Grazing, SmallPiece, OtherTissue, ByHand };

inline std::span<const std::string_view> enumNames(ScanMark) {
  static constexpr std::array<std::string_view, 6> names{"kept",        "outlier",      "grazing",
                                                         "small piece", "other tissue", "removed by hand"};
  return names;
}

/// A scan in mm, and why each of its points stays or goes: to be looked at, and mended with a brush, before
/// finishScan drops anything.
struct MarkedScan {
  Surface scan;                 ///< the whole one, in mm
  std::vector<ScanMark> marks;  ///< one a point
  UnitGuess unit;               ///< as guessed
  double factor = 1;            ///< by which the numbers were multiplied
  Vector3d towardsScanner = Vector3d::UnitZ();
  std::vector<int> seeds;  ///< the points that the liver was grown from; empty: it was not
  bool automatic = false, byColour = false;
  std::vector<std::string> warnings;

  [[nodiscard]] Index count(ScanMark mark) const;
};

/// Scales to mm, finds false returns and the liver. `seeds`: places on the liver, mm in the scan's frame, or
/// none. `scannerAt`: where the scanner stood, mm in the scan's frame; by default far away on the side that
/// the scan faces. Triangles and normals are turned towards it. Throws InputError as findParenchyma does.
[[nodiscard]] MarkedScan markScan(const Surface& raw, const Points& seeds,
                                  const std::optional<Vector3d>& scannerAt,
                                  const ScanPreparationSettings& settings, const Progress& progress = {});

/// The kept points as a scan: smoothed and thinned as the settings say, points that lost all their triangles
/// dropped, with unit normals towards the scanner. Throws InputError if fewer than 3 points are left.
[[nodiscard]] Surface finishScan(const MarkedScan& marked, const ScanPreparationSettings& settings,
                                 const Progress& progress = {});

}  // namespace falciform
