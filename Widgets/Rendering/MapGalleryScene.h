#pragma once
#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/MappedCase.h"
#include "Widgets/Rendering/OrientationCubePresenter.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"
#include "Widgets/Rendering/TextPresenter.h"

namespace falciform {

/// How many columns and rows make pictures of 4:3, below a caption each, largest in a place of this size.
struct TileGrid {
  int columns = 1, rows = 1;
};
[[nodiscard]] TileGrid tileGrid(int tiles, double width, double height, double caption = 0);

/// Several cases' maps as tiles of one picture: seen by one camera, coloured by one scale. Each liver stands
/// with its middle at the origin, upright as its patient, so that one direction is the same for all. One tile
/// can be shown large. Shows itself in one render window.
class MapGalleryScene {
 public:
  explicit MapGalleryScene(int textPx);
  ~MapGalleryScene();
  MapGalleryScene(const MapGalleryScene&) = delete;
  MapGalleryScene& operator=(const MapGalleryScene&) = delete;

  void attach(vtkRenderWindow* window);

  /// Replaces the tiles where they are others than before.
  void show(const std::vector<MappedCase>& cases);
  /// One scale for all; a case without the array is grey, and its caption says so.
  void setColours(const ScalarMap& colours, bool onScan, const std::string& meaning);
  /// Only this one, or all again.
  void enlarge(std::optional<int> tile);
  [[nodiscard]] std::optional<int> enlarged() const { return enlarged_; }

  /// Places tiles and camera for a window of this size; the direction stays, or is that given.
  void fit(double widthPx, double heightPx, std::optional<StandardView> view = {});

  /// The tile at a pixel, origin bottom left, or -1.
  [[nodiscard]] int tileAt(double x, double y) const;
  [[nodiscard]] int count() const { return static_cast<int>(tiles_.size()); }
  [[nodiscard]] vtkRenderer* renderer(int tile) const;
  [[nodiscard]] const SurfacePresenter& surface(int tile) const;
  [[nodiscard]] const MappedCase& mappedCase(int tile) const;
  [[nodiscard]] std::string caption(int tile) const;
  [[nodiscard]] vtkCamera* camera() const;

 private:
  struct Tile;

  void arrange(double widthPx, double heightPx);
  void captionAll();
  [[nodiscard]] Points shownPoints() const;

  int textPx_;
  SceneStyle style_;
  vtkSmartPointer<vtkRenderWindow> window_;
  vtkSmartPointer<vtkRenderer> behind_, above_;
  std::vector<std::unique_ptr<Tile>> tiles_;
  std::unique_ptr<ColourBarPresenter> bar_;
  std::unique_ptr<TextPresenter> title_, notice_;
  std::unique_ptr<OrientationCubePresenter> cube_;
  ScalarMap colours_;
  bool onScan_ = false, directed_ = false;
  std::optional<int> enlarged_;
  double width_ = 1, height_ = 1;
};

}  // namespace falciform
