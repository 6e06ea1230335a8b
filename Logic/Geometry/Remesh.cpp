#include "Logic/Geometry/Remesh.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <sstream>
#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/HalfEdgeMesh.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {

namespace {

// Botsch and Kobbelt's bounds: an edge outside them comes nearer to the aim by a split or a collapse.
constexpr double kLongest = 4.0 / 3, kShortest = 4.0 / 5;
/// Weight of the middle of an edge against the planes around it, in a collapse.
constexpr double kMiddle = 1e-2;
/// How much a face resists motion across it, in relaxation. Where the normals around a vertex lean by an
/// angle t to either side of a crease, a step across it is divided by 1 + (50 sin^2 t)^2: 80 at 25
/// degrees, 1.1 at 5.
constexpr double kAcross = 50;
constexpr double kMaxTurn = 0.5;  ///< cosine of the largest turn of a face in one operation, 60 degrees
constexpr double kFlatCrease =
    0.9;  ///< cosine of the sharpest crease that an edge flip may take or make, 26 degrees
constexpr double kMaxTriangles = 2e7;
constexpr std::size_t kChunk = 1024;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Remesher {
 public:
  /// `edgeLength` everywhere, or `field` with `edgeLength` its smallest value.
  Remesher(const Surface& surface, double edgeLength, const EdgeLengthField& field = {})
      : mesh_(surface), tree_(surface), edge_(edgeLength), field_(field) {}

  void splitLongEdges();
  void collapseShortEdges();
  void evenValences();
  void relax();
  [[nodiscard]] Surface surface() const { return mesh_.surface(); }

 private:
  [[nodiscard]] const Vector3d& x(int v) const { return mesh_.position[at(v)]; }
  [[nodiscard]] double length(int h) const { return (x(mesh_.origin(h)) - x(mesh_.target(h))).norm(); }
  [[nodiscard]] double aimAt(const Vector3d& place) const { return field_ ? field_(place) : edge_; }
  [[nodiscard]] double aim(int h) const {
    return field_ ? (field_(x(mesh_.origin(h))) + field_(x(mesh_.target(h)))) / 2 : edge_;
  }
  [[nodiscard]] Vector3d areaVector(int h) const {
    const Vector3d& a = x(mesh_.origin(h));
    return (x(mesh_.target(h)) - a).cross(x(mesh_.opposite(h)) - a);
  }
  [[nodiscard]] Vector3d meetingPoint(int h) const;
  [[nodiscard]] bool keepsShape(int v, int without, const Vector3d& to) const;
  [[nodiscard]] bool flipKeepsShape(int h) const;
  [[nodiscard]] Vector3d relaxed(int v, const std::vector<double>& areas) const;
  void moveWithoutFolds(const std::vector<Vector3d>& to);

  HalfEdgeMesh mesh_;
  TriangleTree tree_;
  double edge_;
  EdgeLengthField field_;
};

/// Longest first: then every new edge is shorter than the one cut, so that this ends and makes no needles.
void Remesher::splitLongEdges() {
  std::priority_queue<std::pair<double, int>> longest;
  const auto consider = [&](int h) {
    if (length(h) > kLongest * aim(h)) longest.emplace(length(h), h);
  };
  for (int h = 0; h < mesh_.halfEdges(); ++h)
    if (mesh_.twin(h) < h) consider(h);  // each edge once
  while (!longest.empty()) {
    const auto [was, h] = longest.top();
    longest.pop();
    if (length(h) != was) continue;  // cut since
    const int firstNew = mesh_.halfEdges();
    mesh_.split(h);
    const int t = mesh_.twin(firstNew);
    consider(h);
    consider(HalfEdgeMesh::next(h));
    if (t >= 0) consider(HalfEdgeMesh::next(t));
    // The halves, and the outer edges that now belong to the new faces.
    for (int fresh = firstNew; fresh < mesh_.halfEdges(); ++fresh) consider(fresh);
  }
}

/// Where an edge shrinks to: the point nearest to the planes of the faces around both ends (Garland and
/// Heckbert 1997), held to the middle where the planes leave it free. So a collapse beside a ridge ends on
/// the ridge.
Vector3d Remesher::meetingPoint(int h) const {
  const int a = mesh_.origin(h), b = mesh_.target(h);
  if (mesh_.onBoundary(b)) return x(b);
  const Vector3d middle = (x(a) + x(b)) / 2;
  Matrix3d planes = Matrix3d::Zero();
  Vector3d pull = Vector3d::Zero();
  double weight = 0;
  thread_local std::vector<int> spokes;
  for (const int end : {a, b}) {
    mesh_.spokes(end, spokes);
    for (const int s : spokes) {
      const Vector3d n = areaVector(s);
      const double area = n.norm();
      if (!(area > 0)) continue;
      planes += n * n.transpose() / area;
      pull += n * (n.dot(x(end) - middle) / area);
      weight += area;
    }
  }
  if (!(weight > 0)) return middle;
  planes.diagonal().array() += kMiddle * weight;
  const Vector3d step = planes.ldlt().solve(pull);
  return middle + step * std::min(1.0, length(h) / std::max(step.norm(), 1e-300));
}

/// Whether no face around `v` (except those with the vertex `without`) turns over, and no edge gets too long,
/// when v moves.
bool Remesher::keepsShape(int v, int without, const Vector3d& to) const {
  thread_local std::vector<int> spokes;
  mesh_.spokes(v, spokes);
  const double longest = kLongest * aimAt(to);
  for (const int s : spokes) {
    const int p = mesh_.target(s), q = mesh_.opposite(s);
    if (p == without || q == without) continue;
    if ((x(p) - to).norm() > longest || (x(q) - to).norm() > longest) return false;
    const Vector3d before = areaVector(s), after = (x(p) - to).cross(x(q) - to);
    const double areas = before.norm() * after.norm();
    if (!(after.norm() > 1e-6 * edge_ * edge_)) return false;
    if (areas > 0 && before.dot(after) < kMaxTurn * areas) return false;
  }
  return true;
}

void Remesher::collapseShortEdges() {
  for (int h = 0; h < mesh_.halfEdges(); ++h) {
    if (!mesh_.alive(h) || length(h) >= kShortest * aim(h) || !mesh_.collapsible(h)) continue;
    const Vector3d to = meetingPoint(h);
    const int a = mesh_.origin(h), b = mesh_.target(h);
    if (!keepsShape(a, b, to) || !keepsShape(b, a, to)) continue;
    mesh_.collapse(h);
    mesh_.position[at(b)] = to;
  }
  mesh_.compact();
}

/// A flip may not fold the surface, nor cut through a ridge.
bool Remesher::flipKeepsShape(int h) const {
  const int t = mesh_.twin(h);
  const Vector3d &a = x(mesh_.origin(h)), &b = x(mesh_.target(h)), &c = x(mesh_.opposite(h)),
                 &d = x(mesh_.opposite(t));
  const Vector3d oldOne = areaVector(h).stableNormalized(), oldTwo = areaVector(t).stableNormalized();
  const Vector3d one = (c - d).cross(a - d), two = (d - c).cross(b - c);
  if (oldOne.dot(oldTwo) < kFlatCrease) return false;
  const double tiny = 1e-6 * edge_ * edge_;
  if (!(one.norm() > tiny && two.norm() > tiny)) return false;
  const Vector3d n1 = one.normalized(), n2 = two.normalized(), mean = (oldOne + oldTwo).stableNormalized();
  return n1.dot(mean) > kMaxTurn && n2.dot(mean) > kMaxTurn && n1.dot(n2) >= kFlatCrease;
}

void Remesher::evenValences() {
  std::vector<int> excess(at(mesh_.vertices()));
  std::vector<int> ring;
  for (int v = 0; v < mesh_.vertices(); ++v) {
    mesh_.ring(v, ring);
    excess[at(v)] = static_cast<int>(ring.size()) - (mesh_.onBoundary(v) ? 4 : 6);
  }
  for (int h = 0; h < mesh_.halfEdges(); ++h) {
    const int t = mesh_.twin(h);
    if (t < h) continue;  // each edge once; the boundary stays
    const auto ends = {mesh_.origin(h), mesh_.target(h)}, others = {mesh_.opposite(h), mesh_.opposite(t)};
    int change = 0;  // of the sum of squared deviations from the ideal valence
    for (const int v : ends) change += 1 - 2 * excess[at(v)];
    for (const int v : others) change += 1 + 2 * excess[at(v)];
    if (change >= 0 || !mesh_.flippable(h) || !flipKeepsShape(h)) continue;
    mesh_.flip(h);
    for (const int v : ends) --excess[at(v)];
    for (const int v : others) ++excess[at(v)];
  }
}

/// Towards the area-weighted mean of the neighbours, as far as the planes of the faces around allow.
Vector3d Remesher::relaxed(int v, const std::vector<double>& areas) const {
  thread_local std::vector<int> spokes;
  mesh_.spokes(v, spokes);
  Matrix3d planes = Matrix3d::Zero();
  Vector3d goal = Vector3d::Zero();
  double weight = 0, share = 0;
  for (const int s : spokes) {
    const Vector3d n = areaVector(s);
    const double area = n.norm();
    if (area > 0) planes += n * n.transpose() / area;
    weight += area;
    const int other = mesh_.target(s);
    goal += areas[at(other)] * (x(other) - x(v));
    share += areas[at(other)];
  }
  if (!(weight > 0 && share > 0)) return x(v);
  planes *= kAcross / weight;
  const Matrix3d hold = Matrix3d::Identity() + planes * planes;
  return x(v) + hold.ldlt().solve(Vector3d(goal / share));
}

/// Moves the vertices; where that would turn a face over, its corners stay.
void Remesher::moveWithoutFolds(const std::vector<Vector3d>& to) {
  const std::vector<Vector3d> from = mesh_.position;
  std::vector<Vector3d> before(at(mesh_.halfEdges() / 3));
  for (std::size_t f = 0; f < before.size(); ++f) before[f] = areaVector(static_cast<int>(3 * f));
  mesh_.position = to;
  std::vector<char> stays(from.size(), 0);
  for (bool folds = true; folds;) {  // ends at the latest when every vertex stays
    folds = false;
    for (std::size_t f = 0; f < before.size(); ++f) {
      const int h = static_cast<int>(3 * f);
      const Vector3d after = areaVector(h);
      if (before[f].dot(after) > kMaxTurn * before[f].norm() * after.norm()) continue;
      for (const int v : {mesh_.origin(h), mesh_.target(h), mesh_.opposite(h)}) {
        folds = folds || !stays[at(v)];
        stays[at(v)] = 1;
        mesh_.position[at(v)] = from[at(v)];
      }
    }
  }
}

void Remesher::relax() {
  std::vector<double> areas(mesh_.position.size(), 0.0);
  std::vector<Vector3d> normals(mesh_.position.size(), Vector3d::Zero());
  for (int h = 0; h < mesh_.halfEdges(); h += 3) {
    const Vector3d n = areaVector(h);
    for (const int v : {mesh_.origin(h), mesh_.target(h), mesh_.opposite(h)}) {
      areas[at(v)] += n.norm();
      normals[at(v)] += n;
    }
  }
  if (field_)  // even in numbers of edge lengths, not in mm
    for (std::size_t v = 0; v < areas.size(); ++v) areas[v] /= std::pow(field_(mesh_.position[v]), 2);
  std::vector<Vector3d> to(mesh_.position.size());
  forEachChunk(to.size(), kChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const int v = static_cast<int>(i);
      to[i] = x(v);
      if (mesh_.onBoundary(v)) continue;
      // In a cleft or a thin lobe the sheet across may be nearer: a place that faces the other way is not
      // ours.
      const ClosestPlace place = tree_.closest(relaxed(v, areas));
      if (tree_.triangleNormal(place.triangle).dot(normals[i]) > 0) to[i] = place.point;
    }
  });
  moveWithoutFolds(to);
}

void checkAim(const Surface& surface, double edgeLength) {
  std::ostringstream text;
  if (!(edgeLength > 0 && std::isfinite(edgeLength))) {
    text << "the edge length is " << edgeLength << " mm; choose a length above 0";
    throw InputError(text.str());
  }
  const double whole = area(surface), triangles = whole / (std::sqrt(3.0) / 4 * edgeLength * edgeLength);
  if (!(triangles > kMaxTriangles)) return;
  text << "an edge length of " << edgeLength << " mm would cut the surface into " << triangles
       << " triangles; choose at least " << std::sqrt(whole / kMaxTriangles * 4 / std::sqrt(3.0)) << " mm";
  throw InputError(text.str());
}

}  // namespace

namespace {

Surface remeshed(const Surface& surface, Remesher remesher, int passes, const Progress& progress) {
  for (int pass = 0; pass < passes; ++pass) {
    const auto report = [&](double step) { progress.report((pass + step / 4) / passes, "Remeshing"); };
    report(0);
    remesher.splitLongEdges();
    report(1);
    remesher.collapseShortEdges();
    report(2);
    remesher.evenValences();
    report(3);
    remesher.relax();
  }
  progress.report(1, "Remeshing");
  Surface result = remesher.surface();
  result.frame = surface.frame;
  return result;
}

}  // namespace

Surface remeshIsotropic(const Surface& surface, double edgeLengthMm, int passes, const Progress& progress) {
  checkAim(surface, edgeLengthMm);
  return remeshed(surface, Remesher(surface, edgeLengthMm), passes, progress);
}

Surface remeshIsotropic(const Surface& surface, const EdgeLengthField& edgeLengthMm, double shortestMm,
                        int passes, const Progress& progress) {
  checkAim(surface, shortestMm);
  return remeshed(surface, Remesher(surface, shortestMm, edgeLengthMm), passes, progress);
}

}  // namespace falciform
