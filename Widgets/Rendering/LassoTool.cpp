#include "Widgets/Rendering/LassoTool.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>

namespace falciform {

namespace {

constexpr double kShortestStepPx = 3;

vtkSmartPointer<vtkActor2D> lineActor(vtkPolyData* data, float width, double grey) {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->SetColor(grey, grey, grey);
  actor->PickableOff();
  return actor;
}

}  // namespace

LassoTool::LassoTool(vtkRenderer* renderer)
    : renderer_(renderer), data_(vtkSmartPointer<vtkPolyData>::New()) {
  rim_ = lineActor(data_, 4, 0.1);
  line_ = lineActor(data_, 2, 1);
  renderer_->AddActor2D(rim_);
  renderer_->AddActor2D(line_);
}

LassoTool::~LassoTool() {
  renderer_->RemoveActor2D(rim_);
  renderer_->RemoveActor2D(line_);
}

void LassoTool::add(int x, int y) {
  const Eigen::Vector2d corner(x, y);
  if (!corners_.empty() && (corner - corners_.back()).norm() < kShortestStepPx) return;
  corners_.push_back(corner);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto count = static_cast<vtkIdType>(corners_.size());
  lines->InsertNextCell(static_cast<int>(count) + 1);
  const int* origin = renderer_->GetOrigin();
  for (const Eigen::Vector2d& at : corners_)
    points->InsertNextPoint(at.x() - origin[0], at.y() - origin[1], 0);
  for (vtkIdType i = 0; i <= count; ++i) lines->InsertCellPoint(i % count);
  data_->SetPoints(points);
  data_->SetLines(lines);
}

void LassoTool::clear() {
  corners_.clear();
  data_->Initialize();
}

std::vector<int> LassoTool::inside(const Surface& surface, const TriangleTree* tree,
                                   const Isometry3d& sceneFromSurface) const {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const int* size = renderer_->GetSize();
  const int* origin = renderer_->GetOrigin();
  vtkMatrix4x4* clip = camera->GetCompositeProjectionTransformMatrix(renderer_->GetTiledAspectRatio(), -1, 1);
  Matrix4d clipFromScene;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) clipFromScene(r, c) = clip->GetElement(r, c);
  Matrix4d screenFromClip = Matrix4d::Identity();
  for (int k = 0; k < 2; ++k) {
    screenFromClip(k, k) = 0.5 * size[k];
    screenFromClip(k, 3) = 0.5 * size[k] + origin[k];
  }
  LassoView view;
  view.screenFromSurface = screenFromClip * clipFromScene * sceneFromSurface.matrix();
  view.parallel = camera->GetParallelProjection() != 0;
  const Isometry3d surfaceFromScene = sceneFromSurface.inverse();
  Vector3d eye;
  if (view.parallel) {
    camera->GetDirectionOfProjection(eye.data());
    view.eye = surfaceFromScene.linear() * -eye;
  } else {
    camera->GetPosition(eye.data());
    view.eye = surfaceFromScene * eye;
  }
  Eigen::Matrix<double, Eigen::Dynamic, 2> outline(static_cast<Index>(corners_.size()), 2);
  for (std::size_t i = 0; i < corners_.size(); ++i)
    outline.row(static_cast<Index>(i)) = corners_[i].transpose();
  return pointsInLasso(surface, surface.normals, tree, view, outline);
}

}  // namespace falciform
