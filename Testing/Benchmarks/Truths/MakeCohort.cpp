// ./run bench make-cohort --out DIR [--seed S] [--edge MM] [--surface-edge MM]: ten real livers deformed by
// our own elastic model into the procedure groups of thesis ch. IV, scanned, with the truth beside each, and
// the cohort.json that `falciform cohort` takes (Docs/CohortTables.md).
#include <cstdio>

#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Core/Errors.h"
#include "Logic/Core/Results.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Benchmarks/Truths/CohortFiles.h"
#include "Testing/Benchmarks/Truths/SegmentedLivers.h"
#include "Testing/Benchmarks/Truths/TruthPatches.h"

namespace falciform::bench {
namespace {

constexpr int kTargets = 60;
constexpr int kTargetLiver = 8;  // the thesis takes its patient 8

struct Wish {
  std::filesystem::path out;
  std::uint64_t seed = 1;
  double edgeMm = 14, surfaceEdgeMm = 2.5;
};

Wish parse(int count, char** words) {
  Wish wish;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (i + 1 >= count) throw InputError("'" + word + "' needs a value");
    const std::string value = words[++i];
    if (word == "--out") {
      wish.out = value;
    } else if (word == "--seed") {
      wish.seed = std::stoull(value);
    } else if (word == "--edge") {
      wish.edgeMm = std::stod(value);
    } else if (word == "--surface-edge") {
      wish.surfaceEdgeMm = std::stod(value);
    } else {
      throw InputError("there is no option '" + word + "'; see Docs/CohortTables.md");
    }
  }
  if (wish.out.empty()) throw InputError("--out DIR is missing: the folder that receives the cohort");
  return wish;
}

CohortCaseMade makeCase(const CohortMember& member, const Surface& preop, std::uint64_t seed, double edgeMm) {
  CohortCaseMade made;
  made.member = member;
  made.plan = drawCohortCase(member.procedure, seed);
  made.preop = preop;
  const CohortBody body = cohortBody(preop, made.plan, edgeMm);
  const TetrahedralMesh& mesh = body.body.mesh;
  const CohortState state = solveCohort(body);
  const Points& displacements = state.displacements;
  made.loadShare = state.share;
  made.minDetJ = state.minDetJ;
  made.heldShare = body.heldShare;
  made.meshNodes = mesh.nodes();
  made.moved = preop;
  made.moved.points += Points(MeshPlaces(mesh, preop.points).interpolate(displacements));
  made.targets = drawTargets(mesh, displacements, kTargets, seed);
  made.scan = scanTruth(made.moved, made.plan.scanner);
  return made;
}

void print(const CohortCaseMade& made, double seconds) {
  std::printf("| %s | %s | %s | %td | %.2f | %.1f | %.1f | %.1f | %.2f | %.2f | %td | %.0f |\n",
              nameOf(made.member).c_str(), groupOf(made.member.procedure).c_str(),
              std::string(kProcedureNames[static_cast<std::size_t>(made.member.procedure)]).c_str(),
              made.meshNodes, made.loadShare,
              (made.targets.moved - made.targets.preop).rowwise().norm().mean(),
              (made.moved.points - made.preop.points).rowwise().norm().maxCoeff(),
              optimalRigidMm(made.targets), made.minDetJ, made.scan.coverage, made.scan.scan.size(), seconds);
  std::fflush(stdout);
}

int run(const Wish& wish) {
  std::filesystem::create_directories(wish.out);
  std::puts(
      "| case | group | procedure | mesh nodes | load | targets moved mm | farthest surface mm | optimal "
      "rigid mm | "
      "min "
      "det J | coverage | scan points | s |\n|---|---|---|---|---|---|---|---|---|---|---|---|");
  for (const CohortMember& member : cohortMembers()) {
    const std::filesystem::path folder = wish.out / nameOf(member);
    if (std::filesystem::exists(folder)) {
      std::printf("%s is there already\n", nameOf(member).c_str());
      continue;
    }
    const LabelMap map = readSegments(member.liver);
    Surface preop = importPainted(map, wish.surfaceEdgeMm);
    const std::vector<int> segments = segmentsAtSurface(preop, map);
    preop.arrays[kCouinaudSegment] =
        Eigen::Map<const Eigen::VectorXi>(segments.data(), preop.size()).cast<double>();
    const std::uint64_t seed = wish.seed * 100 + static_cast<std::uint64_t>(member.liver);
    CohortCaseMade made;
    const double seconds = measured([&] { made = makeCase(member, preop, seed, wish.edgeMm); }).wallMs / 1e3;
    writeCohortCase(folder, made);
    print(made, seconds);
  }
  writeCohortFile(wish.out, kTargetLiver);
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int count, char** words) {
  try {
    return falciform::bench::run(falciform::bench::parse(count, words));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 2;
  }
}
