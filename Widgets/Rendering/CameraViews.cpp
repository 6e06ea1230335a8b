#include "Widgets/Rendering/CameraViews.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace falciform {

ViewDirection directionOf(StandardView view) {
  const Vector3d left(1, 0, 0), posterior(0, 1, 0), superior(0, 0, 1);
  switch (view) {
    case StandardView::Anterior:
      return {-posterior, superior};
    case StandardView::Posterior:
      return {posterior, superior};
    case StandardView::Right:
      return {-left, superior};
    case StandardView::Left:
      return {left, superior};
    case StandardView::Superior:
      return {superior, -posterior};
    case StandardView::Inferior:
      return {-superior, -posterior};
  }
  return {-posterior, superior};
}

void setStandardView(vtkRenderer* renderer, StandardView view, const Matrix3d& sceneFromLps) {
  const ViewDirection lps = directionOf(view);
  const Vector3d from = sceneFromLps * lps.from, up = sceneFromLps * lps.up;
  vtkCamera* camera = renderer->GetActiveCamera();
  Vector3d focus;
  camera->GetFocalPoint(focus.data());
  const Vector3d position = focus + camera->GetDistance() * from;
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  renderer->ResetCamera();
}

void fitView(vtkRenderer* renderer, const Points& points, const ViewDirection& direction, double aspect,
             const ViewMargins& margins) {
  if (points.rows() == 0) return;
  const Vector3d from = direction.from.normalized();
  const Vector3d right = direction.up.cross(from).normalized();
  const Vector3d up = from.cross(right);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double tanY = std::tan(camera->GetViewAngle() / 2 * std::numbers::pi / 180), tanX = tanY * aspect;

  // The usable rectangle in normalised device coordinates, its half size and centre.
  const double halfX = 1 - margins.left - margins.right, halfY = 1 - margins.top - margins.bottom;
  const double centreX = margins.left - margins.right, centreY = margins.bottom - margins.top;

  const Vector3d middle = (points.colwise().minCoeff() + points.colwise().maxCoeff()).transpose() / 2;
  const Points offset = points.rowwise() - middle.transpose();
  const VectorXd x = offset * right, y = offset * up, z = offset * from;
  // The axis runs through (shiftX, shiftY); distance and shift depend on each other through perspective, so
  // iterate.
  double shiftX = (x.minCoeff() + x.maxCoeff()) / 2, shiftY = (y.minCoeff() + y.maxCoeff()) / 2;
  double distance = 1;
  for (int pass = 0; pass < 5; ++pass) {
    double needed = z.maxCoeff() + 1;
    for (Index i = 0; i < x.size(); ++i)
      needed = std::max({needed, z[i] + std::abs(x[i] - shiftX) / (tanX * halfX),
                         z[i] + std::abs(y[i] - shiftY) / (tanY * halfY)});
    distance = needed;
    const auto centreOf = [&](const VectorXd& across, double shift) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (Index i = 0; i < across.size(); ++i) {
        const double seen = (across[i] - shift) / (distance - z[i]);
        low = std::min(low, seen);
        high = std::max(high, seen);
      }
      return (low + high) / 2 * distance;
    };
    shiftX += centreOf(x, shiftX);
    shiftY += centreOf(y, shiftY);
  }
  const Vector3d focus =
      middle + (shiftX - centreX * tanX * distance) * right + (shiftY - centreY * tanY * distance) * up;
  const Vector3d position = focus + distance * from;
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  renderer->ResetCameraClippingRange();
}

}  // namespace falciform
