#include "Logic/Geometry/FanSplitting.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "Logic/Geometry/Topology.h"

namespace falciform {

Surface withFansApart(const Surface& surface) {
  Surface result;
  result.frame = surface.frame;
  result.triangles = surface.triangles;
  std::vector<int> copyOf(static_cast<std::size_t>(surface.size()));
  std::iota(copyOf.begin(), copyOf.end(), 0);
  const Adjacency around = trianglesOfVertices(surface.triangles, surface.size());
  std::vector<int> fan;
  for (int v = 0; v < static_cast<int>(surface.size()); ++v) {
    const int count = around.count(v);
    const int* faces = around.begin(v);
    // Triangles that share another corner beside v share an edge at v: the lowest of each fan names it.
    fan.resize(static_cast<std::size_t>(count));
    std::iota(fan.begin(), fan.end(), 0);
    for (bool changed = true; changed;) {
      changed = false;
      for (int a = 0; a < count; ++a)
        for (int b = 0; b < a; ++b) {
          int &nameA = fan[static_cast<std::size_t>(a)], &nameB = fan[static_cast<std::size_t>(b)];
          if (nameA == nameB) continue;
          int shared = 0;
          for (Index i = 0; i < 3; ++i)
            for (Index j = 0; j < 3; ++j)
              shared += surface.triangles(faces[a], i) == surface.triangles(faces[b], j);
          if (shared < 2) continue;
          nameA = nameB = std::min(nameA, nameB);
          changed = true;
        }
    }
    for (int name = 1; name < count; ++name) {
      if (std::find(fan.begin(), fan.end(), name) == fan.end()) continue;
      const auto copy = static_cast<int>(copyOf.size());
      copyOf.push_back(v);
      for (int a = 0; a < count; ++a)
        if (fan[static_cast<std::size_t>(a)] == name)
          for (Index i = 0; i < 3; ++i)
            if (surface.triangles(faces[a], i) == v) result.triangles(faces[a], i) = copy;
    }
  }
  result.points.resize(std::ssize(copyOf), 3);
  for (std::size_t i = 0; i < copyOf.size(); ++i)
    result.points.row(static_cast<Index>(i)) = surface.points.row(copyOf[i]);
  return result;
}

}  // namespace falciform
