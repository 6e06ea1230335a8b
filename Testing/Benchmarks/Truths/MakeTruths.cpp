// ./run bench make-truths --out DIR [--livers 2,3,4,6,7,9] [--cases-per-liver 3] [--seed S] [--edge MM]:
// real livers deformed with known truth by CalculiX, in the layout of the real cases' folder `update`, so
// that methods are tuned on other livers and packings than those they are judged by (Docs/HeldOutTruths.md).
// ./run bench make-truths --table DIR: the cases of such a folder as a Markdown table.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Benchmarks/Truths/SegmentedLivers.h"
#include "Testing/Benchmarks/Truths/TruthFiles.h"
#include "Testing/Benchmarks/Truths/TruthTable.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::bench {
namespace {

constexpr double kSurfaceEdgeMm = 1.45;  // about 58,000 points, as the folder `update` has
constexpr int kTargets = 60;
constexpr int kAttempts = 4;  // seeds, where a plan cannot be carried out

struct Wish {
  std::filesystem::path out;
  std::filesystem::path table;  ///< only prints what is there
  std::vector<int> livers{2, 3, 4, 6, 7, 9};
  int casesPerLiver = 3;
  std::uint64_t seed = 1;
  double edgeMm = 14;
  bool paintOnly = false;  ///< writes the painted surfaces alone, to look at them
};

Wish parse(int count, char** words) {
  Wish wish;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--paint-only") {
      wish.paintOnly = true;
      continue;
    }
    if (i + 1 >= count) throw InputError("'" + word + "' needs a value");
    const std::string value = words[++i];
    if (word == "--out") {
      wish.out = value;
    } else if (word == "--table") {
      wish.table = value;
    } else if (word == "--livers") {
      wish.livers.clear();
      std::istringstream list(value);
      for (std::string number; std::getline(list, number, ',');) wish.livers.push_back(std::stoi(number));
    } else if (word == "--cases-per-liver") {
      wish.casesPerLiver = std::stoi(value);
    } else if (word == "--seed") {
      wish.seed = std::stoull(value);
    } else if (word == "--edge") {
      wish.edgeMm = std::stod(value);
    } else {
      throw InputError("there is no option '" + word + "'; see Docs/HeldOutTruths.md");
    }
  }
  if (wish.out.empty() && wish.table.empty())
    throw InputError("--out DIR is missing: the folder that receives the cases");
  return wish;
}

void makeCase(const Surface& preop, int liver, PackedLobe lobe, std::uint64_t seed, double edgeMm,
              const std::filesystem::path& calculix, const std::filesystem::path& folder) {
  const TruthPlan plan = drawTruth(seed, lobe);
  const TruthBody body = truthBody(preop, plan, edgeMm);
  const test::TemporaryFolder work;
  TruthState state;
  const double seconds = measured([&] { state = solveTruth(body, calculix, work.path()); }).wallMs / 1e3;
  const TetrahedralMesh& mesh = body.problem.body.mesh;
  Surface moved = preop;
  moved.points += Points(MeshPlaces(mesh, preop.points).interpolate(state.displacements));
  const TruthTargets targets = drawTargets(mesh, state.displacements, kTargets, seed);
  const TruthScan scan = scanTruth(moved, plan);
  writeTruth(folder, liver, edgeMm, plan, preop, moved, scan, targets, body, state);
  std::printf(
      "%s: %td nodes, load share %.2f, min det J %.2f, optimal rigid %.2f mm, coverage %.2f, %.0f s\n",
      folder.filename().c_str(), mesh.nodes(), state.share, state.minDetJ, optimalRigidMm(targets),
      scan.coverage, seconds);
  std::fflush(stdout);
}

int run(const Wish& wish) {
  if (!wish.table.empty()) {
    std::fputs(truthTable(wish.table).c_str(), stdout);
    return 0;
  }
  const auto calculix = verification::findCalculix();
  if (!calculix && !wish.paintOnly) throw InputError("CalculiX is not installed (Debian: calculix-ccx)");
  int missing = 0;
  // One case of each liver first, so that the first few already tell something.
  for (int k = 0; k < wish.casesPerLiver; ++k)
    for (std::size_t n = 0; n < wish.livers.size(); ++n) {
      const int liver = wish.livers[n];
      const auto lobe = static_cast<PackedLobe>((static_cast<std::size_t>(k) + n) % 3);
      std::string name = "ircad" + std::to_string(liver) + "_" +
                         std::string(kPackedLobeNames[static_cast<std::size_t>(lobe)]);
      if (k >= 3) name += "_" + std::to_string(k / 3 + 1);
      const std::filesystem::path folder = wish.out / name;
      if (std::filesystem::exists(folder)) {
        std::printf("%s is there already\n", name.c_str());
        continue;
      }
      std::filesystem::create_directories(wish.out);
      const Surface preop = importPainted(readSegments(liver), kSurfaceEdgeMm);
      if (wish.paintOnly) {
        std::filesystem::create_directories(folder);
        writeSurface(folder / "preop.vtp", preop, Overwrite::Replace);
        continue;
      }
      bool made = false;
      for (int attempt = 0; attempt < kAttempts && !made; ++attempt) {
        const std::uint64_t seed =
            ((wish.seed * 100 + static_cast<std::uint64_t>(liver)) * 100 + static_cast<std::uint64_t>(k)) *
                10 +
            static_cast<std::uint64_t>(attempt);
        try {
          makeCase(preop, liver, lobe, seed, wish.edgeMm, *calculix, folder);
          made = true;
        } catch (const std::exception& e) {
          std::printf("%s, seed %llu: %s\n", name.c_str(), static_cast<unsigned long long>(seed), e.what());
          std::fflush(stdout);
        }
      }
      missing += made ? 0 : 1;
    }
  return missing == 0 ? 0 : 1;
}

}  // namespace
}  // namespace falciform::bench

int main(int count, char** words) {
  setenv("OMP_NUM_THREADS", "1", 0);  // for ccx: what rounds differently with its threads is no truth
  try {
    return falciform::bench::run(falciform::bench::parse(count, words));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
