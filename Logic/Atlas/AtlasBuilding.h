#pragma once
#include "Logic/Atlas/Atlas.h"
#include "Logic/Atlas/AtlasSolves.h"

namespace falciform {

/// A design on one liver, ready to be solved in parts.
struct AtlasJob {
  TetrahedralMesh mesh;
  AtlasDesign design;
  AtlasMembers members;
  AtlasSolves solves;
};

/// Throws InputError where the design does not fit the liver.
[[nodiscard]] AtlasJob prepareAtlas(const TetrahedralMesh& mesh, const SupportSites& sites,
                                    const AtlasDesign& design);

/// Compresses the members and measures them, from the displacements of all solves in order. The same bits
/// whoever solved them, for any number of threads.
[[nodiscard]] Atlas assembleAtlas(const AtlasJob& job, const std::vector<Points>& solved,
                                  const Progress& progress = {});

/// All of it in one go: solves what is linearly independent, forms every member from that, compresses.
[[nodiscard]] Atlas buildAtlas(const TetrahedralMesh& mesh, const SupportSites& sites,
                               const AtlasDesign& design, const Progress& progress = {});

}  // namespace falciform
