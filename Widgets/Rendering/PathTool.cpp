#include "Widgets/Rendering/PathTool.h"

namespace falciform {

namespace {

Points pointsOf(const std::vector<SurfacePlace>& places) {
  Points points(static_cast<Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i)
    points.row(static_cast<Index>(i)) = places[i].point.transpose();
  return points;
}

}  // namespace

bool PathTool::click(const BrushSurface& surface, const TriangleTree* tree, const SurfacePlace& place,
                     const VectorXd& cost) {
  ahead_.clear();
  if (!clicks_.empty()) {
    std::vector<SurfacePlace> way = shortestPath(surface, tree, clicks_.back(), place, cost);
    if (way.empty()) return false;
    ways_.push_back(std::move(way));
  }
  clicks_.push_back(place);
  return true;
}

void PathTool::hover(const BrushSurface& surface, const TriangleTree* tree, const SurfacePlace& place,
                     const VectorXd& cost) {
  ahead_ = clicks_.empty() ? std::vector<SurfacePlace>()
                           : shortestPath(surface, tree, clicks_.back(), place, cost);
}

void PathTool::back() {
  if (!clicks_.empty()) clicks_.pop_back();
  if (!ways_.empty()) ways_.pop_back();
  ahead_.clear();
}

void PathTool::clear() {
  clicks_.clear();
  ways_.clear();
  ahead_.clear();
  drawing_.hide();
}

std::vector<SurfacePlace> PathTool::line() const {
  if (ways_.empty()) return clicks_;
  std::vector<SurfacePlace> all;
  for (const auto& way : ways_) all.insert(all.end(), way.begin(), way.end());
  return all;
}

void PathTool::draw(const Isometry3d& sceneFromSurface, const Vector3d& colour) {
  if (empty()) return drawing_.hide();
  std::vector<SurfacePlace> all = line();
  all.insert(all.end(), ahead_.begin(), ahead_.end());
  drawing_.show(transformed(pointsOf(all), sceneFromSurface),
                transformed(pointsOf(clicks_), sceneFromSurface), colour);
}

}  // namespace falciform
