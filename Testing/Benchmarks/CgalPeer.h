#pragma once
#include <memory>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// CGAL's tree of boxes over triangles, in doubles.
class CgalTree {
 public:
  explicit CgalTree(const Surface& mesh);
  ~CgalTree();
  /// Unsigned distances, on all threads.
  [[nodiscard]] VectorXd distances(const Points& queries) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// CGAL's Monge form by a jet of degree 2 through the two rings of each vertex, on all threads; rings are
/// found outside of CGAL.
[[nodiscard]] VectorXd cgalJetCurvature(const Surface& surface);

}  // namespace falciform::bench
