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
#include <cmath>

#include "Widgets/Rendering/MapGalleryScene.h"
#include "Widgets/Rendering/NavigationInteractor.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Rendering/RenderedImage.h"
#include "Widgets/Views/DataProbe.h"
#include "Widgets/Views/StandardViewBar.h"

namespace falciform {
namespace {

constexpr int kProbeAfterMs = 40;  // the mouse has slowed down
constexpr int kClickPx = 4;        // farther is a drag

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
        const double ratio = parts_->canvas->devicePixelRatioF();
        parts_->scene.fit(std::max(1.0, parts_->canvas->width() * ratio),
                          std::max(1.0, parts_->canvas->height() * ratio), turned);
        parts_->window->Render();
      },
      this);
  parts_->all = bar->addAtEnd("allCases", tr("All cases"), tr("Show all cases again instead of one (Esc)"));
  connect(parts_->all, &QToolButton::clicked, this, [this] { enlarge(-1); });
  column->addWidget(bar);

  parts_->canvas = new QVTKOpenGLNativeWidget(this);
  parts_->canvas->setObjectName("galleryCanvas");
  // The texts are laid out in true pixels; VTK is not to enlarge them a second time on a dense screen.
  parts_->canvas->setUnscaledDPI(static_cast<int>(std::lround(72 / devicePixelRatioF())));
  parts_->canvas->setRenderWindow(parts_->window);
  parts_->canvas->setFocusPolicy(Qt::StrongFocus);
  parts_->canvas->setMinimumSize(320, 240);
  parts_->canvas->installEventFilter(this);
  parts_->scene.attach(parts_->window);
  parts_->window->GetInteractor()->SetInteractorStyle(parts_->style);
  column->addWidget(parts_->canvas, 1);

  parts_->probeText = new QLabel(this);
  parts_->probeText->setObjectName("galleryProbe");
  parts_->probeText->setContentsMargins(6, 2, 6, 2);
  parts_->probeText->setToolTip(
      tr("What lies under the mouse: case, value with its unit, patch, place in mm, vertex"));
  parts_->probeText->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  column->addWidget(parts_->probeText);

  parts_->followTimer = new QTimer(this);
  parts_->followTimer->setSingleShot(true);
  connect(parts_->followTimer, &QTimer::timeout, this, &MapGalleryView::follow);
  parts_->probeTimer = new QTimer(this);
  parts_->probeTimer->setSingleShot(true);
  parts_->probeTimer->setInterval(kProbeAfterMs);
  connect(parts_->probeTimer, &QTimer::timeout, this, &MapGalleryView::probe);
  parts_->viewChanged = view.changed.connect([this] { parts_->followTimer->start(0); });
  parts_->followTimer->start(0);
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
  const double ratio = parts_->canvas->devicePixelRatioF();
  parts_->scene.fit(std::max(1.0, parts_->canvas->width() * ratio),
                    std::max(1.0, parts_->canvas->height() * ratio));
  parts_->window->Render();
}

std::function<void(const std::filesystem::path&)> MapGalleryView::picture() {
  follow();
  auto image = std::make_shared<const RenderedImage>(falciform::grab(parts_->window));
  return [image](const std::filesystem::path& file) { savePng(*image, file, Overwrite::Replace); };
}

void MapGalleryView::enlarge(int tile) {
  parts_->view.edit([&](ViewOptions& options) { options.enlargedCase = tile; });
}

QPoint MapGalleryView::canvasPosition(int tile, const Vector3d& pointInMap) const {
  const Vector3d place = parts_->scene.surface(tile).sceneFromSurface() * pointInMap;
  const Eigen::Vector2d pixel = screenPosition(parts_->scene.renderer(tile), place);
  const double ratio = parts_->canvas->devicePixelRatioF();
  return {static_cast<int>(std::lround(pixel.x() / ratio)),
          static_cast<int>(std::lround(parts_->canvas->height() - 1 - pixel.y() / ratio))};
}

int MapGalleryView::tileAt(const QPoint& canvasPlace) const {
  const double ratio = parts_->canvas->devicePixelRatioF();
  return parts_->scene.tileAt(canvasPlace.x() * ratio,
                              (parts_->canvas->height() - 1 - canvasPlace.y()) * ratio);
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
      parts_->followTimer->start(0);
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
  const double ratio = parts_->canvas->devicePixelRatioF();
  const double x = parts_->mouse.x() * ratio, y = (parts_->canvas->height() - 1 - parts_->mouse.y()) * ratio;
  parts_->probeText->setText(
      QString::fromStdString(parts_->probe.at(parts_->scene.renderer(tile), {shown}, x, y)));
}

}  // namespace falciform
