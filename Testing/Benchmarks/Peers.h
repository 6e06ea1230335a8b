#pragma once
#include <memory>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform::bench {

/// Rigid registration of the scan to the pre-op surface by a peer, from the pose as given, for at most
/// `iterations` or to its own convergence, with settings as a careful user would choose. Returns
/// preopFromScan. All scan points; VTK matches to places on triangles, of 2,000 scan points (its default is
/// 200).
[[nodiscard]] Isometry3d vtkIcp(const Surface& preop, const Surface& scan, int iterations = 1000);
[[nodiscard]] Isometry3d pclIcp(const Surface& preop, const Surface& scan, int iterations = 1000);

/// Nearest points by vtkStaticPointLocator: row of `points` for each row of `queries`, on threads() threads.
/// The locator is built by the constructor.
class VtkNeighbours {
 public:
  explicit VtkNeighbours(const Points& points);
  ~VtkNeighbours();
  void nearest(const Points& queries, std::vector<int>& rows) const;

 private:
  struct Locator;
  std::unique_ptr<const Locator> locator_;
};

}  // namespace falciform::bench
