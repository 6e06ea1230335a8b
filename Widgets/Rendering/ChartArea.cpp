#include "Widgets/Rendering/ChartArea.h"

#include <vtkCallbackCommand.h>
#include <vtkChartLegend.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include "Widgets/Rendering/ScalarMap.h"

namespace falciform {

namespace {

void format(vtkTextProperty* text, int px, const Vector3d& colour, bool bold) {
  text->SetFontFamilyToArial();
  text->SetFontSize(px);
  text->SetBold(bold);
  text->SetColor(colour.x(), colour.y(), colour.z());
}

}  // namespace

ChartArea::ChartArea(vtkRenderer* renderer, int textPx, const Vector3d& textColour)
    : renderer_(renderer),
      actor_(vtkSmartPointer<vtkContextActor>::New()),
      chart_(vtkSmartPointer<vtkChartXY>::New()),
      textPx_(textPx) {
  chart_->SetAutoSize(false);
  format(chart_->GetTitleProperties(), textPx, textColour, true);
  for (const int side : {vtkAxis::LEFT, vtkAxis::BOTTOM, vtkAxis::RIGHT}) {
    vtkAxis* axis = chart_->GetAxis(side);
    format(axis->GetTitleProperties(), textPx, textColour, false);
    format(axis->GetLabelProperties(), textPx, textColour, false);
    axis->GetGridPen()->SetColor(225, 225, 225);
    axis->GetPen()->SetWidth(1);
    axis->SetGridVisible(side != vtkAxis::RIGHT);
  }
  format(chart_->GetLegend()->GetLabelProperties(), textPx, textColour, false);
  chart_->GetLegend()->SetLabelSize(textPx);
  chart_->GetLegend()->SetSymbolWidth(2 * textPx);
  chart_->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart_->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  chart_->SetShowLegend(true);
  chart_->SetHiddenAxisBorder(3 * textPx / 2);  // room for half a number beyond the last tick
  actor_->GetScene()->AddItem(chart_);
  renderer_->AddViewProp(actor_);
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<ChartArea*>(self)->fit(); });
  observer_ = renderer_->AddObserver(vtkCommand::StartEvent, command);
}

ChartArea::~ChartArea() {
  renderer_->RemoveObserver(observer_);
  renderer_->RemoveViewProp(actor_);
}

void ChartArea::fit() {
  const int* size = renderer_->GetSize();
  const auto foot = static_cast<float>(2.2 * textPx_);
  chart_->SetSize({0, foot, static_cast<float>(size[0]),
                   static_cast<float>(size[1]) - foot - 0.6f * static_cast<float>(textPx_)});
}

void ChartArea::setTitle(const std::string& title) { chart_->SetTitle(title); }

void ChartArea::setAxisTitle(int axis, const std::string& title) { chart_->GetAxis(axis)->SetTitle(title); }

void ChartArea::setRange(int axisSide, double low, double high) {
  vtkAxis* axis = chart_->GetAxis(axisSide);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(low, high);
  vtkNew<vtkDoubleArray> positions;
  for (const double tick : tickValues(low, high, axisSide == vtkAxis::BOTTOM ? 12 : 9))
    positions->InsertNextValue(tick);
  axis->SetCustomTickPositions(positions);
}

vtkPlot* ChartArea::addLine(const std::string& name, const std::vector<std::pair<double, double>>& points,
                            const Vector3d& colour, double widthPx, bool right) {
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("x");
  y->SetName(name.c_str());
  for (const auto& [px, py] : points) {
    x->InsertNextValue(px);
    y->InsertNextValue(py);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* plot = chart_->AddPlot(vtkChart::LINE);
  plot->SetInputData(table, 0, 1);
  plot->SetColor(colour.x(), colour.y(), colour.z());
  plot->SetWidth(static_cast<float>(widthPx));
  plot->SetLegendVisibility(!name.empty());
  if (right) chart_->SetPlotCorner(plot, 1);
  return plot;
}

}  // namespace falciform
