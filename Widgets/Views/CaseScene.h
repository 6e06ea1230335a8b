#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Case.h"
#include "Widgets/Rendering/BrushCursorPresenter.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/ColourBarPresenter.h"
#include "Widgets/Rendering/LegendPresenter.h"
#include "Widgets/Rendering/Scene.h"
#include "Widgets/Rendering/SurfacePresenter.h"
#include "Widgets/Rendering/TextPresenter.h"
#include "Widgets/Views/ViewState.h"

namespace falciform {

/// One drawn surface of the case, for picking: its points are in `surface`'s own frame.
struct ShownSurface {
  std::string part;   ///< as in ViewState
  std::string title;  ///< as on screen
  std::shared_ptr<const Surface> surface;
  Isometry3d sceneFromSurface = Isometry3d::Identity();
  std::optional<ScalarMap> map = {};              ///< its colours, where these mean values
  std::optional<Isometry3d> lpsFromSurface = {};  ///< where places are told as the patient's
};

/// The case as a Scene: follows Case and ViewState when told to. The scene's frame is patient LPS, except
/// when the scan is shown alone: then the scanner's own. No Qt; any render window can show it.
class CaseScene {
 public:
  CaseScene(const Case& document, const ViewState& view, int textPx);

  /// Draws what case and view say now. True if other shapes, or another frame, came on screen, so that the
  /// view should be fitted anew.
  bool follow();
  /// Puts everything on screen, for a view of `aspect` = width / height: from the present direction, or, when
  /// the frame has changed, from the patient's front or the scanner's side.
  void fit(double widthPx, double heightPx);

  [[nodiscard]] Scene& scene() { return scene_; }
  [[nodiscard]] SurfacePresenter& preop() { return preop_; }
  [[nodiscard]] SurfacePresenter& scan() { return scan_; }
  /// Visible surfaces, for the data probe.
  [[nodiscard]] std::vector<ShownSurface> shown() const;
  /// Rotation from LPS to the scene.
  [[nodiscard]] Matrix3d sceneFromLps() const;

 private:
  struct Wanted;
  [[nodiscard]] Wanted wanted() const;
  [[nodiscard]] bool scanAlone() const { return view_.options().arrangement == Arrangement::ScanOnly; }
  [[nodiscard]] Points shownPoints() const;
  [[nodiscard]] ViewDirection firstDirection() const;
  /// Whether much of what is drawn there is outside of the view as it stands.
  [[nodiscard]] bool outOfSight(const SurfacePresenter& presenter) const;
  [[nodiscard]] std::shared_ptr<const Surface> withSupports(
      const std::shared_ptr<const Surface>& liver) const;
  void followStructures(const Wanted& wanted);
  void drawStructure(const std::string& name, const std::shared_ptr<const Surface>& surface,
                     SurfacePresenter*& presenter, bool visible, bool ghost);
  void followLandmarks(const Wanted& wanted);
  /// Patches as the user wants them; `light`: of two on each other this one.
  void dressPatches(SurfaceStyle& style, bool light) const;
  void followSuggestion(const Wanted& wanted);
  void followTexts(const Wanted& wanted);

  const Case& case_;
  const ViewState& view_;
  int textPx_;
  Scene scene_;
  SurfacePresenter &preop_, &scan_, &preopLandmarks_, &scanLandmarks_, &targets_, &seeds_;
  BrushCursorPresenter& suggestion_;
  ColourBarPresenter& bar_;
  LegendPresenter& legend_;
  TextPresenter &title_, &corner_;  ///< the second where two views beside each other leave little room
  std::map<std::string, SurfacePresenter*> structures_, ghosts_;
  struct Supported {
    std::shared_ptr<const Surface> liver;
    std::shared_ptr<const SupportPainting> painting;
    std::shared_ptr<const Surface> shown;
  };
  mutable Supported supported_;       ///< the last liver drawn with its supports
  std::vector<ShownSurface> fitted_;  ///< what was on screen when follow() last asked for a fit
  bool fittedBar_ = false, fittedDistance_ = false, fittedPreview_ = false, narrow_ = false;
  Isometry3d followedScan_ = Isometry3d::Identity();  ///< where the last follow() drew the scan
  bool fittedWide_ = false;                           ///< the last fit was made because it lay outside
  Index fittedSeeds_ = 0;
  int legendLines_ = 0;
  std::optional<bool> directedScanAlone_;  ///< the frame that the camera's direction belongs to
  std::shared_ptr<const RegistrationResult> fittedRegistration_;
};

}  // namespace falciform
