#include "Widgets/Views/SceneCanvas.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <QLabel>
#include <QTimer>
#include <cmath>
#include <memory>

#include "Widgets/Rendering/RenderedImage.h"

namespace falciform {

QVTKOpenGLNativeWidget* sceneCanvas(QWidget* parent, const char* name, vtkGenericOpenGLRenderWindow* window) {
  auto* canvas = new QVTKOpenGLNativeWidget(parent);
  canvas->setObjectName(name);
  // The scene's texts are laid out in true pixels; VTK is not to enlarge them a second time on a dense
  // screen.
  canvas->setUnscaledDPI(static_cast<int>(std::lround(72 / parent->devicePixelRatioF())));
  canvas->setRenderWindow(window);
  canvas->setFocusPolicy(Qt::StrongFocus);
  canvas->setMinimumSize(320, 240);
  canvas->installEventFilter(parent);
  return canvas;
}

QLabel* probeLine(QWidget* parent, const char* name, const QString& toolTip) {
  auto* line = new QLabel(parent);
  line->setObjectName(name);
  line->setContentsMargins(6, 2, 6, 2);
  line->setToolTip(toolTip);
  line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return line;
}

QTimer* onceTimer(QWidget* parent, int delayMs, std::function<void()> what) {
  auto* timer = new QTimer(parent);
  timer->setSingleShot(true);
  timer->setInterval(delayMs);
  QObject::connect(timer, &QTimer::timeout, parent, std::move(what));
  return timer;
}

Eigen::Vector2d windowPixel(const QWidget& canvas, const QPoint& place) {
  const double ratio = canvas.devicePixelRatioF();
  return {place.x() * ratio, (canvas.height() - 1 - place.y()) * ratio};
}

QPoint canvasPlace(const QWidget& canvas, const Eigen::Vector2d& pixel) {
  const double ratio = canvas.devicePixelRatioF();
  return {static_cast<int>(std::lround(pixel.x() / ratio)),
          static_cast<int>(std::lround(canvas.height() - 1 - pixel.y() / ratio))};
}

Eigen::Vector2d pixelSize(const QWidget& canvas) {
  const double ratio = canvas.devicePixelRatioF();
  return Eigen::Vector2d(canvas.width() * ratio, canvas.height() * ratio).cwiseMax(1.0);
}

std::function<void(const std::filesystem::path&)> pictureOf(vtkGenericOpenGLRenderWindow* window) {
  auto image = std::make_shared<const RenderedImage>(falciform::grab(window));
  return [image](const std::filesystem::path& file) { savePng(*image, file, Overwrite::Replace); };
}

}  // namespace falciform
