#include "Modules/CommandLine/CohortPictures.h"

#include <algorithm>
#include <cmath>

#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {

namespace {

const ViewMargins kMargins{0.04, 0.2, 0.1, 0.12};

RenderedImage mapTile(const std::string& title, const std::shared_ptr<const Surface>& surface,
                      const ScalarMap& colours) {
  const auto scene = titledScene(title);
  showMapped(*scene, surface, colours);
  return drawnTile(*scene, surface->points, directionOf(StandardView::Anterior), kMargins);
}

/// The pre-op liver with its patches, and the scan where the registration puts it.
RenderedImage registeredTile(const MeasuredCase& measured) {
  const std::string group = measured.group.empty() ? "" : " (" + measured.group + ")";
  const auto scene = titledScene(measured.name + group + ": scan as registered");
  scene->add<SurfacePresenter>().show(measured.own);
  auto cloud = std::make_shared<Surface>();
  const Points scan =
      transformed(measured.outcome.scan->points, measured.outcome.registration->scanFromPreop.inverse());
  const Index step = std::max<Index>(1, scan.rows() / 3000);
  cloud->points.resize((scan.rows() + step - 1) / step, 3);
  for (Index i = 0; i < cloud->points.rows(); ++i) cloud->points.row(i) = scan.row(i * step);
  SurfaceStyle style;
  style.colour = Vector3d(0.1, 0.1, 0.1);
  auto& presenter = scene->add<SurfacePresenter>();
  presenter.setStyle(style);
  presenter.show(cloud);
  return drawnTile(*scene, measured.own->points, directionOf(StandardView::Anterior), kMargins);
}

/// Symmetric about 0, with 98 % of all cases' values on it; the few beyond have its ends' darker shades.
ScalarMap commonRange(const CohortOutcome& outcome, const CohortMetricInfo& info) {
  std::vector<double> magnitudes;
  for (const MeasuredCase& measured : outcome.cases)
    for (const double value : measured.own->arrays.at(info.array))
      if (std::isfinite(value)) magnitudes.push_back(std::abs(value));
  Surface one;
  one.arrays[info.array] = VectorXd::Zero(1);
  if (!magnitudes.empty()) {
    const auto place =
        magnitudes.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(magnitudes.size() - 1));
    std::nth_element(magnitudes.begin(), place, magnitudes.end());
    one.arrays[info.array](0) = *place;
  }
  ScalarMap map = symmetricMap(info.array, info.title, info.unit, {&one});
  map.outOfRange = OutOfRange::Ends;
  return map;
}

}  // namespace

std::vector<std::string> cohortPictureNames(const std::vector<std::string>& cases) {
  std::vector<std::string> names{"overlap.png"};
  for (const std::string& name : cases) names.push_back(name + ".png");
  return names;
}

std::vector<PictureFile> saveCohortPictures(const CohortOutcome& outcome, const std::filesystem::path& folder,
                                            const Progress& progress) {
  const MeasuredCase& target = outcome.cases[outcome.target];
  const ScalarMap distance = commonRange(outcome, kCohortMetrics[0]),
                  curvature = commonRange(outcome, kCohortMetrics[1]);
  std::vector<PictureFile> pictures;

  auto shared = std::make_shared<Surface>(*target.own);
  VectorXd covering = VectorXd::Zero(shared->size());
  for (const MeasuredCase& measured : outcome.cases)
    covering.array() += measured.carried.values.col(0).array().isFinite().cast<double>();
  shared->arrays = {{"cases_covering", covering}};
  pictures.push_back({folder / "overlap.png", "On the target liver " + target.name +
                                                  ", how many cases cover each place; the overlap is where "
                                                  "all do."});
  const ScalarMap counted = {.array = "cases_covering",
                             .title = "Cases",
                             .unit = "",
                             .low = 0,
                             .high = static_cast<double>(outcome.cases.size()),
                             .palette = Palette::Sequential};
  savePng(sheetOf({mapTile("Coverage on " + target.name, shared, counted)}, 1), pictures.back().file,
          Overwrite::Replace);

  for (std::size_t i = 0; i < outcome.cases.size(); ++i) {
    const MeasuredCase& measured = outcome.cases[i];
    progress.report(static_cast<double>(i) / static_cast<double>(outcome.cases.size()),
                    "Drawing " + measured.name);
    auto carried = std::make_shared<Surface>(*target.own);
    carried->arrays = {{kSignedDistance, measured.carried.values.col(0)}};
    std::vector<RenderedImage> tiles{registeredTile(measured),
                                     mapTile("Signed distance", measured.own, distance),
                                     mapTile("Curvature difference", measured.own, curvature),
                                     mapTile("Distance on " + target.name, carried, distance)};
    pictures.push_back({folder / (measured.name + ".png"),
                        measured.name +
                            (measured.group.empty() ? ", of no group" : ", group " + measured.group) +
                            ": the scan as registered by patches; signed distance (positive where the scan "
                            "lies outside) and mean-curvature difference on its own liver; the distance on "
                            "the target liver."});
    savePng(sheetOf(tiles, 4), pictures.back().file, Overwrite::Replace);
  }
  return pictures;
}

}  // namespace falciform::commandline
