#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

// What a user has today for the metrics of a deformation: VTK, and CGAL where it is installed (./run bench
// installs it).

struct MetricPeer {
  const char* who;
  std::function<VectorXd(const Points& places)> search;  ///< one value a place
  bool threads;                                          ///< may be asked by several
};

/// Distances of points to one closed mesh; all trees are built once.
class MeshDistancePeers {
 public:
  explicit MeshDistancePeers(const Surface& mesh);
  ~MeshDistancePeers();
  [[nodiscard]] std::vector<MetricPeer> all() const;

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

/// Mean curvature at every vertex of `surface`, which must outlive what is returned.
[[nodiscard]] std::vector<MetricPeer> curvaturePeers(const Surface& surface);

}  // namespace falciform::bench
