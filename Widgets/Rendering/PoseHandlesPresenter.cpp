#include "Widgets/Rendering/PoseHandlesPresenter.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Widgets/Rendering/Picking.h"

namespace falciform {

namespace {

constexpr int kRingPoints = 97, kShaftPoints = 9;                   // the ring's last point is its first
constexpr double kShaftFrom = 1.10, kShaftTo = 1.45, kBarb = 0.09;  // of the rings' radius
constexpr double kWidth = 2.5, kWideWidth = 5.5, kReach = 9;        // desktop pixels

vtkSmartPointer<vtkActor> onTop(vtkPolyData* data, const Vector3d& colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  // An offset larger than the whole depth range: in front of everything.
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -1e9);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

}  // namespace

Vector3d axisColour(int axis) {
  // Okabe and Ito (2008): vermilion, bluish green, blue.
  static const std::array<Vector3d, 3> colours{Vector3d(213, 94, 0), Vector3d(0, 158, 115),
                                               Vector3d(0, 114, 178)};
  return colours[static_cast<std::size_t>(axis)] / 255.0;
}

PoseHandlesPresenter::PoseHandlesPresenter(vtkRenderer* renderer, double pixelRatio)
    : renderer_(renderer), pixelRatio_(pixelRatio) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    part.handle = {i < 3, static_cast<int>(i % 3)};
    part.data = vtkSmartPointer<vtkPolyData>::New();
    part.actor = onTop(part.data, axisColour(part.handle.axis));
    renderer_->AddActor(part.actor);
  }
  highlight({});
}

PoseHandlesPresenter::~PoseHandlesPresenter() {
  for (const Part& part : parts_) renderer_->RemoveActor(part.actor);
}

Points PoseHandlesPresenter::line(const PoseHandle& handle) const {
  const Vector3d axis = Vector3d::Unit(handle.axis), u = Vector3d::Unit((handle.axis + 1) % 3),
                 v = Vector3d::Unit((handle.axis + 2) % 3);
  Points points(handle.turns ? kRingPoints : kShaftPoints, 3);
  for (Index i = 0; i < points.rows(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points.rows() - 1);
    const double angle = 2 * std::numbers::pi * share;
    const Vector3d place = handle.turns ? Vector3d(std::cos(angle) * u + std::sin(angle) * v)
                                        : Vector3d((kShaftFrom + share * (kShaftTo - kShaftFrom)) * axis);
    points.row(i) = (centre_ + radiusMm_ * place).transpose();
  }
  return points;
}

void PoseHandlesPresenter::show(const Vector3d& centre, double radiusMm) {
  centre_ = centre;
  radiusMm_ = radiusMm;
  for (const Part& part : parts_) {
    const Points along = line(part.handle);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(along.rows()));
    for (Index i = 0; i < along.rows(); ++i)
      lines->InsertCellPoint(points->InsertNextPoint(along(i, 0), along(i, 1), along(i, 2)));
    for (int barb = 0; !part.handle.turns && barb < 4; ++barb) {
      const Vector3d aside = (barb < 2 ? 0.5 : -0.5) * Vector3d::Unit((part.handle.axis + 1 + barb % 2) % 3);
      const Vector3d tip = along.row(along.rows() - 1).transpose();
      const Vector3d end = tip + kBarb * radiusMm_ * (aside - Vector3d::Unit(part.handle.axis));
      lines->InsertNextCell({points->InsertNextPoint(tip.data()), points->InsertNextPoint(end.data())});
    }
    part.data->SetPoints(points);
    part.data->SetLines(lines);
  }
}

void PoseHandlesPresenter::highlight(const std::optional<PoseHandle>& handle) {
  for (const Part& part : parts_)
    part.actor->GetProperty()->SetLineWidth(
        static_cast<float>(pixelRatio_ * (handle == part.handle ? kWideWidth : kWidth)));
}

std::optional<PoseGrip> PoseHandlesPresenter::at(double x, double y) const {
  std::optional<PoseGrip> nearest;
  double best = kReach * pixelRatio_;
  for (const Part& part : parts_) {
    const Points along = line(part.handle);
    for (Index i = 0; i + 1 < along.rows(); ++i) {
      const Vector3d a = along.row(i).transpose(), b = along.row(i + 1).transpose();
      const Eigen::Vector2d from = screenPosition(renderer_, a), to = screenPosition(renderer_, b);
      const Eigen::Vector2d step = to - from, away = Eigen::Vector2d(x, y) - from;
      const double length2 = step.squaredNorm();
      const double t = length2 > 0 ? std::clamp(away.dot(step) / length2, 0.0, 1.0) : 0.0;
      const double distance = (away - t * step).norm();
      if (distance > best) continue;
      best = distance;
      nearest = PoseGrip{part.handle, a + t * (b - a)};
    }
  }
  return nearest;
}

}  // namespace falciform
