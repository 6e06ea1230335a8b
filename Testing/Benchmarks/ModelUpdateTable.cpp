// ./run bench model-update [--edge MM] [--cases DIR] [CASE...]: real livers with known truth, start to end
// from the stored scan with nothing told of the supports, as a Markdown table. A word that is a folder of
// cases stands for --cases: those of ./run bench make-truths, say.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/ModelUpdate.h"
#include "Logic/Biomechanics/BlasKernel.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Registration/SurfaceRegistration.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Regression/UpdateCase.h"

namespace falciform::test {
namespace {

struct Row {
  double optimal = 0, rigid = 0, updated = 0, largest = 0, expected = 0;
  Index targets = 0, within = 0;  ///< all, and those no farther off than nine tenths should be
  double prepare = 0, register_ = 0, update = 0;  // ms
  UpdateResult result;
};

/// The 90 % quantile of the length of a three-dimensional isotropic Gaussian, by its root mean square: the
/// root of a third of chi squared's, 6.2514 for three degrees of freedom.

Row runCase(const UpdateCase& liver, double edgeMm) {
  Row row;
  row.optimal = liver.optimalRigidMm;
  MeshSettings mesh;
  mesh.edgeLengthMm = edgeMm;
  std::optional<UpdateModel> model;
  row.prepare =
      bench::measured([&] {
        model.emplace(liver.preop, solveSurfaceLoads(meshLiver(liver.preop, {}, mesh).mesh, {Material{}}));
      }).wallMs;
  const PreparedPreop prepared(liver.preop);
  RegistrationResult rigid;
  row.register_ =
      bench::measured([&] { rigid = registerSurfaces(prepared, liver.scan, RegistrationSettings{}); }).wallMs;
  row.rigid =
      (transformed(liver.targetsPreop, rigid.scanFromPreop) - liver.targetsScanner).rowwise().norm().mean();
  row.update =
      bench::measured([&] { row.result = updateModel(*model, liver.scan, rigid.scanFromPreop); }).wallMs;
  const VectorXd errors =
      (scanFromPreop(*model, row.result, liver.targetsPreop) - liver.targetsScanner).rowwise().norm();
  const VectorXd expected = expectedErrorMm(*model, row.result, liver.targetsPreop);
  row.updated = errors.mean();
  row.largest = errors.maxCoeff();
  row.expected = expected.mean();
  row.targets = errors.size();
  row.within = (errors.array() <= kNineInTen * expected.array()).count();
  return row;
}

/// Predicted against true over all cases.
void printSummary(const std::vector<Row>& rows) {
  double updated = 0, gap = 0, worstGap = 0;
  Index targets = 0, within = 0, ratioed = 0, held = 0;
  for (const Row& r : rows) {
    updated += r.updated;
    gap += std::abs(r.expected - r.updated);
    worstGap = std::max(worstGap, std::abs(r.expected - r.updated));
    targets += r.targets;
    within += r.within;
    if (r.optimal <= 3) continue;
    ++ratioed;
    held += r.updated <= 0.6 * r.optimal ? 1 : 0;
  }
  const auto cases = static_cast<double>(rows.size());
  std::printf("\nMean target error after the update: %.2f mm over %zu cases.\n", updated / cases,
              rows.size());
  std::printf("At most 0.6 of the optimal rigid error on %td of %td cases where that exceeds 3 mm.\n", held,
              ratioed);
  std::printf("Expected against true mean error: %.2f mm apart on average, %.2f at most.\n", gap / cases,
              worstGap);
  std::printf("Targets within their 90 %% interval: %.1f %% of %td.\n",
              100.0 * static_cast<double>(within) / static_cast<double>(targets), targets);
}

int run(int count, char** words) {
  double edgeMm = 13;
  std::filesystem::path cases = updateCasesFolder();
  std::vector<std::string> names;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--edge" && i + 1 < count)
      edgeMm = std::stod(words[++i]);
    else if (word == "--cases" && i + 1 < count)
      cases = words[++i];
    else if (std::filesystem::is_directory(word))
      cases = word;
    else
      names.push_back(word);
  }
  if (names.empty()) names = updateCaseNames(cases);
  if (names.empty()) {
    std::fprintf(stderr, "%s holds no case (a folder with truth.json)\n", cases.c_str());
    return 2;
  }
  std::puts(
      "| case | optimal rigid | registered | updated | largest | of optimal | expected | within 90 % | rms | "
      "noise | bending | loads known | min det J | steps | prepare s | register s | update s |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  std::vector<Row> rows;
  for (const std::string& name : names) {
    const Row r = runCase(readUpdateCase(name, cases), edgeMm);
    std::printf(
        "| %s | %.2f | %.2f | %.2f | %.1f | %.2f | %.2f | %.0f %% | %.2f | %.2f | %.1f | %.0f | %.2f | "
        "%d%s | %.1f | %.2f | %.2f |\n",
        name.c_str(), r.optimal, r.rigid, r.updated, r.largest, r.updated / r.optimal, r.expected,
        100.0 * static_cast<double>(r.within) / static_cast<double>(r.targets), r.result.rmsMm,
        r.result.noiseMm, r.result.bendMm, r.result.effectiveParameters, r.result.minDetJ,
        r.result.iterations, r.result.converged ? "" : "!", r.prepare / 1e3, r.register_ / 1e3,
        r.update / 1e3);
    std::fflush(stdout);
    rows.push_back(r);
  }
  printSummary(rows);
  return 0;
}

}  // namespace
}  // namespace falciform::test

int main(int count, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::test::run(count, words);
}
