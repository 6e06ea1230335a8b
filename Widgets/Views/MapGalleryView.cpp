#include "Widgets/Views/MapGalleryView.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "Widgets/Rendering/MapGalleryScene.h"
#include "Widgets/Rendering/NavigationInteractor.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Views/DataProbe.h"
#include "Widgets/Views/SceneCanvas.h"
#include "Widgets/Views/StandardViewBar.h"

namespace falciform {
namespace {

constexpr int kClickPx = 4;  // farther is a drag

}  // namespace

struct MapGalleryView::Parts {
  Parts(ViewState& state, int textPx) : view(state), scene(textPx) {}

  ViewState& view;
  MapGalleryScene scene;
  DataProbe probe;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<NavigationInteractor> style;
  QVTKOpenGLNativeWidget* canvas = nullptr;
  QToolButton* all = nullptr;
  QLabel* probeText = nullptr;
  QTimer *followTimer = nullptr, *probeTimer = nullptr;
  QPoint mouse, pressed;
  std::vector<MappedCase> fitted;  // what the camera was last placed for
  int fittedLarge = -1;
  bool fitWanted = true;
  Connection viewChanged;
};

MapGalleryView::MapGalleryView(ViewState& view, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(view, static_cast<int>(14 * devicePixelRatioF()))) {
  setObjectName("mapGallery");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* bar = new StandardViewBar(
      [this](std::optional<StandardView> turned) {
        const Eigen::Vector2d size = pixelSize(*parts_->canvas);
        parts_->scene.fit(size.x(), size.y(), turned);
        parts_->window->Render();
      },
      this);
  parts_->all = bar->addAtEnd("allCases", tr("All cases"), tr("Show all cases again instead of one (Esc)"));
  connect(parts_->all, &QToolButton::clicked, this, [this] { enlarge(-1); });
  column->addWidget(bar);

  parts_->canvas = sceneCanvas(this, "galleryCanvas", parts_->window);
  parts_->scene.attach(parts_->window);
  parts_->window->GetInteractor()->SetInteractorStyle(parts_->style);
  column->addWidget(parts_->canvas, 1);

  parts_->probeText =
      probeLine(this, "galleryProbe",
                tr("What lies under the mouse: case, value with its unit, patch, place in mm, vertex"));
  column->addWidget(parts_->probeText);

  parts_->followTimer = onceTimer(this, 0, [this] { follow(); });
  parts_->probeTimer = onceTimer(this, kProbeAfterMs, [this] { probe(); });
  parts_->viewChanged = view.changed.connect([this] { parts_->followTimer->start(); });
  parts_->followTimer->start();
}

MapGalleryView::~MapGalleryView() = default;

const MapGalleryScene& MapGalleryView::scene() const { return parts_->scene; }

QWidget* MapGalleryView::canvas() const { return parts_->canvas; }

void MapGalleryView::follow() {
  const ViewOptions& options = parts_->view.options();
  if (!options.galleryShown) return;
  MapGalleryScene& scene = parts_->scene;
  scene.show(options.mappedCases);
  scene.setColours(options.distanceColours, options.distanceOnScan,
                   metricOf(options.distanceColours.array, options.distanceOnScan).meaning);
  scene.enlarge(options.enlargedCase >= 0 ? std::optional<int>(options.enlargedCase) : std::nullopt);
  parts_->all->setVisible(scene.enlarged().has_value());
  const int large = scene.enlarged().value_or(-1);
  if (parts_->fitted != options.mappedCases || parts_->fittedLarge != large) parts_->fitWanted = true;
  parts_->fitted = options.mappedCases;
  parts_->fittedLarge = large;
  if (parts_->fitWanted && parts_->canvas->isVisible())
    fit();
  else
    parts_->window->Render();
}

void MapGalleryView::fit() {
  parts_->fitWanted = false;
  const Eigen::Vector2d size = pixelSize(*parts_->canvas);
  parts_->scene.fit(size.x(), size.y());
  parts_->window->Render();
}

std::function<void(const std::filesystem::path&)> MapGalleryView::picture() {
  follow();
  return pictureOf(parts_->window);
}

void MapGalleryView::enlarge(int tile) {
  parts_->view.edit([&](ViewOptions& options) { options.enlargedCase = tile; });
}

QPoint MapGalleryView::canvasPosition(int tile, const Vector3d& pointInMap) const {
  const Vector3d place = parts_->scene.surface(tile).sceneFromSurface() * pointInMap;
  return canvasPlace(*parts_->canvas, screenPosition(parts_->scene.renderer(tile), place));
}

int MapGalleryView::tileAt(const QPoint& place) const {
  const Eigen::Vector2d pixel = windowPixel(*parts_->canvas, place);
  return parts_->scene.tileAt(pixel.x(), pixel.y());
}

bool MapGalleryView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != parts_->canvas) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseMove: {
      const auto* move = static_cast<QMouseEvent*>(event);
      parts_->mouse = move->pos();
      if (move->buttons() == Qt::NoButton) parts_->probeTimer->start();
      break;
    }
    case QEvent::MouseButtonPress:
      parts_->pressed = static_cast<QMouseEvent*>(event)->pos();
      break;
    case QEvent::MouseButtonRelease: {
      const auto* release = static_cast<QMouseEvent*>(event);
      const bool click = release->button() == Qt::LeftButton &&
                         (release->pos() - parts_->pressed).manhattanLength() <= kClickPx;
      if (click && parts_->view.options().enlargedCase < 0 && tileAt(release->pos()) >= 0)
        enlarge(tileAt(release->pos()));
      break;
    }
    case QEvent::KeyPress:
      if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) enlarge(-1);
      break;
    case QEvent::Leave:
      parts_->probeTimer->stop();
      parts_->probeText->clear();
      break;
    case QEvent::Show:
    case QEvent::Resize:
      parts_->fitWanted = true;  // the tiles' shape follows the window's
      parts_->followTimer->start();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void MapGalleryView::probe() {
  const int tile = tileAt(parts_->mouse);
  if (tile < 0) return parts_->probeText->clear();
  const SurfacePresenter& presenter = parts_->scene.surface(tile);
  const MappedCase& mapped = parts_->scene.mappedCase(tile);
  Isometry3d lpsFromMap;
  lpsFromMap.matrix() = mapped.lpsFromMap;
  const ShownSurface shown{"case " + std::to_string(tile), mapped.name,           presenter.surface(),
                           presenter.sceneFromSurface(),   presenter.scalarMap(), lpsFromMap};
  const Eigen::Vector2d pixel = windowPixel(*parts_->canvas, parts_->mouse);
  parts_->probeText->setText(
      QString::fromStdString(parts_->probe.at(parts_->scene.renderer(tile), {shown}, pixel.x(), pixel.y())));
}

}  // namespace falciform
