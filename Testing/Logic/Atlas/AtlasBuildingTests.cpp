#include <gmock/gmock.h>

#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/ModeCompression.h"
#include "Logic/Biomechanics/ConstrainedStiffness.h"
#include "Logic/Biomechanics/DeformationCheck.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Testing/Logic/Atlas/SlabLiver.h"

namespace falciform::test {
namespace {

/// A member solved for itself alone, by elimination.
Points solvedAlone(const SlabLiver& slab, const AtlasDesign& design, const AtlasSetup& setup,
                   const AtlasMember& member) {
  std::vector<Support> supports = setup.supports;
  if (setup.pushed >= 0) supports[static_cast<std::size_t>(setup.pushed)].pushMm = member.pushMm;
  const std::vector<Material> materials = materialsOf(design, setup.stiffnessRatio);
  const ConstrainedStiffness solver(
      assembleStiffness(slab.mesh, materials),
      nodeConstraints(slab.faces, nodeNormals(slab.faces, slab.mesh.nodes()), supports));
  return solver.solve(weightForces(slab.mesh, materials, member.gravityChangeMPerS2));
}

/// Everything but the compression: displacements of the solves.
std::vector<Points> solveAll(const AtlasJob& job) {
  std::vector<Points> fields(job.solves.solves.size());
  std::vector<int> batches;
  for (std::size_t b = 0; b < job.solves.batches.size(); ++b) batches.push_back(static_cast<int>(b));
  solveBatches(job.mesh, job.design, job.members, job.solves, batches, [&](int b, std::vector<Points> done) {
    std::move(done.begin(), done.end(),
              fields.begin() + job.solves.batches[static_cast<std::size_t>(b)].first);
  });
  return fields;
}

TEST(AtlasBuilding, GravityMembersOfThreeSolvesAreThoseOf121) {
  const SlabLiver slab = slabLiver();
  AtlasDesign design = atlasPreset("thesis-gravity");
  design.energy = 1;
  const AtlasJob job = prepareAtlas(slab.mesh, slab.sites, design);
  ASSERT_EQ(job.solves.solves.size(), 3u);
  const std::vector<Points> fields = solveAll(job);
  const Atlas atlas = assembleAtlas(job, fields);
  ASSERT_EQ(atlas.members.size(), 121u);
  EXPECT_EQ(atlas.rank(), 3);
  for (std::size_t m = 0; m < 121; ++m) {
    const Points alone = solvedAlone(slab, design, atlas.setups[0], atlas.members[m]);
    const Points member = fieldOf(fields, job.solves.combinations.row(static_cast<Index>(m)));
    const double size = std::max(largest(alone), 1e-6);
    EXPECT_LE(largest(member - alone), 1e-9 * size) << m;  // relative: rounding of the factor
    EXPECT_LE(largest(memberDisplacements(atlas, static_cast<Index>(m)) - alone), 1e-9 * size) << m;
  }
}

TEST(AtlasBuilding, PackingMembersAreThoseSolvedAloneAndGrowWithThePush) {
  const SlabLiver slab = slabLiver();
  AtlasDesign design = atlasPreset("thesis-packing");
  design.packing = {.places = 6, .extentMm = 18, .stepMm = 5, .maxPushMm = 45};
  const AtlasJob job = prepareAtlas(slab.mesh, slab.sites, design);
  ASSERT_EQ(job.members.members.size(), 54u);
  ASSERT_EQ(job.solves.solves.size(), 6u);
  const std::vector<Points> fields = solveAll(job);
  for (const std::size_t m : {0u, 13u, 31u, 53u}) {
    const AtlasMember& member = job.members.members[m];
    const Points alone =
        solvedAlone(slab, design, job.members.setups[static_cast<std::size_t>(member.setup)], member);
    // Single precision, some 1e-6 of the largest displacement.
    EXPECT_LT(largest(fieldOf(fields, job.solves.combinations.row(static_cast<Index>(m))) - alone),
              2e-5 * largest(alone));
  }
  const Atlas atlas = assembleAtlas(job, fields);
  for (Index m = 1; m < 9; ++m)  // the first place's nine pushes
    EXPECT_LT(largest(memberDisplacements(atlas, m) - (m + 1.0) * memberDisplacements(atlas, 0)), 1e-10);
  EXPECT_LE(atlas.rank(), 6);
}

TEST(AtlasBuilding, SampledMembersAreThoseSolvedAlone) {
  const SlabLiver slab = slabLiver(true);
  AtlasDesign design;
  design.kind = AtlasKind::Sampled;
  design.energy = 1;
  design.sampled = {.members = 14,
                    .setups = 4,
                    .minExtentMm = 12,
                    .maxExtentMm = 25,
                    .maxPushMm = 20,
                    .minStiffnessRatio = 1,
                    .maxStiffnessRatio = 6,
                    .stiffnessLevels = 2};
  design.supportSets.push_back({"off the bed", {"venaCava"}, {}});
  const AtlasJob job = prepareAtlas(slab.mesh, slab.sites, design);
  EXPECT_EQ(job.solves.solves.size(), 14u);  // setups of 4 and 3 members: none can be spared
  const Atlas atlas = assembleAtlas(job, solveAll(job));
  for (Index m = 0; m < 14; ++m) {
    const AtlasMember& member = atlas.members[static_cast<std::size_t>(m)];
    const Points alone =
        solvedAlone(slab, design, atlas.setups[static_cast<std::size_t>(member.setup)], member);
    EXPECT_LT(largest(memberDisplacements(atlas, m) - alone), 5e-5 * largest(alone)) << m;
  }
}

TEST(AtlasBuilding, MembersBeyondFourASetupCostNoSolve) {
  AtlasDesign design;
  design.kind = AtlasKind::Sampled;
  design.sampled = {.members = 50, .setups = 5};
  const AtlasJob job = prepareAtlas(slabLiver().mesh, slabLiver().sites, design);
  EXPECT_EQ(job.solves.solves.size(), 20u);
}

TEST(AtlasBuilding, FiguresAreThoseOfTheMembers) {
  const SlabLiver slab = slabLiver();
  AtlasDesign design = atlasPreset("thesis-packing");
  design.packing = {.places = 3, .extentMm = 18, .stepMm = 10, .maxPushMm = 40};
  design.energy = 0.95;
  const AtlasJob job = prepareAtlas(slab.mesh, slab.sites, design);
  const std::vector<Points> fields = solveAll(job);
  const Atlas atlas = assembleAtlas(job, fields);
  ASSERT_LT(atlas.rank(), 3);
  EXPECT_EQ(atlas.solves, 3);
  EXPECT_GE(atlas.energy, 0.95);
  const StiffnessMatrix stiffness = assembleStiffness(slab.mesh, materialsOf(design));
  const VectorXd shares = atlas.nodeVolumesMm3 / atlas.nodeVolumesMm3.sum();
  for (Index m = 0; m < 12; ++m) {
    const MemberFigures& figures = atlas.figures[static_cast<std::size_t>(m)];
    const Points member = fieldOf(fields, job.solves.combinations.row(m)),
                 kept = memberDisplacements(atlas, m);
    EXPECT_NEAR(figures.maxMm, largest(member), 1e-10);
    EXPECT_NEAR(figures.rmsMm, std::sqrt(member.rowwise().squaredNorm().dot(shares)), 1e-10);
    EXPECT_NEAR(figures.errorMm, std::sqrt((member - kept).rowwise().squaredNorm().dot(shares)), 1e-6);
    EXPECT_NEAR(figures.energyNMm, 0.5 * kept.cwiseProduct(stiffness.times(kept)).sum(),
                1e-9 * figures.energyNMm);
    const DeformationCheck check = checkDeformation(slab.mesh, member);
    EXPECT_NEAR(figures.minDetJ, check.minDetJ, 1e-9);
    EXPECT_NEAR(figures.foldedShare, check.foldedShare, 1e-9);
  }
}

TEST(AtlasBuilding, GivesTheSameBitsForAnyNumberOfThreadsAndAnySharing) {
  const SlabLiver slab = slabLiver();
  AtlasDesign design = atlasPreset("thesis-packing");
  design.packing.places = 8;
  setThreads(1);
  const Atlas one = buildAtlas(slab.mesh, slab.sites, design);
  setThreads(3);
  // The second batch by somebody else, first.
  const AtlasJob job = prepareAtlas(slab.mesh, slab.sites, design);
  ASSERT_EQ(job.solves.batches.size(), 2u);
  std::vector<Points> fields(8);
  for (const int batch : {1, 0})
    solveBatches(job.mesh, job.design, job.members, job.solves, {batch},
                 [&](int b, std::vector<Points> done) {
                   std::move(done.begin(), done.end(),
                             fields.begin() + job.solves.batches[static_cast<std::size_t>(b)].first);
                 });
  const Atlas three = assembleAtlas(job, fields);
  setThreads(0);
  EXPECT_EQ(one.coefficients, three.coefficients);
  EXPECT_EQ(one.stiffness, three.stiffness);
  ASSERT_EQ(one.rank(), three.rank());
  for (std::size_t k = 0; k < one.modes.size(); ++k) EXPECT_EQ(one.modes[k], three.modes[k]);
  for (std::size_t m = 0; m < one.figures.size(); ++m) {
    EXPECT_EQ(one.figures[m].minDetJ, three.figures[m].minDetJ);
    EXPECT_EQ(one.figures[m].foldedShare, three.figures[m].foldedShare);
  }
}

TEST(AtlasBuilding, SupportsThatDoNotHoldTheLiverAreNamed) {
  const SlabLiver slab = slabLiver();
  AtlasDesign design = atlasPreset("thesis-gravity");
  design.supportSets = {{"sliding only", {}, {"posteriorBed"}}};
  try {
    (void)buildAtlas(slab.mesh, slab.sites, design);
    FAIL() << "a liver that can slide away was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("do not hold the liver"));
  }
}

}  // namespace
}  // namespace falciform::test
