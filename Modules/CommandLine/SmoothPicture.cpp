#include "Modules/CommandLine/SmoothPicture.h"

#include "Logic/Geometry/Curvature.h"
#include "Logic/Geometry/ScannerSide.h"

namespace falciform::commandline {
namespace {

const ViewMargins kMargins{0.04, 0.2, 0.12, 0.1};
constexpr char kShown[] = "curvature";

RenderedImage tile(const std::string& title, const Surface& surface, const VectorXd& curvature,
                   const Points& within, const ViewDirection& view, double end) {
  auto shown = std::make_shared<Surface>(surface);
  shown->arrays[kShown] = 1000 * curvature;
  ScalarMap colours;
  colours.array = kShown;
  colours.title = "Mean curvature";
  colours.unit = "0.001/mm";
  colours.high = end;
  colours.low = -end;
  colours.outOfRange = OutOfRange::Ends;
  const auto scene = titledScene(title);
  showMapped(*scene, shown, colours);
  return drawnTile(*scene, within, view, kMargins);
}

}  // namespace

RenderedImage smoothPicture(const Surface& before, const Surface& after) {
  const VectorXd& smooth = after.arrays.at(kMeanCurvature);
  const double end = symmetricEnd(1000 * smooth, 0.98);  // a few at the edges would flatten all others
  // A closed liver is looked at from the front; a scan from where it was scanned.
  ViewDirection view = directionOf(StandardView::Anterior);
  if (before.frame != "LPS") {
    view.from = seenFrom(before);
    view.up = view.from.unitOrthogonal();
  }
  return sheetOf({tile("Before", before, meanCurvature(before), before.points, view, end),
                  tile("Smoothed by radial basis functions", after, smooth, before.points, view, end)},
                 2);
}

}  // namespace falciform::commandline
