// ./run bench update-methods [--cases FOLDER] [CASE...]: every way to a model update beside the best rigid
// motion and the registration, on livers with known truth, as one Markdown table.
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/Atlas/AtlasBuilding.h"
#include "Logic/Atlas/UpdateMethods.h"
#include "Logic/Atlas/UpdatedPlaces.h"
#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Registration/PointRegistration.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Regression/UpdateCase.h"

namespace falciform::test {
namespace {

struct Method {
  UpdateMethod method;
  const char* name;
};
constexpr Method kMethods[]{{UpdateMethod::Icat, "icat (thesis preset)"},
                            {UpdateMethod::IcatStar, "icat-star (thesis preset)"},
                            {UpdateMethod::Incremental, "incremental"},
                            {UpdateMethod::Constrained, "constrained"},
                            {UpdateMethod::Pca, "pca"},
                            {UpdateMethod::Libr, "libr"},
                            {UpdateMethod::Loads, "model (ours)"}};

struct Cell {
  double mean = 0, largest = 0, seconds = 0, minDetJ = 1;
  bool settled = true;
};

/// One row of the table: a method on every case.
struct Row {
  std::string name;
  std::vector<Cell> cells;
};

Cell cellOf(const Points& said, const Points& truth) {
  const VectorXd errors = (said - truth).rowwise().norm();
  return {.mean = errors.mean(), .largest = errors.maxCoeff()};
}

/// What is done before the scan is there, in seconds.
struct Preparation {
  double mesh = 0, atlas = 0, loads = 0;
};

Preparation runCase(const UpdateCase& liver, std::vector<Row>& rows) {
  Preparation before;
  std::size_t row = 0;
  const auto put = [&](const Cell& cell) { rows[row++].cells.push_back(cell); };
  put(cellOf(transformed(liver.targetsPreop, fitRigid(liver.targetsPreop, liver.targetsScanner)),
             liver.targetsScanner));
  const PreparedPreop prepared(liver.preop);
  RegistrationResult rigid;
  const double registerS =
      bench::measured([&] { rigid = registerSurfaces(prepared, liver.scan, {}); }).wallMs / 1e3;
  Cell registered = cellOf(transformed(liver.targetsPreop, rigid.scanFromPreop), liver.targetsScanner);
  registered.seconds = registerS;
  put(registered);

  std::shared_ptr<const TetrahedralMesh> mesh;
  before.mesh =
      bench::measured([&] {
        mesh = std::make_shared<const TetrahedralMesh>(meshLiver(liver.preop, {}, {.edgeLengthMm = 13}).mesh);
      }).wallMs /
      1e3;
  std::shared_ptr<const Atlas> atlas;
  before.atlas = bench::measured([&] {
                   const SupportSites sites = findSupportSites(liver.preop, *mesh, boundaryFaces(*mesh));
                   atlas =
                       std::make_shared<const Atlas>(buildAtlas(*mesh, sites, atlasPreset("thesis-packing")));
                 }).wallMs /
                 1e3;
  std::shared_ptr<const LoadResponses> loads;
  before.loads = bench::measured([&] {
                   loads = std::make_shared<const LoadResponses>(
                       solveSurfaceLoads(*mesh, materialsOf(atlasPreset("surface-loads"))));
                 }).wallMs /
                 1e3;
  for (const Method& each : kMethods) {
    UpdateBasis basis = mesh;
    if (needsDeformations(each.method)) basis = atlas;
    if (each.method == UpdateMethod::Loads) basis = loads;
    const PreparedUpdate ready(each.method, liver.preop, basis);
    const UpdateResult update = updateByMethod(ready, liver.scan, rigid.scanFromPreop);
    Cell cell = cellOf(scanFromPreop(ready.mesh(), update, liver.targetsPreop), liver.targetsScanner);
    cell.seconds = registerS + update.seconds;
    cell.minDetJ = update.minDetJ;
    cell.settled = update.converged;
    std::fprintf(stderr, "  %s: %.2f (%.1f) mm, %.2f s, %d iterations\n", each.name, cell.mean, cell.largest,
                 cell.seconds, update.iterations);
    put(cell);
  }
  return before;
}

void print(const Row& row) {
  std::printf("| %s |", row.name.c_str());
  double mean = 0, seconds = 0, minDetJ = 1;
  int unsettled = 0;
  const auto count = static_cast<double>(row.cells.size());
  for (const Cell& cell : row.cells) {
    std::printf(" %.2f (%.1f) |", cell.mean, cell.largest);
    mean += cell.mean / count;
    seconds += cell.seconds / count;
    minDetJ = std::min(minDetJ, cell.minDetJ);
    unsettled += cell.settled ? 0 : 1;
  }
  std::printf(" %.2f | %.2f | %.2f | %d |\n", mean, seconds, minDetJ, unsettled);
}

int run(int count, char** words) {
  std::filesystem::path cases = updateCasesFolder();
  std::vector<std::string> names;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--cases" && i + 1 < count)
      cases = words[++i];
    else
      names.push_back(word);
  }
  if (!std::filesystem::is_directory(cases)) {
    std::fprintf(stderr, "%s is no folder of cases\n", cases.c_str());
    return 2;
  }
  if (names.empty()) names = updateCaseNames(cases);
  if (names.empty()) {
    std::fprintf(stderr, "%s holds no case (a folder with truth.json)\n", cases.c_str());
    return 2;
  }
  std::vector<Row> rows{{"best rigid motion", {}}, {"registration", {}}};
  for (const Method& each : kMethods) rows.push_back({each.name, {}});
  Preparation mean;
  const auto all = static_cast<double>(names.size());
  for (const std::string& name : names) {
    std::fprintf(stderr, "%s\n", name.c_str());
    const Preparation one = runCase(readUpdateCase(name, cases), rows);
    mean.mesh += one.mesh / all;
    mean.atlas += one.atlas / all;
    mean.loads += one.loads / all;
  }
  std::puts("Target error, mean (largest), mm.\n");
  std::printf("| method |");
  for (const std::string& name : names) std::printf(" %s |", name.c_str());
  std::printf(" mean | s | least det J | unsettled |\n|---|");
  for (std::size_t i = 0; i < names.size() + 4; ++i) std::printf("---|");
  std::puts("");
  for (const Row& row : rows) print(row);
  std::printf("\nBefore the scan: mesh %.1f s, thesis-packing %.1f s, surface loads %.1f s, on average.\n",
              mean.mesh, mean.atlas, mean.loads);
  return 0;
}

}  // namespace
}  // namespace falciform::test

int main(int count, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::test::run(count, words);
}
