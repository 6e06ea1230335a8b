#pragma once
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "Logic/Core/Types.h"
#include "Widgets/Rendering/OrientationCubePresenter.h"
#include "Widgets/Rendering/TextPresenter.h"

namespace falciform {

/// Colours are red, green, blue in [0, 1].
struct SceneStyle {
  Vector3d background{1, 1, 1}, backgroundTop{1, 1, 1};
  Vector3d text{0.13, 0.13, 0.13};
  int textPx = 14;  ///< height of ordinary text
};

/// Light grey-blue, for views on screen; pictures for paper are white.
[[nodiscard]] SceneStyle screenStyle(int textPx = 14);

/// Key, fill and head light that follow the camera, all white, so that colours keep their meaning.
void lightLikePaper(vtkRenderer* renderer);

/// What a view shows: renderer, lights, the research notice, the orientation cube and any presenters. Any
/// render window can show it, one at a time: the desktop view's or one without a display.
class Scene {
 public:
  explicit Scene(const SceneStyle& style = {});
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Puts the scene's renderers into `window`, which gets two layers.
  void attach(vtkRenderWindow* window);
  void detach();

  [[nodiscard]] vtkRenderer* renderer() const { return renderer_; }
  [[nodiscard]] const SceneStyle& style() const { return style_; }
  /// A darker background, on which the same text is read.
  void setDark(bool dark);
  [[nodiscard]] OrientationCubePresenter& orientation() { return *cube_; }

  /// Makes a `Presenter(renderer(), arguments...)` that lives as long as the scene, or until remove().
  template <class Presenter, class... Arguments>
  Presenter& add(Arguments&&... arguments) {
    auto made = std::make_shared<Presenter>(renderer_.Get(), std::forward<Arguments>(arguments)...);
    presenters_.push_back(made);
    return *made;
  }
  template <class Presenter>
  void remove(Presenter& presenter) {
    std::erase_if(presenters_, [&](const auto& kept) { return kept.get() == &presenter; });
  }

 private:
  SceneStyle style_;
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderWindow> window_;
  std::vector<std::shared_ptr<void>> presenters_;
  std::unique_ptr<TextPresenter> notice_;
  std::unique_ptr<OrientationCubePresenter> cube_;
};

}  // namespace falciform
