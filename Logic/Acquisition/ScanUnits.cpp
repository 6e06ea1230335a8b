#include "Logic/Acquisition/ScanUnits.h"

#include "Logic/Geometry/Measures.h"

namespace falciform {

namespace {

constexpr double kSmallestMm = 60, kLargestMm = 1500;  // what a scan of a liver in its surroundings measures
constexpr double kTinyMm = 20, kHugeMm = 3000;         // no scan of a liver at all
constexpr LengthUnit kUnits[] = {LengthUnit::Millimetres, LengthUnit::Metres, LengthUnit::Centimetres,
                                 LengthUnit::Micrometres};

}  // namespace

double millimetresIn(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Centimetres:
      return 10;
    case LengthUnit::Metres:
      return 1000;
    case LengthUnit::Micrometres:
      return 0.001;
    case LengthUnit::Automatic:
    case LengthUnit::Millimetres:
      break;
  }
  return 1;
}

UnitGuess guessUnit(const Points& points) {
  UnitGuess guess;
  if (points.rows() < 2) return guess;
  const auto box = boundingBox(points);
  guess.extent = (box.row(1) - box.row(0)).maxCoeff();
  bool found = false;
  int possible = 0;
  for (const LengthUnit unit : kUnits) {
    const double mm = guess.extent * millimetresIn(unit);
    possible += mm > kTinyMm && mm < kHugeMm;
    if (found || mm < kSmallestMm || mm > kLargestMm) continue;
    guess.unit = unit;
    found = true;
  }
  guess.certain = found && possible == 1;
  return guess;
}

}  // namespace falciform
