#include "Widgets/Rendering/BrushCursorPresenter.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace falciform {

namespace {

/// Drawn a little in front of the surface it lies on, or half of it would sink in.
vtkSmartPointer<vtkActor> lineActor(vtkPolyData* data, float width, double units) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4, units);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  actor->VisibilityOff();
  return actor;
}

}  // namespace

BrushCursorPresenter::BrushCursorPresenter(vtkRenderer* renderer)
    : renderer_(renderer), data_(vtkSmartPointer<vtkPolyData>::New()) {
  rim_ = lineActor(data_, 4, -400);
  line_ = lineActor(data_, 2, -800);
  rim_->GetProperty()->SetColor(0.1, 0.1, 0.1);
  renderer_->AddActor(rim_);
  renderer_->AddActor(line_);
}

BrushCursorPresenter::~BrushCursorPresenter() {
  renderer_->RemoveActor(line_);
  renderer_->RemoveActor(rim_);
}

void BrushCursorPresenter::show(const Points& ring, const Vector3d& colour) {
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(ring.rows());
  for (Index i = 0; i < ring.rows(); ++i) points->SetPoint(i, ring(i, 0), ring(i, 1), ring(i, 2));
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(ring.rows()) + 1);
  for (Index i = 0; i <= ring.rows(); ++i) lines->InsertCellPoint(i % ring.rows());
  data_->SetPoints(points);
  data_->SetLines(lines);
  line_->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  rim_->VisibilityOn();
  line_->VisibilityOn();
}

void BrushCursorPresenter::hide() {
  rim_->VisibilityOff();
  line_->VisibilityOff();
}

bool BrushCursorPresenter::visible() const { return line_->GetVisibility() != 0; }

}  // namespace falciform
