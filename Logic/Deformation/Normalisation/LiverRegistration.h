#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"
#include "Logic/Deformation/Normalisation/LiverMap.h"

namespace falciform {

/// How one patient's liver is brought onto another's.
struct NormalisationSettings {
  int levels = 15;                ///< of basis functions, from three centres across the liver
  double finestMm = 6;            ///< spacing of the last level's centres
  double compressionLimit = 0.5;  ///< of each level: see BasisWarp::compression
};

template <class Visitor>
void describe(NormalisationSettings& s, Visitor&& field) {
  field(FieldInfo{"levels", "Levels", "", 1, 40,
                  "Levels of basis functions, from three centres across the liver to the finest spacing."},
        s.levels);
  field(FieldInfo{"finestMm", "Finest spacing", "mm", 2, 100, "Spacing of the last level's centres."},
        s.finestMm);
  field(FieldInfo{"compressionLimit", "Compression limit", "", 0.05, 0.9,
                  "By how much one level may press tissue together, as a share; below 1 no place folds."},
        s.compressionLimit);
}

/// The map that carries the target liver onto the source liver: rigid, then affine, then level by level
/// (adaptive bases with Wu functions), so that signed distances to the two surfaces agree (thesis ch. IV;
/// METHODS 3.3). Both closed, triangles outwards, LPS mm: patients lie alike, no start is searched for.
/// Throws InputError if a surface is not closed or faces inwards. Says nothing about motion along the
/// surface.
[[nodiscard]] LiverMap registerLivers(const Surface& target, const Surface& source,
                                      const NormalisationSettings& settings = {},
                                      const Progress& progress = {});

/// The CTs of the two patients.
struct CtPair {
  const Image& target;
  const Image& source;
};

/// The same with the thesis's measure: rigid and affine by the surfaces, the levels by mutual information of
/// the CTs in and around the target's liver, soft tissue alone (-150 to 250 HU).
[[nodiscard]] LiverMap registerLivers(const Surface& target, const Surface& source, const CtPair& images,
                                      const NormalisationSettings& settings = {},
                                      const Progress& progress = {});

}  // namespace falciform
