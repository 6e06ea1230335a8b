#pragma once
#include <memory>
#include <mutex>
#include <vector>

#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/VertexRings.h"

namespace falciform {

/// The points around each place of a surface, as CurvatureSettings choose them.
class Neighbourhoods {
 public:
  /// Throws InputError for a cloud without normals. `surface` must outlive this.
  Neighbourhoods(const Surface& surface, const CurvatureSettings& settings);

  /// What one thread needs to ask; borrowed for a chunk of places.
  struct Scratch {
    std::vector<int> found;        ///< the answer: points around, without the place itself
    std::vector<unsigned> seenIn;  ///< by vertex: the question in which it was met last
    std::vector<std::pair<double, int>> byDistance;
    unsigned question = 0;
  };
  [[nodiscard]] std::unique_ptr<Scratch> borrow() const;
  void giveBack(std::unique_ptr<Scratch> scratch) const;

  void gather(int place, Scratch& scratch) const;
  /// Unit, outward; zero if not known there.
  [[nodiscard]] Vector3d normal(int place) const;

 private:
  void gatherRings(int place, Scratch& scratch) const;
  void gatherConnected(int place, Scratch& scratch) const;
  void gatherCloud(int place, Scratch& scratch) const;
  void keepNearest(int place, Scratch& scratch) const;

  const Surface& surface_;
  CurvatureSettings settings_;
  std::unique_ptr<VertexRings> rings_;  ///< of a mesh
  KdTree tree_;                         ///< of a cloud
  mutable std::mutex guard_;
  mutable std::vector<std::unique_ptr<Scratch>> free_;
};

}  // namespace falciform
