#include "Widgets/Views/CaseScene.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>

#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/ScanView.h"

// From where a case is looked at.

namespace falciform {
namespace {

constexpr double kNarrowBar = 5;  // lines of text that a bar without words takes of the width
constexpr double kAroundSeedMm = 80;

}  // namespace

bool CaseScene::outOfSight(const SurfacePresenter& presenter) const {
  constexpr Index kSample = 200;
  constexpr double kMostOutside = 0.1;
  const auto& surface = presenter.surface();
  if (!surface || surface->size() == 0 || !scene_.renderer()->GetVTKWindow()) return false;
  const Index stride = std::max<Index>(1, surface->size() / kSample);
  Index outside = 0, all = 0;
  for (Index i = 0; i < surface->size(); i += stride, ++all) {
    Vector3d at = presenter.sceneFromSurface() * surface->points.row(i).transpose();
    scene_.renderer()->WorldToView(at.x(), at.y(), at.z());
    if (std::abs(at.x()) > 1 || std::abs(at.y()) > 1) ++outside;
  }
  return static_cast<double>(outside) > kMostOutside * static_cast<double>(all);
}

Matrix3d CaseScene::sceneFromLps() const {
  if (!scanAlone() || !case_.registration()) return Matrix3d::Identity();
  return case_.registration()->scanFromPreop.linear();
}

Points CaseScene::shownPoints() const {
  const std::vector<ShownSurface> visible = shown();
  Index count = 0;
  for (const ShownSurface& one : visible) count += one.surface->size();
  Points all(count, 3);
  Index row = 0;
  for (const ShownSurface& one : visible) {
    all.middleRows(row, one.surface->size()) = transformed(one.surface->points, one.sceneFromSurface);
    row += one.surface->size();
  }
  const auto& seeds = view_.options().seeds;
  if (row > 0 || !seeds) return all;
  // Seeds alone: as much around them as a liver takes.
  all.resize(2 * seeds->rows(), 3);
  all << (seeds->array() - kAroundSeedMm).matrix(), (seeds->array() + kAroundSeedMm).matrix();
  return all;
}

ViewDirection CaseScene::firstDirection() const {
  const auto& scan = case_.scan();
  if (!scanAlone() || !scan) return directionOf(StandardView::Anterior);
  const auto& registration = case_.registration();
  if (registration && case_.preop())
    return viewOfScan(*scan, transformed(case_.preop()->points, registration->scanFromPreop),
                      registration->scanFromPreop);
  const Vector3d from = seenFrom(*scan);
  return {from, uprightFor(*scan, from)};
}

void CaseScene::fit(double widthPx, double heightPx) {
  const Points points = shownPoints();
  if (points.rows() == 0) return;
  ViewDirection direction = firstDirection();
  if (directedScanAlone_ == scanAlone()) {
    vtkCamera* camera = scene_.renderer()->GetActiveCamera();
    Vector3d back;
    camera->GetDirectionOfProjection(back.data());
    camera->GetViewUp(direction.up.data());
    direction.from = -back;
  }
  directedScanAlone_ = scanAlone();
  ViewMargins margins;
  // Title, legend and colour bar with their words stand beside the liver rather than on it.
  margins.top = std::min(0.3, (legendLines_ > 0 ? 3.2 + 1.5 * legendLines_ : 2.6) * textPx_ / heightPx);
  if (fittedBar_) margins.right = std::min(0.4, (narrow_ ? kNarrowBar : 11.5) * textPx_ / widthPx);
  fitView(scene_.renderer(), points, direction, widthPx / heightPx, margins);
}

}  // namespace falciform
