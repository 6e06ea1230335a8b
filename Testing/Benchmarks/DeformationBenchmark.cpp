// Prints the tables of Docs/Performance.md on deformation metrics: signed distance of every vertex of a mesh
// to another mesh, and mean curvature at every vertex, beside what a user has today.   ./run bench
// deformation

#include <cmath>
#include <cstdio>
#include <functional>

#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/TriangleTree.h"
#include "Testing/Benchmarks/MetricPeers.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform::bench {
namespace {

constexpr int kRuns = 5;

/// Makes one value a vertex.
struct Contestant {
  const char* who;
  std::function<VectorXd()> run;
  bool threads = true;
};

void compare(const std::string& what, const std::vector<Contestant>& contestants, const VectorXd& exact) {
  double firstCpu = 0;
  for (const Contestant& contestant : contestants)
    for (const int count : {1, 2}) {
      if (count > 1 && !contestant.threads) continue;
      setThreads(count);
      std::vector<double> wall, cpu;
      VectorXd values;
      for (int run = 0; run < kRuns; ++run) {
        const Spent spent = measured([&] { values = contestant.run(); });
        wall.push_back(spent.wallMs);
        cpu.push_back(spent.cpuMs);
      }
      const double processor = quantile(cpu, 0.5);
      if (firstCpu == 0) firstCpu = processor;
      // Of a peer that gives no sign, the magnitudes are compared.
      const bool noSign = values.minCoeff() >= 0 && exact.minCoeff() < 0;
      const VectorXd error = (values - (noSign ? VectorXd(exact.cwiseAbs()) : exact)).cwiseAbs();
      std::printf("| %s | %s | %d | %.1f | %.1f | %.1f | %.2f | %.2g | %.2g |\n", what.c_str(),
                  contestant.who, count, quantile(wall, 0), quantile(wall, 0.5), processor,
                  processor / firstCpu, quantile({error.begin(), error.end()}, 0.5), error.maxCoeff());
      std::fflush(stdout);
    }
  setThreads(0);
}

/// Signed distances of all rows of `queries`.
VectorXd ours(const TriangleTree& tree, const Points& queries) {
  VectorXd values(queries.rows());
  forEachChunk(static_cast<std::size_t>(queries.rows()), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ClosestPlace place = tree.closest(queries.row(static_cast<Index>(i)).transpose());
      values[static_cast<Index>(i)] = place.side * place.distance;
    }
  });
  return values;
}

void compareDistances() {
  // A bumpy body of 60,000 vertices against one of 100,000 triangles, swollen and bent by some millimetres as
  // after a registration; and the same 30 mm aside.
  const Surface body = test::torus(70, 40, 330, 182), other = test::torus(71, 41, 250, 200);
  const TriangleTree tree(other);
  const MeshDistancePeers peers(other);
  for (const double aside : {3.0, 30.0}) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translate(Vector3d(aside, aside / 3, 0));
    pose.rotate(Eigen::AngleAxisd(0.05, Vector3d(1, 2, 3).normalized()));
    const Points queries = transformed(body.points, pose);
    const std::string what = "signed distance, " + std::to_string(queries.rows()) + " vertices, " +
                             std::to_string(other.triangles.rows()) + " triangles, " +
                             std::to_string(static_cast<int>(aside)) + " mm aside";
    std::vector<Contestant> contestants{{"ours", [&] { return ours(tree, queries); }}};
    for (const MetricPeer& peer : peers.all())
      contestants.push_back({peer.who, [&, search = peer.search] { return search(queries); }, peer.threads});
    compare(what, contestants, ours(tree, queries));
  }
}

void compareCurvatures() {
  const double ring = 60, tube = 25;
  const Surface s = test::torus(ring, tube, 460, 230);
  VectorXd exact(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    const double aside = std::hypot(s.points(i, 0), s.points(i, 1));
    exact[i] = 0.5 * (1 / tube + (aside - ring) / (tube * aside));
  }
  std::vector<Contestant> contestants{
      {"ours", [&] { return meanCurvature(s); }},
      {"ours, the thesis's fit", [&] { return meanCurvature(s, thesisCurvature()); }}};
  for (const MetricPeer& peer : curvaturePeers(s))
    contestants.push_back({peer.who, [&, run = peer.search] { return run(s.points); }, peer.threads});
  compare("mean curvature, " + std::to_string(s.size()) + " vertices of a torus", contestants, exact);
}

}  // namespace
}  // namespace falciform::bench

int main() {
  std::puts(
      "| what | who | threads | wall, least, ms | wall, median, ms | processor, median, ms | times ours | "
      "error, median | error, largest |\n|---|---|---|---|---|---|---|---|---|");
  falciform::bench::compareDistances();
  falciform::bench::compareCurvatures();
}
