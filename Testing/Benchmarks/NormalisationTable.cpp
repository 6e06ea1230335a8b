// Prints the table of Docs/Normalisation.md: thesis Table IV.3 on ten real livers, and elastix and
// plastimatch on the same pairs where they are installed.   ./run bench normalisation [--peers N] [--pairs N]

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/Normalisation/LiverRegistration.h"
#include "Logic/Deformation/Normalisation/SurfaceErrors.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/SurfaceDistances.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/Benchmarks/NormalisationPeers.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {
namespace {

constexpr const char* kTarget = "3Dircadb-8";
constexpr const char* kSources[] = {"3Dircadb-2", "3Dircadb-3", "3Dircadb-4",  "3Dircadb-5", "3Dircadb-6",
                                    "3Dircadb-7", "3Dircadb-9", "3Dircadb-10", "3Dircadb-17"};

Surface liver(const std::string& name) {
  const auto file = test::realData() / "cohort/couinaud" / (name + ".nii.gz");
  return importSurface(readLabelMap(file).value, {}).surface;
}

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of the vertices that face forward: what a scanner above the patient may see.
VectorXd facingForward(const Surface& surface, const VectorXd& values) {
  const Points normals = vertexNormals(surface);
  std::vector<double> kept;
  for (Index i = 0; i < values.size(); ++i)
    if (normals(i, 1) < -0.5) kept.push_back(values[i]);
  return Eigen::Map<const VectorXd>(kept.data(), static_cast<Index>(kept.size()));
}

void printCells(const VectorXd& values) {
  const DistanceStatistics s = distanceStatistics(values);
  std::printf(" %.2f ± %.2f | %.2f |", s.mean, s.sd, s.max);
}

/// Both directions in the source's frame, where a map that has no inverse can be judged too.
void printRow(const std::string& source, const char* who, double seconds, const Surface& target,
              const Surface& liver, const Points& toSource, const std::string& determinant) {
  Surface moved = target;
  moved.points = toSource;
  moved.normals.resize(0, 3);
  const VectorXd fromTarget = distancesTo(liver, toSource);
  std::printf("| %s | %s |", source.c_str(), who);
  printCells(distancesTo(moved, liver.points));
  printCells(fromTarget);
  printCells(facingForward(target, fromTarget));
  std::printf(" %s | %.1f |\n", determinant.c_str(), seconds);
  std::fflush(stdout);
}

int number(int count, char** words, const char* name, int fallback) {
  for (int i = 1; i + 1 < count; ++i)
    if (std::strcmp(words[i], name) == 0) return std::atoi(words[i + 1]);
  return fallback;
}

int run(int count, char** words) {
  if (!std::filesystem::exists(test::realData() / "cohort/couinaud")) {
    std::puts("needs the ten livers of the cohort; set FALCIFORM_DATA to the folder of real cases");
    return 2;
  }
  const int peers = number(count, words, "--peers", 9), pairs = number(count, words, "--pairs", 9);
  const Surface target = liver(kTarget);
  const auto folder = std::filesystem::temp_directory_path() / "falciform-normalisation";
  std::printf(
      "target %s, distances in mm\n\n| source | by | source to target | max | target to source | max | "
      "of it facing forward | max | det J | s |\n|---|---|---|---|---|---|---|---|---|---|\n",
      kTarget);
  for (int p = 0; p < std::min<int>(pairs, std::size(kSources)); ++p) {
    const std::string name = kSources[p];
    const Surface source = liver(name);
    LiverMap map;
    const double seconds = secondsOf([&] { map = registerLivers(target, source); });
    const VectorXd determinants = map.determinants(target.points);
    char range[64];
    std::snprintf(range, sizeof range, "%.2f to %.1f", determinants.minCoeff(), determinants.maxCoeff());
    printRow(name, "falciform", seconds, target, source, map.toSource(target.points), range);
    if (p >= peers) continue;
    const GridField targetField = signedDistanceField(target, 1.5, 8),
                    sourceField = signedDistanceField(source, 1.5, 8);
    if (const auto peer = elastix(targetField, sourceField, target.points, folder))
      printRow(name, "elastix", peer->wallS, target, source, peer->toSource, "-");
    if (const auto peer = plastimatch(targetField, sourceField, target.points, folder))
      printRow(name, "plastimatch", peer->wallS, target, source, peer->toSource, "-");
  }
  std::filesystem::remove_all(folder);
  return 0;
}

}  // namespace
}  // namespace falciform::bench

int main(int count, char** words) { return falciform::bench::run(count, words); }
