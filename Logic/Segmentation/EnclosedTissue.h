#pragma once
#include <cstdint>
#include <vector>

#include "Logic/Segmentation/LevelSetTissue.h"

namespace falciform {

/// Which darker tissue beside an organ belongs to it.
struct EnclosedPlan {
  double lowHu = 20;            ///< water, bile, cysts, effusions and fat lie below
  double darkHu = 70;           ///< the organ's own tissue begins here
  double brightHu = 130;        ///< and ends here
  double leastRadiusMm = 6;     ///< a body must hold such a ball; smaller ones are gaps, filled as such
  double leastMl = 2;           ///< a ball of 16 mm; what is smaller is not worth a word
  double narrowestMm = 4.5;     ///< necks thinner than this are no part of a body
  double rimMm = 15;            ///< rims of the organ's brightness are followed so far from the organ
  double enclosedShare = 0.55;  ///< of a body's border, lung left out, that the organ covers: above half of
                                ///< it the organ's surface shrinks as it is taken in
  double touchingShare = 0.4;   ///< of the whole border, lung counted: the heart lies on the liver with less
  double mostShare = 0.2;       ///< of the organ's volume: a larger body is a neighbour
};

/// A body of darker tissue with the organ around it.
struct EnclosedBody {
  Volume<std::uint8_t> region;
  Tissue tissue;
  double volumeMl = 0;
  double enclosedShare = 0;           ///< of its border, lung left out
  Vector3d place = Vector3d::Zero();  ///< its deepest place, LPS mm
};

/// Bodies of soft tissue darker than the organ that the organ encloses for the most part: tumours that reach
/// its border. A body is all that balls of one radius cover that hang together; of the radii tried, the
/// smallest whose body still is enclosed decides, so that a tumour is parted from the muscle, stomach or
/// diaphragm that it touches. What touches the lung through the diaphragm counts as neither enclosed nor
/// open: above the liver's dome nothing else lies between the two. A body beside the organ is open on half
/// its border or more. `image` in HU, smoothed; `organ` and `barred` (nothing is taken in there; may be
/// empty) on its grid. Largest first.
[[nodiscard]] std::vector<EnclosedBody> enclosedBodies(const Image& image, const Volume<std::uint8_t>& organ,
                                                       const Volume<std::uint8_t>& barred,
                                                       const EnclosedPlan& plan);

}  // namespace falciform
