#include "Widgets/Rendering/ColourBarPresenter.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "Widgets/Rendering/OverlayShapes.h"

namespace falciform {

namespace {

// Shares of the viewport.
constexpr double kBottom = 0.36, kTop = 0.86, kLeft = 0.890, kRight = 0.915;
constexpr std::size_t kShortText = 4;

/// The bar as a strip of small cells; stretches with the window.
vtkSmartPointer<vtkActor2D> bar(const ScalarMap& map) {
  constexpr int kCells = 200;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (int i = 0; i <= kCells; ++i) {
    const double y = kBottom + (kTop - kBottom) * i / kCells;
    points->InsertNextPoint(kLeft, y, 0);
    points->InsertNextPoint(kRight, y, 0);
  }
  for (vtkIdType i = 0; i < kCells; ++i) {
    cells->InsertNextCell({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
    const Vector3d colour =
        colourOf(map, map.low + (map.high - map.low) * (static_cast<double>(i) + 0.5) / kCells) * 255;
    colours->InsertNextTuple3(std::round(colour.x()), std::round(colour.y()), std::round(colour.z()));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colours);
  vtkNew<vtkCoordinate> normalised;
  normalised->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  mapper->SetTransformCoordinate(normalised);
  mapper->SetColorModeToDirectScalars();
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->SetPickable(false);
  return actor;
}

/// "+5", "0", "-2.5": signed where the scale has both signs.
std::string tickText(double value, const ScalarMap& map) {
  char text[32];
  std::snprintf(text, sizeof text, map.low < 0 && value != 0 ? "%+g" : "%g", value);
  return text;
}

}  // namespace

ColourBarPresenter::ColourBarPresenter(vtkRenderer* renderer, int textPx, const Vector3d& textColour)
    : renderer_(renderer), textPx_(textPx), textColour_(textColour) {}

ColourBarPresenter::~ColourBarPresenter() { clear(); }

void ColourBarPresenter::show(const ScalarMap& map, bool swatches) {
  clear();
  keep(bar(map));
  for (const double value : tickValues(map.low, map.high)) {
    const double y = kBottom + (kTop - kBottom) * (value - map.low) / (map.high - map.low);
    keep(rectangleAt({kRight, y, 0, 0}, 0.3 * textPx_, 1, textColour_));
    const std::string text = tickText(value, map);
    // A long one, "-0.025", would not fit between the bar and the edge of a small view: it keeps to the edge.
    keep(
        text.size() <= kShortText
            ? textAt({kRight, y, 0.55 * textPx_, 0}, text, textPx_, textColour_, AlignX::Left, AlignY::Centre)
            : textAt({1, y, -0.1 * textPx_, 0}, text, textPx_, textColour_, AlignX::Right, AlignY::Centre));
  }
  const std::string unit = map.unit.empty() ? "" : " (" + map.unit + ")";
  const auto title =
      textAt({1, kTop, -0.7 * textPx_, 0.9 * textPx_}, map.title + unit, textPx_, textColour_, AlignX::Right);
  title->GetTextProperty()->SetBold(true);
  keep(title);
  if (!swatches) return;

  const auto swatch = [&](const Vector3d& colour, const char* text, double linesDown) {
    const double down = -linesDown * 1.6 * textPx_;
    keep(rectangleAt({1, kBottom, -8.2 * textPx_, down}, textPx_, textPx_, colour));
    keep(textAt({1, kBottom, -6.8 * textPx_, down + 0.5 * textPx_}, text, textPx_, textColour_, AlignX::Left,
                AlignY::Centre));
  };
  swatch(kNoValueColour, map.noValue.c_str(), 1.6);
  if (map.outOfRange == OutOfRange::Grey) {
    swatch(kOffScaleColour, "off the scale", 2.6);
  } else {
    swatch(colourOf(map, std::nextafter(map.high, HUGE_VAL)), "above", 2.6);
    swatch(colourOf(map, std::nextafter(map.low, -HUGE_VAL)), "below", 3.6);
  }
  if (map.threshold > 0) {
    char text[48];
    std::snprintf(text, sizeof text, "size < %g%s%s", map.threshold, map.unit.empty() ? "" : " ",
                  map.unit.c_str());
    swatch(kBelowThresholdColour, text, map.outOfRange == OutOfRange::Grey ? 3.6 : 4.6);
  }
}

void ColourBarPresenter::clear() {
  for (const auto& part : parts_) renderer_->RemoveViewProp(part);
  parts_.clear();
}

void ColourBarPresenter::keep(vtkSmartPointer<vtkProp> part) {
  renderer_->AddViewProp(part);
  parts_.push_back(std::move(part));
}

}  // namespace falciform
