#include "Logic/Atlas/AtlasBuilding.h"

#include <algorithm>
#include <numeric>

#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Biomechanics/DenseAlgebra.h"
#include "Logic/Core/Parallel.h"

namespace falciform {
namespace {

/// Q'KQ, N/mm: the modes' strain energy.
Eigen::MatrixXd modalStiffness(const StiffnessMatrix& stiffness, const std::vector<Points>& modes) {
  const auto rank = static_cast<Index>(modes.size());
  Eigen::MatrixXd result(rank, rank);
  forEachChunk(modes.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const Points forces = stiffness.times(modes[k]);
      for (Index i = 0; i < rank; ++i)
        result(i, static_cast<Index>(k)) = modes[static_cast<std::size_t>(i)].cwiseProduct(forces).sum();
    }
  });
  return (result + result.transpose()) / 2;
}

std::vector<FieldSum> sumsOf(const Eigen::MatrixXd& combinations) {
  std::vector<FieldSum> sums(static_cast<std::size_t>(combinations.rows()));
  for (Index m = 0; m < combinations.rows(); ++m)
    for (Index k = 0; k < combinations.cols(); ++k)
      if (combinations(m, k) != 0)
        sums[static_cast<std::size_t>(m)].emplace_back(static_cast<int>(k), combinations(m, k));
  return sums;
}

Points summed(const std::vector<Points>& fields, const FieldSum& sum, Index nodes) {
  Points result = Points::Zero(nodes, 3);
  for (const auto& [field, factor] : sum) result += factor * fields[static_cast<std::size_t>(field)];
  return result;
}

void measureDisplacements(const std::vector<Points>& solved, const std::vector<FieldSum>& sums,
                          const VectorXd& volumes, std::vector<MemberFigures>& figures) {
  forEachChunk(figures.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t m = first; m < last; ++m) {
      const VectorXd squares = summed(solved, sums[m], volumes.size()).rowwise().squaredNorm();
      figures[m].maxMm = std::sqrt(squares.maxCoeff());
      figures[m].rmsMm = std::sqrt(squares.dot(volumes) / volumes.sum());
    }
  });
}

}  // namespace

Points memberDisplacements(const Atlas& atlas, Index m) {
  if (atlas.modes.empty()) return Points::Zero(atlas.mesh.nodes(), 3);
  return fieldOf(atlas.modes, atlas.coefficients.row(m));
}

AtlasJob prepareAtlas(const TetrahedralMesh& mesh, const SupportSites& sites, const AtlasDesign& design) {
  checkMesh(mesh, "the mesh");
  AtlasJob job{.mesh = mesh, .design = design, .members = membersOf(design, sites), .solves = {}};
  job.solves = planSolves(job.members);
  return job;
}

Atlas assembleAtlas(const AtlasJob& job, const std::vector<Points>& solved, const Progress& progress) {
  keepBlasSingleThreaded();
  Atlas atlas;
  atlas.design = job.design;
  atlas.mesh = job.mesh;
  atlas.setups = job.members.setups;
  atlas.members = job.members.members;
  atlas.solves = static_cast<int>(job.solves.solves.size());
  atlas.nodeVolumesMm3 = nodalVolumes(job.mesh);
  progress.report(0, "Compressing");
  CompressedFields compressed =
      compressFields(solved, job.solves.combinations, atlas.nodeVolumesMm3, job.design.energy);
  atlas.modes = std::move(compressed.modes);
  atlas.coefficients = std::move(compressed.coefficients);
  atlas.singularValuesMm = std::move(compressed.singularValuesMm);
  atlas.energy = compressed.energy;
  progress.report(0.3, "Strain energy of the modes");
  atlas.stiffness = modalStiffness(assembleStiffness(job.mesh, materialsOf(job.design)), atlas.modes);
  progress.report(0.6, "Looking for folded tissue");
  const std::vector<FieldSum> sums = sumsOf(job.solves.combinations);
  const std::vector<DeformationCheck> checks = checkDeformations(job.mesh, solved, sums);
  atlas.figures.resize(atlas.members.size());
  measureDisplacements(solved, sums, atlas.nodeVolumesMm3, atlas.figures);
  for (std::size_t m = 0; m < atlas.figures.size(); ++m) {
    MemberFigures& figures = atlas.figures[m];
    figures.errorMm = compressed.errorsMm[static_cast<Index>(m)];
    figures.minDetJ = checks[m].minDetJ;
    figures.foldedShare = checks[m].foldedShare;
    const Eigen::RowVectorXd c = atlas.coefficients.row(static_cast<Index>(m));
    figures.energyNMm = 0.5 * c.dot(c * atlas.stiffness);
  }
  progress.report(1, "Atlas built");
  return atlas;
}

Atlas buildAtlas(const TetrahedralMesh& mesh, const SupportSites& sites, const AtlasDesign& design,
                 const Progress& progress) {
  const AtlasJob job = prepareAtlas(mesh, sites, design);
  std::vector<int> all(job.solves.batches.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<Points> solved;
  solveBatches(
      mesh, design, job.members, job.solves, all,
      [&](int, std::vector<Points> fields) {
        std::move(fields.begin(), fields.end(), std::back_inserter(solved));
      },
      progress.part(0, 0.85));
  return assembleAtlas(job, solved, progress.part(0.85, 1));
}

}  // namespace falciform
