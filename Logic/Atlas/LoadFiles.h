#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/Atlas/SurfaceLoads.h"

namespace falciform {

/// A liver's answers to surface loads, and the design (of kind surfaceLoads) that they were solved by.
struct LoadAtlas {
  AtlasDesign design;
  LoadResponses loads;
};

/// Solves a design of kind surfaceLoads. Throws InputError as solveSurfaceLoads does.
[[nodiscard]] LoadAtlas buildLoadAtlas(const TetrahedralMesh& mesh, const AtlasDesign& design,
                                       const Progress& progress = {});

/// The atlas file of that kind, with the seal, version, mesh and provenance that every atlas file has; the
/// loads' own arrays are loads/centres_mm, loads/displacement and loads/rms. As writeAtlas.
void writeLoadAtlas(const std::filesystem::path& file, const LoadAtlas& atlas,
                    const nlohmann::json& provenance);

struct StoredLoads {
  LoadAtlas atlas;
  nlohmann::json provenance;
};
/// Throws InputError as readAtlas does.
[[nodiscard]] StoredLoads readLoadAtlas(const std::filesystem::path& file);

/// Of which kind an atlas file is. Throws InputError as readAtlas does, without reading what the file holds.
[[nodiscard]] AtlasKind atlasKindOf(const std::filesystem::path& file);

}  // namespace falciform
