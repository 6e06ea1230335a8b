#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "Logic/Atlas/DesignSettings.h"
#include "Logic/Biomechanics/Material.h"

namespace falciform {

/// What holds the liver: regions of its surface by their names in `supportRegionNames()`.
struct SupportSet {
  std::string name;
  std::vector<std::string> fixed, sliding;
};

/// Which deformations an atlas holds, and of what tissue: all that, with a mesh, determines it.
struct AtlasDesign {
  AtlasKind kind = AtlasKind::Packing;
  TissueSettings liver;
  TissueSettings tumour{.youngsModulusKPa =
                            30};  ///< of all tumours; its stiffness is `sampled`'s in that kind
  std::vector<SupportSet> supportSets{{"on the back", {"venaCava"}, {"posteriorBed"}}};
  GravityDesignSettings gravityDirections;
  PackingDesignSettings packing;
  SampledDesignSettings sampled;
  SurfaceLoadSettings surfaceLoads;
  double energy = 0.99999;  ///< share of the mean squared displacement that the kept modes hold
  std::uint64_t seed = 1;   ///< of the sampling
};

/// "venaCava", "posteriorBed", "leftUnderside", "rightUnderside": SupportSites' members.
[[nodiscard]] const std::vector<std::string>& supportRegionNames();

/// "thesis-gravity" and "thesis-packing": the two atlases of chapter V, of 121 and 180 members, with the
/// materials printed there (a liver's, and the phantom's); "surface-loads": what the model update fits.
[[nodiscard]] const std::vector<std::string>& atlasPresets();
/// Throws InputError that lists the presets.
[[nodiscard]] AtlasDesign atlasPreset(const std::string& name);

/// Of {"kind", "preset", "liver", "tumour", "supportSets", "energy", "seed", and the kind's own name with its
/// settings}; what is missing keeps its default or the preset's value. Throws InputError for unknown keys,
/// wrong kinds, values out of range or at odds with each other.
[[nodiscard]] AtlasDesign designFromJson(const nlohmann::json& json);
/// All of it, defaults too, the settings of other kinds left out: reads back as the same design.
[[nodiscard]] nlohmann::json toJson(const AtlasDesign& design);

/// Of liver and tumours, the tumours' stiffness by `stiffnessRatio` times the liver's if it is above 0.
[[nodiscard]] std::vector<Material> materialsOf(const AtlasDesign& design, double stiffnessRatio = 0);

}  // namespace falciform
