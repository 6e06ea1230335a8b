#pragma once
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

/// The scanner's photograph on a surface that is drawn already: a second coat, clear at painted points, so
/// that patches show, and left out where points have no place in the image.
class TextureOverlay {
 public:
  explicit TextureOverlay(vtkRenderer* renderer);
  ~TextureOverlay();
  TextureOverlay(const TextureOverlay&) = delete;
  TextureOverlay& operator=(const TextureOverlay&) = delete;

  /// `geometry`: the surface as it is drawn, whose points and normals are shared. A surface without texture
  /// or triangles empties the overlay.
  void show(const Surface* surface, vtkPolyData* geometry);
  [[nodiscard]] bool empty() const { return !image_; }

  /// Clear where `labels` are above 0 and `paintShown`; empty labels: nowhere.
  void setPainted(const std::vector<int>& labels, bool paintShown);
  /// The same for some points, while a stroke runs.
  void setPainted(const std::vector<int>& ids, const std::vector<int>& labels);

  [[nodiscard]] vtkActor* actor() const { return actor_; }

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkActor> actor_;
  vtkSmartPointer<vtkUnsignedCharArray> coat_;  ///< white, with an alpha
  std::shared_ptr<const ColourImage> image_;
};

}  // namespace falciform
