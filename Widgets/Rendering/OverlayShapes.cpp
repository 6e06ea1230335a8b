#include "Widgets/Rendering/OverlayShapes.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>

namespace falciform {

namespace {

void place(vtkActor2D* actor, const Anchor& anchor) {
  vtkNew<vtkCoordinate> corner;
  corner->SetCoordinateSystemToNormalizedViewport();
  corner->SetValue(anchor.x, anchor.y);
  actor->GetPositionCoordinate()->SetReferenceCoordinate(corner);
  actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  actor->GetPositionCoordinate()->SetValue(anchor.dx, anchor.dy);
  actor->SetPickable(false);
}

}  // namespace

vtkSmartPointer<vtkTextActor> textAt(const Anchor& anchor, const std::string& text, int px,
                                     const Vector3d& colour, AlignX x, AlignY y) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(px);
  property->SetColor(colour.x(), colour.y(), colour.z());
  property->SetJustification(x == AlignX::Left     ? VTK_TEXT_LEFT
                             : x == AlignX::Centre ? VTK_TEXT_CENTERED
                                                   : VTK_TEXT_RIGHT);
  property->SetVerticalJustification(y == AlignY::Bottom   ? VTK_TEXT_BOTTOM
                                     : y == AlignY::Centre ? VTK_TEXT_CENTERED
                                                           : VTK_TEXT_TOP);
  place(actor, anchor);
  return actor;
}

vtkSmartPointer<vtkActor2D> rectangleAt(const Anchor& anchor, double widthPx, double heightPx,
                                        const Vector3d& colour) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(widthPx, 0, 0);
  points->InsertNextPoint(widthPx, heightPx, 0);
  points->InsertNextPoint(0, heightPx, 0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
  place(actor, anchor);
  return actor;
}

}  // namespace falciform
