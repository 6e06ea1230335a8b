#include "Logic/Atlas/LoadFiles.h"

#include "Logic/Atlas/AtlasHead.h"
#include "Logic/Atlas/Hdf5Mesh.h"
#include "Logic/Atlas/SealedFile.h"
#include "Logic/Core/Errors.h"

namespace falciform {

LoadAtlas buildLoadAtlas(const TetrahedralMesh& mesh, const AtlasDesign& design, const Progress& progress) {
  const SurfaceLoadSettings& s = design.surfaceLoads;
  return {design, solveSurfaceLoads(mesh, materialsOf(design), {.centres = s.centres, .radiusMm = s.radiusMm},
                                    progress)};
}

void writeLoadAtlas(const std::filesystem::path& path, const LoadAtlas& atlas,
                    const nlohmann::json& provenance) {
  const LoadResponses& loads = atlas.loads;
  const auto count = static_cast<std::uint64_t>(loads.loads()),
             nodes = static_cast<std::uint64_t>(loads.mesh.nodes());
  Hdf5Writer file(path);
  writeAtlasHead(file, atlas.design, provenance);
  writeMeshArrays(file, loads.mesh);
  file.numbers("loads/centres_mm", loads.centres.data(), {count / 3, 3});
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> fields =
      loads.responses.cast<double>();
  file.numbers("loads/displacement", fields.data(), {count, nodes, 3});
  file.numbers("loads/rms", loads.rmsMm.data(), {count});
  file.close();
  sealFile(path, kAtlasFileKind, kAtlasFileVersion);
}

StoredLoads readLoadAtlas(const std::filesystem::path& path) {
  checkSeal(path, kAtlasFileKind, kAtlasFileVersion);
  const Hdf5Reader file(path);
  AtlasHead head = readAtlasHead(file, path);
  if (head.design.kind != AtlasKind::SurfaceLoads)
    throw InputError("'" + path.string() + "' is an atlas of deformations (" +
                     enumToString(head.design.kind) + "), not of surface loads; build one of surface-loads");
  StoredLoads stored{{std::move(head.design), {}}, std::move(head.provenance)};
  LoadResponses& loads = stored.atlas.loads;
  loads.mesh = readMeshArrays(file, path.string());
  const Index nodes = loads.mesh.nodes();
  Lengths centres{Hdf5Reader::kAny, 3};
  const std::vector<double> places = file.numbers("loads/centres_mm", centres);
  Lengths shape{3 * centres[0], static_cast<std::uint64_t>(nodes), 3}, sizes{3 * centres[0]};
  const std::vector<double> fields = file.numbers("loads/displacement", shape),
                            rms = file.numbers("loads/rms", sizes);
  const auto count = static_cast<Index>(sizes[0]);
  loads.centres = Eigen::Map<const Points>(places.data(), count / 3, 3);
  loads.responses = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
                        fields.data(), count, 3 * nodes)
                        .cast<float>();
  loads.rmsMm = Eigen::Map<const VectorXd>(rms.data(), count);
  if (!loads.centres.allFinite() || !loads.responses.allFinite() || !loads.rmsMm.allFinite() ||
      !(loads.rmsMm.minCoeff() > 0))
    refuseInconsistent(path, "it holds numbers that are not finite");
  return stored;
}

AtlasKind atlasKindOf(const std::filesystem::path& path) {
  checkSeal(path, kAtlasFileKind, kAtlasFileVersion);
  return readAtlasHead(Hdf5Reader(path), path).design.kind;
}

}  // namespace falciform
