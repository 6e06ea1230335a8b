#include "Testing/Benchmarks/MarkedLivers.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"

namespace falciform::bench {

namespace {

/// Their pictures show it: scans of one liver at several times.
std::string patientOf(const std::string& name) {
  static const std::map<std::string, std::string> again{
      {"LiTS-0", "LiTS-a"}, {"LiTS-1", "LiTS-a"}, {"LiTS-10", "LiTS-b"}, {"LiTS-6", "LiTS-b"},
      {"LiTS-7", "LiTS-b"}, {"LiTS-8", "LiTS-b"}, {"LiTS-9", "LiTS-b"}};
  const auto found = again.find(name);
  return found == again.end() ? name : found->second;
}

/// The `v` and `f` lines alone, in their order: the edges' ids follow it. RAS-like axes become LPS.
Surface readObj(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<double> points;
  std::vector<int> corners;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      double x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      points.insert(points.end(), {-x, -y, z});
    } else if (kind == "f") {
      for (std::string corner; words >> corner;) corners.push_back(std::stoi(corner) - 1);
    }
  }
  Surface surface;
  surface.points = Eigen::Map<const Points>(points.data(), static_cast<Index>(points.size() / 3), 3);
  surface.triangles = Eigen::Map<const Triangles>(corners.data(), static_cast<Index>(corners.size() / 3), 3);
  checkSurface(surface, file.filename().string());
  return surface;
}

}  // namespace

Points alongEdges(const Points& points, const std::vector<Eigen::Vector2i>& edges) {
  std::vector<double> found;
  for (const Eigen::Vector2i& edge : edges) {
    const Eigen::RowVector3d a = points.row(edge[0]), b = points.row(edge[1]);
    const int steps = std::max(1, static_cast<int>(std::ceil((b - a).norm())));
    for (int s = 0; s <= steps; ++s) {
      const Eigen::RowVector3d p = a + (b - a) * (static_cast<double>(s) / steps);
      found.insert(found.end(), {p.x(), p.y(), p.z()});
    }
  }
  return Eigen::Map<const Points>(found.data(), static_cast<Index>(found.size() / 3), 3);
}

Agreement agreement(const Points& suggested, const Points& truth, double toleranceMm) {
  const auto share = [&](const Points& of, const Points& to, double& meanMm) {
    if (of.rows() == 0 || to.rows() == 0) return 0.0;
    const KdTree tree(to);
    double within = 0;
    meanMm = 0;
    for (Index i = 0; i < of.rows(); ++i) {
      const double away = std::sqrt(tree.nearest(of.row(i)).squaredDistance);
      within += away <= toleranceMm ? 1 : 0;
      meanMm += away / static_cast<double>(of.rows());
    }
    return within / static_cast<double>(of.rows());
  };
  Agreement result;
  result.precision = share(suggested, truth, result.meanToTruthMm);
  result.recall = share(truth, suggested, result.meanFromTruthMm);
  return result;
}

std::vector<AnnotatedLiver> readAnnotatedLivers(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<AnnotatedLiver> livers;
  std::map<std::string, double> perPatient;
  for (std::filesystem::path file : files) {
    AnnotatedLiver liver;
    liver.name = file.stem().string();
    liver.patient = patientOf(liver.name);
    liver.surface = readObj(file);
    std::ifstream edges(file.replace_extension(".edges")), labels(file.replace_extension(".eseg"));
    Eigen::Vector2i edge;
    double label = 0;
    while (edges >> edge[0] >> edge[1] && labels >> label) {
      if (edge.minCoeff() < 0 || edge.maxCoeff() >= liver.surface.size())
        throw InputError("'" + file.string() + "': an edge names a vertex that is not there");
      if (label == 2) liver.grooveEdges.push_back(edge);
      if (label == 3) liver.ridgeEdges.push_back(edge);
    }
    liver.marked.ground = featureGround(liver.surface);
    liver.marked.ridge = alongEdges(liver.surface.points, liver.ridgeEdges);
    liver.marked.groove = alongEdges(liver.surface.points, liver.grooveEdges);
    ++perPatient[liver.patient];
    livers.push_back(std::move(liver));
  }
  for (AnnotatedLiver& liver : livers) liver.marked.weight = 1 / perPatient[liver.patient];
  return livers;
}

}  // namespace falciform::bench
