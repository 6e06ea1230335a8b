// The thesis's atlas of 180 packings, as a user waits for it, beside CalculiX on the same members:
//   bench-atlas [SURFACE.vtp] [EDGE_MM] [MEMBERS_FOR_CALCULIX]
// The built-in liver without a surface. Whole processes from start to end, files read and written. CalculiX
// solves a few members (2 by default), and its time is scaled to the others: each is one process of its own.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Benchmarks/CalculixDeck.h"
#include "Testing/Benchmarks/ChildProcess.h"
#include "Testing/Support/TemporaryFolder.h"

using namespace falciform;

namespace {

void line(const char* who, std::size_t members, double wallS, double cpuS, double peakMb) {
  std::printf("| %s | %zu | %.1f | %.1f | %.0f |\n", who, members, wallS, cpuS, peakMb);
  std::fflush(stdout);
}

bench::ChildRun checked(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  const bench::ChildRun run = bench::runChild(words, folder);
  if (run.exitCode == 0) return run;
  std::fprintf(stderr, "%s failed:\n%s", words.front().c_str(), readTextFile(folder / "log").c_str());
  std::exit(1);
}

std::vector<NodeConstraint> constraintsOf(const Atlas& atlas, const BoundaryFaces& faces,
                                          const AtlasMember& member) {
  const AtlasSetup& setup = atlas.setups[static_cast<std::size_t>(member.setup)];
  std::vector<Support> supports = setup.supports;
  supports[static_cast<std::size_t>(setup.pushed)].pushMm = member.pushMm;
  return nodeConstraints(faces, nodeNormals(faces, atlas.mesh.nodes()), supports);
}

}  // namespace

int main(int argc, char** argv) {
  const test::TemporaryFolder folder;
  const std::filesystem::path surface = argc > 1 ? std::filesystem::absolute(argv[1]) : folder / "liver.vtp";
  const std::string edge = argc > 2 ? argv[2] : "12";
  const int wanted = argc > 3 ? std::atoi(argv[3]) : 2;
  if (argc <= 1)
    writeSurface(surface, makeSyntheticLiver(SyntheticLiverSettings{}).surface, Overwrite::Refuse);
  const std::string program = FALCIFORM_EXECUTABLE, mesh = (folder / "mesh.vtu").string(),
                    atlasFile = (folder / "atlas.h5").string();

  const bench::ChildRun meshing =
      checked({program, "mesh", "--preop", surface, "--edge-length", edge, "--out", mesh}, folder.path());
  const bench::ChildRun build = checked(
      {program, "atlas", "build", "thesis-packing", "--preop", surface, "--mesh", mesh, "--out", atlasFile},
      folder.path());
  const Atlas atlas = readAtlas(atlasFile).atlas;
  const nlohmann::json figures = readJsonFile(atlasFile + ".json").at("figures");
  double load[1] = {0};
  (void)getloadavg(load, 1);
  std::printf("%ld quadratic elements, %ld degrees of freedom, Poisson's ratio %g; %u threads, load %.1f\n",
              static_cast<long>(atlas.mesh.size()), static_cast<long>(3 * atlas.mesh.nodes()),
              atlas.design.liver.poissonsRatio, std::thread::hardware_concurrency(), load[0]);
  std::printf("%zu members from %d solves; rank %ld holds %.7f\n\n", atlas.members.size(), atlas.solves,
              static_cast<long>(atlas.rank()), atlas.energy);
  std::printf("| whole process | members | wall s | processor s | peak MB |\n|---|---|---|---|---|\n");
  line("falciform mesh", 0, meshing.wallS, meshing.cpuS, meshing.peakMb);
  line("falciform atlas build, from the mesh to the file", atlas.members.size(), build.wallS, build.cpuS,
       build.peakMb);
  std::printf("of which solving %.1f s, compression and checks %.1f s\n", figures.at("solve_s").get<double>(),
              figures.at("compress_s").get<double>());

  if (std::system("command -v ccx > /dev/null 2>&1") != 0) {
    std::printf("CalculiX is not here; install calculix-ccx\n");
    return 0;
  }
  setenv("OMP_NUM_THREADS", std::to_string(std::thread::hardware_concurrency()).c_str(), 0);
  const BoundaryFaces faces = boundaryFaces(atlas.mesh);
  double wallS = 0, cpuS = 0, peakMb = 0, apart = 0;
  for (int k = 0; k < wanted; ++k) {
    const auto m = static_cast<std::size_t>(k) * atlas.members.size() / static_cast<std::size_t>(wanted);
    const AtlasMember& member = atlas.members[m];
    const std::string name = "member" + std::to_string(m);
    bench::writeDeck(folder / (name + ".inp"), atlas.mesh, materialsOf(atlas.design).front(),
                     constraintsOf(atlas, faces, member));
    const bench::ChildRun run = checked({"ccx", name}, folder.path());
    wallS += run.wallS;
    cpuS += run.cpuS;
    peakMb = std::max(peakMb, run.peakMb);
    const Points theirs = bench::readDisplacements(folder / (name + ".dat"), atlas.mesh.nodes());
    const Points ours = memberDisplacements(atlas, static_cast<Index>(m));
    apart = std::max(apart, (ours - theirs).rowwise().norm().maxCoeff() / theirs.rowwise().norm().maxCoeff());
  }
  line("CalculiX, as measured", static_cast<std::size_t>(wanted), wallS, cpuS, peakMb);
  const double each = static_cast<double>(atlas.members.size()) / wanted;
  line("CalculiX, scaled to all members", atlas.members.size(), each * wallS, each * cpuS, peakMb);
  const double independent = static_cast<double>(atlas.solves) / wanted;
  line("CalculiX, scaled to the independent solves alone", atlas.members.size(), independent * wallS,
       independent * cpuS, peakMb);
  std::printf(
      "\nall members: %.0f times CalculiX's wall time; largest difference %.1e of the largest displacement\n",
      each * wallS / build.wallS, apart);
  return 0;
}
