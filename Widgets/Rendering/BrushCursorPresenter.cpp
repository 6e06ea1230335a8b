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
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-4, units);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(units);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->SetPointSize(3 * width);
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
  draw(ring, true, Points(0, 3), colour);
}

void BrushCursorPresenter::show(const Points& line, const Points& dots, const Vector3d& colour) {
  draw(line, false, dots, colour);
}

void BrushCursorPresenter::draw(const Points& line, bool closed, const Points& dots, const Vector3d& colour) {
  const Index n = line.rows();
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(n + dots.rows());
  for (Index i = 0; i < n; ++i) points->SetPoint(i, line.row(i).data());
  for (Index i = 0; i < dots.rows(); ++i) points->SetPoint(n + i, dots.row(i).data());
  vtkNew<vtkCellArray> lines, vertices;
  const Index ends = n + (closed ? 1 : 0);
  if (n > 1) {
    lines->InsertNextCell(static_cast<int>(ends));
    for (Index i = 0; i < ends; ++i) lines->InsertCellPoint(i % n);
  }
  for (Index i = 0; i < dots.rows(); ++i) vertices->InsertNextCell({static_cast<vtkIdType>(n + i)});
  data_->SetPoints(points);
  data_->SetLines(lines);
  data_->SetVerts(vertices);
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
