#include "Modules/CommandLine/DistancePicture.h"

#include <algorithm>
#include <limits>

#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/OrientationCubePresenter.h"
#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {
namespace {

const ViewMargins kMargins{0.04, 0.2, 0.12, 0.1};

/// Tiles of one liver from one side.
class DistanceTiles {
 public:
  DistanceTiles(const DistanceMap& map, const Isometry3d& scanFromPreop)
      : surface_(std::make_shared<const Surface>(map.preop)),
        pose_(scanFromPreop),
        view_(viewOfScan(map.scan, map.preop.points, scanFromPreop)) {}

  /// `values` of the vertices, coloured by `colours`.
  [[nodiscard]] RenderedImage mapped(const std::string& title, const ScalarMap& colours,
                                     const VectorXd& values) const {
    auto surface = std::make_shared<Surface>(*surface_);
    surface->arrays[colours.array] = values;
    const auto made = scene(title);
    showMapped(*made, surface, colours);
    return drawnTile(*made, surface_->points, view_, kMargins);
  }

 private:
  [[nodiscard]] std::unique_ptr<Scene> scene(const std::string& title) const {
    auto made = titledScene(title);
    made->orientation().setSceneFromLps(pose_.linear());
    return made;
  }

  std::shared_ptr<const Surface> surface_;
  Isometry3d pose_;
  ViewDirection view_;
};

}  // namespace

void saveDistanceSheet(const DistanceMap& map, const Isometry3d& scanFromPreop,
                       const std::filesystem::path& file, Overwrite overwrite) {
  const DistanceTiles tiles(map, scanFromPreop);
  const auto& arrays = map.preop.arrays;
  std::vector<RenderedImage> row{
      tiles.mapped("Signed distance to the scan",
                   symmetricMap(kSignedDistance, "Signed distance", "mm", {&map.preop, &map.scan}),
                   arrays.at(kSignedDistance))};
  if (const auto found = arrays.find(kCurvatureDifference); found != arrays.end()) {
    ScalarMap colours;
    colours.array = "curvature";
    colours.title = "Curvature difference";
    colours.unit = "0.001/mm";  // as 0.06/mm the bar's numbers would not fit
    const VectorXd values = 1000 * found->second;
    colours.high = symmetricEnd(values, 0.95);  // a few at the edges would flatten all others
    colours.low = -colours.high;
    colours.outOfRange = OutOfRange::Ends;
    row.push_back(tiles.mapped("Mean curvature: scan less pre-op", colours, values));
  }
  if (const auto found = arrays.find(kCouinaudSegment); found != arrays.end()) {
    ScalarMap colours;
    colours.array = "segment";
    colours.title = "Couinaud segment";
    colours.low = 1;
    colours.high = std::max(8.0, found->second.array().isNaN().select(0, found->second.array()).maxCoeff());
    colours.palette = Palette::Sequential;
    const VectorXd values =
        (found->second.array() > 0).select(found->second.array(), std::numeric_limits<double>::quiet_NaN());
    row.push_back(tiles.mapped("Couinaud segments", colours, values));
  }
  savePng(sheetOf(row, static_cast<int>(row.size())), file, overwrite);
}

}  // namespace falciform::commandline
