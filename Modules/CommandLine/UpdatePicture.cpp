#include "Modules/CommandLine/UpdatePicture.h"

#include <memory>

#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/PictureScenes.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform::commandline {
namespace {

const ViewMargins kMargins{0.04, 0.2, 0.12, 0.04};

void addScan(Scene& scene, const Surface& scan) {
  auto cloud = std::make_shared<Surface>();  // thinned, and lifted off nothing: points alone
  const Index step = std::max<Index>(1, scan.size() / 4000);
  cloud->points.resize((scan.size() + step - 1) / step, 3);
  for (Index i = 0; i < cloud->points.rows(); ++i) cloud->points.row(i) = scan.points.row(i * step);
  SurfaceStyle style;
  style.colour = Vector3d(0.1, 0.1, 0.1);
  auto& presenter = scene.add<SurfacePresenter>();
  presenter.setStyle(style);
  presenter.show(cloud);
}

RenderedImage mapTile(const std::string& title, const std::shared_ptr<const Surface>& surface,
                      const ScalarMap& map, const Surface* scan, const Points& within,
                      const ViewDirection& view) {
  const auto scene = titledScene(title);
  auto& presenter = scene->add<SurfacePresenter>();
  presenter.show(surface);
  presenter.setScalarMap(map);
  if (scan != nullptr) addScan(*scene, *scan);
  scene->add<ColourBarPresenter>(scene->style().textPx, scene->style().text).show(map);
  return drawnTile(*scene, within, view, kMargins);
}

}  // namespace

void saveUpdatePicture(const Surface& preop, const Surface& updated, const Surface& scan,
                       const Isometry3d& scanFromPreopRigid, const std::filesystem::path& file,
                       Overwrite overwrite) {
  const auto rigid = std::make_shared<const Surface>(transformed(preop, scanFromPreopRigid, scan.frame));
  const auto moved = std::make_shared<const Surface>(updated);
  const ViewDirection view = viewOfScan(scan, rigid->points, scanFromPreopRigid);
  Points within(rigid->size() + moved->size(), 3);
  within << rigid->points, moved->points;
  const auto before = titledScene("Rigid registration, scan as points");
  before->add<SurfacePresenter>().show(rigid);
  addScan(*before, scan);
  std::vector<RenderedImage> tiles{drawnTile(*before, within, view, kMargins)};
  const VectorXd& displacement = updated.arrays.at("displacement_mm");
  const VectorXd& expected = updated.arrays.at("expected_error_mm");
  tiles.push_back(mapTile("Model update", moved,
                          magnitudeMap("displacement_mm", "Displacement", "mm", displacement.maxCoeff()),
                          &scan, within, view));
  tiles.push_back(mapTile("Expected error", moved,
                          magnitudeMap("expected_error_mm", "Expected error", "mm", expected.maxCoeff()),
                          nullptr, within, view));
  savePng(sheetOf(tiles, 3), file, overwrite);
}

}  // namespace falciform::commandline
