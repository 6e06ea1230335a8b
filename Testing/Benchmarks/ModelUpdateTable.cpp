// ./run bench model-update [--edge MM] [CASE...]: the real livers with known truth, start to end from the
// stored scan with nothing told of the supports, as a Markdown table.
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

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
  double prepare = 0, register_ = 0, update = 0;  // ms
  UpdateResult result;
};

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
  return row;
}

int run(int count, char** words) {
  double edgeMm = 13;
  std::vector<std::string> names;
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(words[i], "--edge") == 0 && i + 1 < count)
      edgeMm = std::stod(words[++i]);
    else
      names.emplace_back(words[i]);
  }
  if (names.empty()) names = updateCaseNames();
  std::puts(
      "| case | optimal rigid | registered | updated | largest | of optimal | expected | rms | noise | "
      "bending | loads known | "
      "min det J | steps | prepare s | register s | update s |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  double sum = 0;
  for (const std::string& name : names) {
    const Row r = runCase(readUpdateCase(name), edgeMm);
    std::printf(
        "| %s | %.2f | %.2f | %.2f | %.1f | %.2f | %.2f | %.2f | %.2f | %.1f | %.0f | %.2f | %d%s | %.1f | "
        "%.2f | %.2f |\n",
        name.c_str(), r.optimal, r.rigid, r.updated, r.largest, r.updated / r.optimal, r.expected,
        r.result.rmsMm, r.result.noiseMm, r.result.bendMm, r.result.effectiveParameters, r.result.minDetJ,
        r.result.iterations, r.result.converged ? "" : "!", r.prepare / 1e3, r.register_ / 1e3,
        r.update / 1e3);
    std::fflush(stdout);
    sum += r.updated;
  }
  std::printf("\nMean target error after the update: %.2f mm.\n", sum / static_cast<double>(names.size()));
  return 0;
}

}  // namespace
}  // namespace falciform::test

int main(int count, char** words) {
  falciform::restartWithBestBlasKernel(words);
  return falciform::test::run(count, words);
}
