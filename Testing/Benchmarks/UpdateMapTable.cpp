// ./run bench update-map [CASE]: how quickly an updated model answers where a place of the operating room is
// in the pre-operative CT, and how exactly, on a real bent liver, as a Markdown table.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "Logic/Atlas/BentImages.h"
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Core/Draws.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Regression/UpdateCase.h"

namespace falciform::test {
namespace {

constexpr Index kQueries = 100000;

/// Places around the bent liver, in scan mm: as many inside as outside, those within 30 mm of its box.
std::pair<Points, Points> queries(const UpdateMap& map) {
  Draws draws(1);
  const Vector3d low = map.deformed().lowest().array() - 30, high = map.deformed().highest().array() + 30;
  Points inside(kQueries, 3), outside(kQueries, 3);
  Index within = 0, beyond = 0;
  while (within < kQueries || beyond < kQueries) {
    Points some(50000, 3);
    for (Index i = 0; i < some.rows(); ++i)
      for (int a = 0; a < 3; ++a) some(i, a) = low[a] + (high[a] - low[a]) * draws.uniform();
    const Points scan = transformed(some, map.scanFromPreop());
    const std::vector<PreopPlace> places = map.preopFromScan(scan);
    for (Index i = 0; i < scan.rows(); ++i) {
      const bool in = places[static_cast<std::size_t>(i)].inside;
      Index& count = in ? within : beyond;
      if (count < kQueries) (in ? inside : outside).row(count++) = scan.row(i);
    }
  }
  return {inside, outside};
}

/// Per second of wall time, and of one processor's, which a busy machine does not change; the worst miss is
/// of the answers' own images.
void row(const char* what, Index count, const bench::Spent& spent, double worstMm) {
  const double queries = 1e3 * static_cast<double>(count);
  std::printf("| %s | %td | %.0f | %.0f | %.2g |\n", what, count, queries / spent.wallMs,
              queries / spent.cpuMs, worstMm);
  std::fflush(stdout);
}

/// Times the answers, checks each by its own image, and returns them.
Points askAll(const char* what, const UpdateMap& map, const Points& scan) {
  std::vector<PreopPlace> places;
  const bench::Spent spent = bench::measured([&] { places = map.preopFromScan(scan); });
  Points preop(scan.rows(), 3);
  for (Index i = 0; i < scan.rows(); ++i)
    preop.row(i) = places[static_cast<std::size_t>(i)].preop.transpose();
  row(what, scan.rows(), spent, (map.scanFromPreop(preop) - scan).rowwise().norm().maxCoeff());
  return preop;
}

/// A tracked tool on a straight way through the liver, each answer the guess for the next, on one thread.
void follow(const UpdateMap& map) {
  const Vector3d low = map.deformed().lowest(), high = map.deformed().highest();
  PreopPlace place;
  double worst = 0;
  const bench::Spent spent = bench::measured([&] {
    for (Index i = 0; i < kQueries; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(kQueries - 1);
      const PreopPlace next = map.preopFromBent(low + (high - low) * share, i > 0 ? &place : nullptr);
      place = next;
      worst = std::max(worst, place.missMm);
    }
  });
  row("a tool's way across, one thread", kQueries, spent, worst);
}

int run(const std::string& name) {
  const UpdateCase liver = readUpdateCase(name);
  MeshSettings mesh;
  mesh.edgeLengthMm = 13;
  const UpdateModel model(liver.preop,
                          solveSurfaceLoads(meshLiver(liver.preop, {}, mesh).mesh, {Material{}}));
  const RegistrationResult rigid = registerSurfaces(liver.preop, liver.scan, RegistrationSettings{});
  const UpdateResult update = updateModel(model, liver.scan, rigid.scanFromPreop);
  const TetrahedralMesh& solid = model.responses().mesh;
  const UpdateMap map(solid, update.displacements, update.scanFromPreop);
  std::printf("%s: %td quadratic tetrahedra, bent by up to %.1f mm.\n\n", name.c_str(), solid.size(),
              update.largestMm);
  const auto [inside, outside] = queries(map);
  std::puts("| query | places | a second | a second of one processor | worst miss mm |");
  std::puts("|---|---|---|---|---|");
  const Points preop = askAll("scan to CT, in the liver", map, inside);
  (void)askAll("scan to CT, outside, to 30 mm", map, outside);
  setThreads(1);
  (void)askAll("in the liver, one thread", map, inside);
  (void)askAll("outside, one thread", map, outside);
  follow(map);
  setThreads(0);
  Points there;
  const bench::Spent forward = bench::measured([&] { there = map.scanFromPreop(preop); });
  row("CT to scan", there.rows(), forward, (there - inside).rowwise().norm().maxCoeff());
  const SampledGrid grid = gridAroundLiver(map, Vector3i(256, 256, 120), [&] {
    Matrix4d voxel = Matrix4d::Identity();
    voxel.topLeftCorner<3, 3>().diagonal() << 1.4, 1.4, 1.6;
    voxel.topRightCorner<3, 1>() = map.deformed().lowest().array() - 20;
    return voxel;
  }());
  Image ct;
  ct.size = grid.size;
  ct.worldFromIndex = grid.worldFromIndex;
  ct.voxels.assign(static_cast<std::size_t>(ct.size.prod()), 1.0F);
  const bench::Spent bend = bench::measured([&] { (void)bendImage(map, ct, 0); });
  std::printf("\nBending a CT of %d x %d x %d voxels takes %.1f s, %.1f s of one processor.\n", ct.size[0],
              ct.size[1], ct.size[2], bend.wallMs / 1e3, bend.cpuMs / 1e3);
  return 0;
}

}  // namespace
}  // namespace falciform::test

int main(int count, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::test::run(count > 1 ? words[1] : "ircad5_right");
}
