#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Widgets/Rendering/PatchColours.h"
#include "Widgets/Rendering/ScalarMap.h"
#include "Widgets/Rendering/TextureOverlay.h"

namespace falciform {

/// How a surface looks. Colours are red, green, blue in [0, 1].
struct SurfaceStyle {
  Vector3d colour = kLiverColour;
  double opacity = 1;  ///< in [0, 1]
  bool visible = true;
  bool edges = false;      ///< triangle edges
  bool frontOnly = false;  ///< leaves out triangles that face away: a see-through surface looks less busy
  bool ownColours = true;  ///< the scan's photograph or RGB where it has one
  bool patches = true;     ///< painted points in their patch's colour
  std::map<int, Vector3d> patchColours = {};  ///< in place of patchColour(label)
  std::set<int> hiddenPatches = {};           ///< drawn as if they were not painted
  int pointPx = 4;                            ///< size of a cloud's points

  bool operator==(const SurfaceStyle&) const = default;
};

/// Draws one surface or cloud: plain, in its own colours, with its patches, or by an analysis array.
class SurfacePresenter {
 public:
  explicit SurfacePresenter(vtkRenderer* renderer);
  ~SurfacePresenter();
  SurfacePresenter(const SurfacePresenter&) = delete;
  SurfacePresenter& operator=(const SurfacePresenter&) = delete;

  /// nullptr empties the view. Same points and triangles as before: only the colours are drawn anew; same
  /// triangles: it moves, which is quicker than another surface.
  void show(std::shared_ptr<const Surface> surface);
  [[nodiscard]] const std::shared_ptr<const Surface>& surface() const { return surface_; }

  void setStyle(const SurfaceStyle& style);
  [[nodiscard]] const SurfaceStyle& style() const { return style_; }

  /// Colours by an array instead of patches; none: back to patches. Points without the array count as no
  /// value.
  void setScalarMap(const std::optional<ScalarMap>& map);
  [[nodiscard]] const std::optional<ScalarMap>& scalarMap() const { return map_; }

  /// Labels of some points as they stand while a stroke runs, before the surface itself is replaced: colours
  /// only.
  void setPatchLabels(const std::vector<int>& ids, const std::vector<int>& values);

  /// Moves the drawing, not the surface: for an overlay of two frames.
  void setSceneFromSurface(const Isometry3d& motion);
  [[nodiscard]] const Isometry3d& sceneFromSurface() const { return sceneFromSurface_; }

  [[nodiscard]] vtkActor* actor() const { return actor_; }

 private:
  [[nodiscard]] Vector3d colourAt(Index point) const;
  void recolour();
  void applyStyle();

  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
  vtkSmartPointer<vtkPolyData> data_;
  vtkSmartPointer<vtkUnsignedCharArray> colours_;
  TextureOverlay photograph_;
  std::shared_ptr<const Surface> surface_;
  std::vector<int> labels_;
  SurfaceStyle style_;
  Isometry3d sceneFromSurface_ = Isometry3d::Identity();
  std::optional<ScalarMap> map_;
};

}  // namespace falciform
