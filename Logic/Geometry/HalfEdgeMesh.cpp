#include "Logic/Geometry/HalfEdgeMesh.h"

#include <algorithm>
#include <cassert>

#include "Logic/Core/Errors.h"
#include "Logic/Geometry/Topology.h"

namespace falciform {

HalfEdgeMesh::HalfEdgeMesh(const Surface& surface) {
  const TopologyReport report = inspectTopology(surface);
  if (report.nonManifoldEdges + report.flippedEdges + report.nonManifoldVertices +
          report.degenerateTriangles >
      0)
    throw InputError("the surface is not a manifold (" + describeTopology(report) +
                     "); repair it or make it anew from the label map");
  for (Index i = 0; i < surface.size(); ++i) position.emplace_back(surface.points.row(i).transpose());
  origin_.assign(surface.triangles.data(), surface.triangles.data() + surface.triangles.size());
  twin_.assign(origin_.size(), -1);
  out_.assign(position.size(), -1);
  boundary_.assign(position.size(), 0);

  const Adjacency around = trianglesOfVertices(surface.triangles, surface.size());
  for (int h = 0; h < halfEdges(); ++h) {
    out_[at(origin(h))] = h;
    if (twin(h) >= 0) continue;
    for (const int* f = around.begin(target(h)); f != around.end(target(h)); ++f)
      for (int t = 3 * *f; t < 3 * *f + 3; ++t)
        if (origin(t) == target(h) && target(t) == origin(h)) pair(h, t);
  }
  for (int h = 0; h < halfEdges(); ++h)
    if (twin(h) < 0) boundary_[at(origin(h))] = boundary_[at(target(h))] = 1;
}

void HalfEdgeMesh::pair(int h, int t) {
  if (h >= 0) twin_[at(h)] = t;
  if (t >= 0) twin_[at(t)] = h;
}

void HalfEdgeMesh::spokes(int v, std::vector<int>& result) const {
  result.clear();
  const int start = out_[at(v)];
  int h = start;
  do {
    result.push_back(h);
    h = twin(previous(h));
  } while (h >= 0 && h != start);
  if (h == start) return;
  // A boundary stopped the walk: the rest lies the other way round, in reverse.
  const auto counterClockwise = static_cast<std::ptrdiff_t>(result.size());
  for (h = twin(start); h >= 0; h = twin(h)) {
    h = next(h);
    result.push_back(h);
  }
  std::reverse(result.begin() + counterClockwise, result.end());
  std::rotate(result.begin(), result.begin() + counterClockwise, result.end());
}

void HalfEdgeMesh::ring(int v, std::vector<int>& result) const {
  spokes(v, result);
  const int last = result.back();
  for (int& h : result) h = target(h);
  if (onBoundary(v)) result.push_back(opposite(last));
}

void HalfEdgeMesh::split(int h) {
  const int a = origin(h), b = target(h), c = opposite(h), t = twin(h);
  const int m = vertices();
  position.emplace_back((position[at(a)] + position[at(b)]) / 2);
  boundary_.push_back(t < 0 ? 1 : 0);

  // Face a b c becomes a m c, and a new face m b c takes the other half.
  const int hn = next(h), n = halfEdges();
  origin_.insert(origin_.end(), {m, b, c});
  twin_.insert(twin_.end(), 3, -1);
  pair(n + 1, twin(hn));
  pair(hn, n + 2);
  origin_[at(hn)] = m;
  out_.push_back(n);
  out_[at(a)] = h;
  out_[at(b)] = n + 1;
  if (t < 0) {
    twin_[at(h)] = -1;
    return;
  }
  // The same on the other side: b a d becomes b m d, and m a d is new.
  const int tn = next(t), k = halfEdges(), d = opposite(t);
  origin_.insert(origin_.end(), {m, a, d});
  twin_.insert(twin_.end(), 3, -1);
  pair(k + 1, twin(tn));
  pair(tn, k + 2);
  origin_[at(tn)] = m;
  pair(h, k);
  pair(n, t);
}

bool HalfEdgeMesh::collapsible(int h) const {
  const int a = origin(h), b = target(h), t = twin(h);
  if (onBoundary(a) || t < 0) return false;  // the boundary keeps its vertices
  thread_local std::vector<int> ringA, ringB;
  ring(a, ringA);
  ring(b, ringB);
  const int c = opposite(h), d = opposite(t);
  if (c == d || ringA.size() <= 3) return false;
  for (const int v : ringA)
    if (v != c && v != d && std::find(ringB.begin(), ringB.end(), v) != ringB.end()) return false;
  // c and d lose an edge each: with three or fewer, two faces would come to lie on each other.
  for (const int v : {c, d}) {
    ring(v, ringB);
    if (ringB.size() <= 3) return false;
  }
  return true;
}

void HalfEdgeMesh::collapse(int h) {
  assert(collapsible(h));
  const int a = origin(h), b = target(h), t = twin(h);
  const int c = opposite(h), d = opposite(t);
  thread_local std::vector<int> leaving;
  spokes(a, leaving);
  for (const int s : leaving) origin_[at(s)] = b;

  const int bc = twin(previous(h)), cb = twin(next(h));  // after the move, b -> c and c -> b
  const int db = twin(next(t)), bd = twin(previous(t));
  pair(bc, cb);
  pair(db, bd);
  out_[at(b)] = bc;
  out_[at(c)] = next(bc);
  out_[at(d)] = db;
  out_[at(a)] = -1;
  for (const int face : {h / 3, t / 3})
    for (int c3 = 0; c3 < 3; ++c3) origin_[at(3 * face + c3)] = -1;
}

bool HalfEdgeMesh::flippable(int h) const {
  const int t = twin(h);
  if (t < 0) return false;
  const int c = opposite(h), d = opposite(t);
  if (c == d) return false;
  thread_local std::vector<int> ends;
  ring(c, ends);
  if (std::find(ends.begin(), ends.end(), d) != ends.end()) return false;
  for (const int v : {origin(h), target(h)}) {
    ring(v, ends);
    if (ends.size() <= 3) return false;
  }
  return true;
}

void HalfEdgeMesh::flip(int h) {
  assert(flippable(h));
  const int t = twin(h), hn = next(h), hp = previous(h), tn = next(t), tp = previous(t);
  const int a = origin(h), b = target(h), c = opposite(h), d = opposite(t);
  const int ca = twin(hp), ad = twin(tn), db = twin(tp), bc = twin(hn);
  // Faces a b c and b a d become d c a (half-edges h hn hp) and c d b (t tn tp).
  origin_[at(h)] = d;
  origin_[at(hn)] = c;
  origin_[at(hp)] = a;
  origin_[at(t)] = c;
  origin_[at(tn)] = d;
  origin_[at(tp)] = b;
  twin_[at(hn)] = twin_[at(hp)] = twin_[at(tn)] = twin_[at(tp)] = -1;
  pair(hn, ca);
  pair(hp, ad);
  pair(tn, db);
  pair(tp, bc);
  out_[at(a)] = hp;
  out_[at(b)] = tp;
  out_[at(c)] = hn;
  out_[at(d)] = tn;
}

void HalfEdgeMesh::compact() {
  std::vector<int> vertexNow(position.size(), -1), edgeNow(origin_.size(), -1);
  int kept = 0;
  for (int v = 0; v < vertices(); ++v)
    if (vertexAlive(v)) vertexNow[at(v)] = kept++;
  const auto keptVertices = at(kept);
  kept = 0;
  for (int h = 0; h < halfEdges(); ++h)
    if (alive(h)) edgeNow[at(h)] = kept++;
  for (int v = 0; v < vertices(); ++v) {
    const int now = vertexNow[at(v)];
    if (now < 0) continue;
    position[at(now)] = position[at(v)];
    out_[at(now)] = edgeNow[at(out_[at(v)])];
    boundary_[at(now)] = boundary_[at(v)];
  }
  for (int h = 0; h < static_cast<int>(edgeNow.size()); ++h) {
    const int now = edgeNow[at(h)];
    if (now < 0) continue;
    const int t = twin(h);
    origin_[at(now)] = vertexNow[at(origin(h))];
    twin_[at(now)] = t < 0 ? -1 : edgeNow[at(t)];
  }
  position.resize(keptVertices);
  out_.resize(keptVertices);
  boundary_.resize(keptVertices);
  origin_.resize(at(kept));
  twin_.resize(at(kept));
}

Surface HalfEdgeMesh::surface() const {
  HalfEdgeMesh tidy = *this;
  tidy.compact();
  Surface result;
  result.points.resize(tidy.vertices(), 3);
  for (int v = 0; v < tidy.vertices(); ++v) result.points.row(v) = tidy.position[at(v)].transpose();
  result.triangles = Eigen::Map<const Triangles>(tidy.origin_.data(), tidy.halfEdges() / 3, 3);
  return result;
}

}  // namespace falciform
