#include "Widgets/Rendering/MapGalleryScene.h"

#include <vtkCamera.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "Version.h"

namespace falciform {

namespace {

constexpr double kTileAspect = 4.0 / 3.0;
constexpr double kTextLines = 2.2;                 // of title above and notice below the tiles
constexpr double kCaptionLines = 3;                // of a tile
constexpr double kBarPx = 11.5, kLeastBar = 0.14;  // texts that the bar takes; the cube's share

/// The liver's middle at the origin, the patient upright.
Isometry3d sceneFromMap(const MappedCase& one) {
  Isometry3d motion;
  motion.matrix() = one.lpsFromMap;
  const Surface& around = one.map->preop.size() > 0 ? one.map->preop : one.map->scan;
  if (around.size() == 0) return motion;
  const Points upright = transformed(around.points, motion);
  const Vector3d middle = (upright.colwise().minCoeff() + upright.colwise().maxCoeff()).transpose() / 2;
  return Eigen::Translation3d(-middle) * motion;
}

}  // namespace

TileGrid tileGrid(int tiles, double width, double height, double caption) {
  TileGrid best;
  double largest = -std::numeric_limits<double>::infinity();
  for (int columns = 1; columns <= tiles; ++columns) {
    const int rows = (tiles + columns - 1) / columns;
    const double size = std::min(width / columns / kTileAspect, height / rows - caption);
    if (size > largest) {
      largest = size;
      best = {columns, rows};
    }
  }
  return best;
}

struct MapGalleryScene::Tile {
  Tile(MappedCase shown, vtkCamera* camera, int textPx, const SceneStyle& style)
      : mapped(std::move(shown)),
        renderer(vtkSmartPointer<vtkRenderer>::New()),
        surface(renderer),
        text(renderer, TextPlace::TopLeft, textPx, style.text) {
    renderer->SetLayer(1);  // above the background that all share
    renderer->SetActiveCamera(camera);
    lightLikePaper(renderer);
    surface.setSceneFromSurface(sceneFromMap(mapped));
  }

  MappedCase mapped;
  vtkSmartPointer<vtkRenderer> renderer;
  SurfacePresenter surface;
  TextPresenter text;
  std::string caption;
};

MapGalleryScene::MapGalleryScene(int textPx)
    : textPx_(textPx),
      style_(screenStyle(textPx)),
      behind_(vtkSmartPointer<vtkRenderer>::New()),
      above_(vtkSmartPointer<vtkRenderer>::New()) {
  behind_->SetBackground(style_.background.data());
  behind_->SetBackground2(style_.backgroundTop.data());
  behind_->SetGradientBackground(true);
  behind_->InteractiveOff();
  above_->SetLayer(2);
  above_->InteractiveOff();
  bar_ = std::make_unique<ColourBarPresenter>(above_, textPx, style_.text);
  title_ = std::make_unique<TextPresenter>(above_, TextPlace::TopCentre, textPx, style_.text);
  notice_ = std::make_unique<TextPresenter>(above_, TextPlace::BottomLeft, textPx, style_.text);
  notice_->setText(kResearchUse);
  cube_ = std::make_unique<OrientationCubePresenter>(behind_);
  // The mouse turns the camera by way of one tile, whose liver may be smaller than the others'.
  vtkNew<vtkCallbackCommand> start;
  start->SetClientData(this);
  start->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    auto* scene = static_cast<MapGalleryScene*>(self);
    double all[6] = {1e300, -1e300, 1e300, -1e300, 1e300, -1e300};
    for (const auto& tile : scene->tiles_) {
      double one[6];
      tile->renderer->ComputeVisiblePropBounds(one);
      if (one[0] > one[1]) continue;
      for (int k = 0; k < 6; k += 2) {
        all[k] = std::min(all[k], one[k]);
        all[k + 1] = std::max(all[k + 1], one[k + 1]);
      }
    }
    if (all[0] <= all[1]) scene->behind_->ResetCameraClippingRange(all);
  });
  behind_->AddObserver(vtkCommand::StartEvent, start);
}

MapGalleryScene::~MapGalleryScene() {
  if (!window_) return;
  for (const auto& tile : tiles_) window_->RemoveRenderer(tile->renderer);
  for (vtkRenderer* one : {behind_.Get(), cube_->renderer(), above_.Get()}) window_->RemoveRenderer(one);
}

void MapGalleryScene::attach(vtkRenderWindow* window) {
  window_ = window;
  window->SetNumberOfLayers(3);
  window->SetMultiSamples(0);
  for (vtkRenderer* one : {behind_.Get(), cube_->renderer(), above_.Get()}) window->AddRenderer(one);
  for (const auto& tile : tiles_) window->AddRenderer(tile->renderer);
}

void MapGalleryScene::show(const std::vector<MappedCase>& cases) {
  const bool same = std::equal(cases.begin(), cases.end(), tiles_.begin(), tiles_.end(),
                               [](const MappedCase& one, const auto& tile) { return one == tile->mapped; });
  if (same) return;
  if (window_)
    for (const auto& tile : tiles_) window_->RemoveRenderer(tile->renderer);
  tiles_.clear();
  for (const MappedCase& one : cases) {
    tiles_.push_back(std::make_unique<Tile>(one, behind_->GetActiveCamera(), textPx_, style_));
    if (window_) window_->AddRenderer(tiles_.back()->renderer);
  }
  enlarged_.reset();
}

void MapGalleryScene::setColours(const ScalarMap& colours, bool onScan, const std::string& meaning) {
  colours_ = colours;
  onScan_ = onScan;
  for (const auto& tile : tiles_) {
    const auto& map = tile->mapped.map;
    const std::shared_ptr<const Surface> side(map, &sideOf(*map, onScan));
    tile->surface.setScalarMap(colours);
    if (tile->surface.surface() != side) tile->surface.show(side);
  }
  title_->setText(meaning);
  if (tiles_.empty())
    bar_->clear();
  else
    bar_->show(colours);
  captionAll();
}

void MapGalleryScene::captionAll() {
  for (const auto& tile : tiles_) {
    const VectorXd values = valuesOf(*tile->mapped.map, colours_.array, onScan_);
    double sum = 0;
    Index count = 0;
    for (const double value : values)
      if (std::isfinite(value)) {
        sum += value;
        ++count;
      }
    char text[64];
    if (values.size() == 0)
      std::snprintf(text, sizeof text, "not measured");
    else if (count == 0)
      std::snprintf(text, sizeof text, "not covered");
    else
      std::snprintf(text, sizeof text, colours_.unit == "mm" ? "mean %+.2f %s" : "mean %+.2g %s",
                    sum / static_cast<double>(count), colours_.unit.c_str());
    tile->caption = tile->mapped.name + "\n" + text;
    tile->text.setText(tile->caption);
  }
}

void MapGalleryScene::enlarge(std::optional<int> tile) {
  enlarged_ = tile && *tile >= 0 && *tile < count() ? tile : std::nullopt;
}

void MapGalleryScene::arrange(double widthPx, double heightPx) {
  const double right = 1 - std::clamp(kBarPx * textPx_ / widthPx, kLeastBar, 0.4);
  const double band = std::min(0.15, kTextLines * textPx_ / heightPx);
  const double bottom = band, top = 1 - band;
  const TileGrid grid =
      enlarged_ ? TileGrid{}
                : tileGrid(count(), right * widthPx, (top - bottom) * heightPx, kCaptionLines * textPx_);
  for (int i = 0; i < count(); ++i) {
    vtkRenderer* renderer = tiles_[static_cast<std::size_t>(i)]->renderer;
    const bool drawn = !enlarged_ || *enlarged_ == i;
    renderer->SetDraw(drawn);
    renderer->SetInteractive(drawn);
    const int at = enlarged_ ? 0 : i;
    const double x = right / grid.columns, y = (top - bottom) / grid.rows;
    const int column = at % grid.columns, row = at / grid.columns;
    renderer->SetViewport(column * x, top - (row + 1) * y, (column + 1) * x, top - row * y);
  }
}

Points MapGalleryScene::shownPoints() const {
  Index count = 0, row = 0;
  const auto drawn = [](const auto& tile) { return tile->renderer->GetDraw() && tile->surface.surface(); };
  for (const auto& tile : tiles_)
    if (drawn(tile)) count += tile->surface.surface()->size();
  Points all(count, 3);
  for (const auto& tile : tiles_) {
    if (!drawn(tile)) continue;
    const Points& points = tile->surface.surface()->points;
    all.middleRows(row, points.rows()) = transformed(points, tile->surface.sceneFromSurface());
    row += points.rows();
  }
  return all;
}

void MapGalleryScene::fit(double widthPx, double heightPx, std::optional<StandardView> view) {
  width_ = widthPx;
  height_ = heightPx;
  arrange(widthPx, heightPx);
  const auto first = std::find_if(tiles_.begin(), tiles_.end(),
                                  [](const auto& tile) { return tile->renderer->GetDraw() != 0; });
  if (first == tiles_.end()) return;
  ViewDirection direction = directionOf(view.value_or(StandardView::Anterior));
  if (directed_ && !view) {
    Vector3d back;
    camera()->GetDirectionOfProjection(back.data());
    camera()->GetViewUp(direction.up.data());
    direction.from = -back;
  }
  directed_ = true;
  const double* port = (*first)->renderer->GetViewport();
  const double tileWidth = (port[2] - port[0]) * widthPx, tileHeight = (port[3] - port[1]) * heightPx;
  ViewMargins margins;
  margins.top = std::min(0.4, kCaptionLines * textPx_ / tileHeight);
  margins.bottom = 0.02;
  fitView((*first)->renderer, shownPoints(), direction, tileWidth / tileHeight, margins);
}

int MapGalleryScene::tileAt(double x, double y) const {
  for (int i = 0; i < count(); ++i) {
    vtkRenderer* tile = renderer(i);
    if (!tile->GetDraw()) continue;
    const double* port = tile->GetViewport();
    if (x >= port[0] * width_ && x < port[2] * width_ && y >= port[1] * height_ && y < port[3] * height_)
      return i;
  }
  return -1;
}

vtkRenderer* MapGalleryScene::renderer(int tile) const {
  return tiles_.at(static_cast<std::size_t>(tile))->renderer;
}

const SurfacePresenter& MapGalleryScene::surface(int tile) const {
  return tiles_.at(static_cast<std::size_t>(tile))->surface;
}

const MappedCase& MapGalleryScene::mappedCase(int tile) const {
  return tiles_.at(static_cast<std::size_t>(tile))->mapped;
}

std::string MapGalleryScene::caption(int tile) const {
  return tiles_.at(static_cast<std::size_t>(tile))->caption;
}

vtkCamera* MapGalleryScene::camera() const { return behind_->GetActiveCamera(); }

}  // namespace falciform
