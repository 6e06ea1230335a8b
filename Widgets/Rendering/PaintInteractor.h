#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "Logic/Patches/PatchPaintingLogic.h"
#include "Widgets/Rendering/BrushCursorPresenter.h"
#include "Widgets/Rendering/LassoTool.h"
#include "Widgets/Rendering/NavigationInteractor.h"
#include "Widgets/Rendering/PathTool.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Rendering/SurfacePresenter.h"

namespace falciform {

/// Paints with mouse and keys. While painting, left does what the tool says, any modifier with left
/// navigates, Shift+wheel or + and - size the brush, 1-9 pick the patch, 0 erases, z and y undo and redo, Esc
/// leaves. Of a line each click is a corner, Enter or a double click paints it, Backspace takes the last
/// corner back, Esc drops it. All else navigates.
class PaintInteractor : public NavigationInteractor {
 public:
  static PaintInteractor* New();
  vtkTypeMacro(PaintInteractor, NavigationInteractor);
  PaintInteractor(const PaintInteractor&) = delete;
  PaintInteractor& operator=(const PaintInteractor&) = delete;

  /// Paints with `logic` on the surface that `presenter` shows in `renderer`; all three must outlive the
  /// painting.
  void startPainting(PatchPaintingLogic& logic, SurfacePresenter& presenter, vtkRenderer* renderer);
  /// Ends a running stroke first.
  void stopPainting();
  [[nodiscard]] bool painting() const { return logic_ != nullptr; }

  std::function<void()> onChange;                  ///< labels, brush size or patch changed by mouse or key
  std::function<void()> onLeave;                   ///< painting was left by Esc
  std::function<void(const std::string&)> onWarn;  ///< nothing is painted, or not seen, and why

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonDoubleClick() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnLeave() override;
  void OnKeyPress() override;
  void OnChar() override;

 protected:
  PaintInteractor();
  ~PaintInteractor() override;

 private:
  struct Place {
    SurfaceHit hit;
    Vector3d viewDirection;  ///< in the surface's frame, as the hit
  };
  [[nodiscard]] std::optional<Place> placeAt(double x, double y);
  /// Whether what is painted now would be seen and taken; says why not.
  [[nodiscard]] bool mayPaint();
  void paintTo(int x, int y);
  void clickPath();
  void finishPath();
  void finishLasso();
  void fillAt();
  [[nodiscard]] const TriangleTree* tree() const { return picker_ ? picker_->tree() : nullptr; }
  [[nodiscard]] Vector3d colourOf(int label) const;
  void showCursor();
  void endStroke();
  void takeLabels(const PatchEdit& edit);
  void scaleBrush(double factor);
  void changed();
  void paintKey(char key);

  PatchPaintingLogic* logic_ = nullptr;
  SurfacePresenter* presenter_ = nullptr;
  vtkRenderer* renderer_ = nullptr;
  std::unique_ptr<SurfacePicker> picker_;
  std::shared_ptr<const Surface> picked_;  ///< the surface that picker_ is known to fit
  std::unique_ptr<BrushCursorPresenter> cursor_;
  std::unique_ptr<PathTool> path_;
  std::unique_ptr<LassoTool> lasso_;
  int lastX_ = 0, lastY_ = 0;
};

}  // namespace falciform
