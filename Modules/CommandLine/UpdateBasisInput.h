#pragma once
#include "Logic/Atlas/UpdateMethods.h"
#include "Modules/CommandLine/LiverInput.h"

namespace falciform::commandline {

/// --atlas and --method.
void declareUpdateBasis(Syntax& syntax, const std::string& group);

/// What `falciform update` knows before the scan.
struct UpdateBasisInput {
  LiverInput liver;
  UpdateMethod method = UpdateMethod::Loads;
  UpdateBasis basis;
};

/// The liver with the mesh of --atlas, or else as readLiverInput has it. Throws InputError for an atlas
/// beside a mesh, or one that cannot be read.
[[nodiscard]] UpdateBasisInput readUpdateBasis(const ParsedArguments& arguments, CommandRun& run,
                                               const MeshSettings& meshing, const Progress& progress);

}  // namespace falciform::commandline
