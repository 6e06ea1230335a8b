#pragma once
#include "Logic/Biomechanics/LiverMesh.h"
#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

/// A liver to compute with: its surface, which may carry patches, and the tetrahedra inside.
struct LiverInput {
  Surface surface;  ///< the pre-operative one, or the mesh's boundary where there is none
  TetrahedralMesh mesh;
};

/// --preop, --mesh and --tumours. Mesh settings are declared apart.
void declareLiverInput(Syntax& syntax, const std::string& group);

/// Reads the mesh, or makes one of the surface; `meshing` holds where no argument says otherwise, and is what
/// was declared. Throws InputError if neither is given or they are of different frames.
[[nodiscard]] LiverInput readLiverInput(const ParsedArguments& arguments, CommandRun& run,
                                        const Progress& progress, const MeshSettings& meshing = {});

}  // namespace falciform::commandline
