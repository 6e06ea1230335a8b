#pragma once
#include <QWidget>
#include <filesystem>
#include <functional>
#include <memory>

#include "Widgets/Views/ViewState.h"

namespace falciform {

class MapGalleryScene;

/// Several cases' maps beside each other, as ViewState says: one camera, one scale. A click on a tile shows
/// it large, Esc shows all again; the line below tells the value under the mouse. Needs OpenGL.
class MapGalleryView : public QWidget {
  Q_OBJECT

 public:
  explicit MapGalleryView(ViewState& view, QWidget* parent = nullptr);
  ~MapGalleryView() override;

  /// Takes the picture now; the function returned writes it as PNG, on any thread, replacing an old file.
  [[nodiscard]] std::function<void(const std::filesystem::path&)> picture();
  void fit();

  [[nodiscard]] const MapGalleryScene& scene() const;
  [[nodiscard]] QWidget* canvas() const;
  /// Where a place of a case, in its map's own frame, is drawn in the canvas.
  [[nodiscard]] QPoint canvasPosition(int tile, const Vector3d& pointInMap) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow();
  void enlarge(int tile);
  void probe();
  [[nodiscard]] int tileAt(const QPoint& place) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace falciform
