#pragma once
#include <Eigen/Core>
#include <QPoint>
#include <QString>
#include <filesystem>
#include <functional>

class QLabel;
class QTimer;
class QVTKOpenGLNativeWidget;
class QWidget;
class vtkGenericOpenGLRenderWindow;

namespace falciform {

// What every widget that shows a scene of VTK is made of.

/// A canvas of `parent`, which filters its events, that shows `window`.
[[nodiscard]] QVTKOpenGLNativeWidget* sceneCanvas(QWidget* parent, const char* name,
                                                  vtkGenericOpenGLRenderWindow* window);
/// A line of text below it for what lies under the mouse.
[[nodiscard]] QLabel* probeLine(QWidget* parent, const char* name, const QString& toolTip);

inline constexpr int kProbeAfterMs = 40;  ///< by then the mouse has slowed down
/// Calls `what` once, `delayMs` after the last start(): several changes in a row count as one.
[[nodiscard]] QTimer* onceTimer(QWidget* parent, int delayMs, std::function<void()> what);

/// True pixels of the render window, origin bottom left, of a place in the canvas, origin top left.
[[nodiscard]] Eigen::Vector2d windowPixel(const QWidget& canvas, const QPoint& place);
/// The reverse.
[[nodiscard]] QPoint canvasPlace(const QWidget& canvas, const Eigen::Vector2d& pixel);
/// Size of the canvas in true pixels, at least 1.
[[nodiscard]] Eigen::Vector2d pixelSize(const QWidget& canvas);

/// Takes the picture now; the function returned writes it as PNG, on any thread, replacing an old file.
[[nodiscard]] std::function<void(const std::filesystem::path&)> pictureOf(
    vtkGenericOpenGLRenderWindow* window);

}  // namespace falciform
