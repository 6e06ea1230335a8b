#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "Logic/Core/Signal.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/Types.h"
#include "Logic/Core/Volume.h"
#include "Widgets/Rendering/MappedCase.h"
#include "Widgets/Rendering/ScalarMap.h"
#include "Widgets/Views/SliceOptions.h"

namespace falciform {

/// How one part of the case is drawn.
struct PartLook {
  bool visible = true;
  std::array<double, 3> colour{0.8, 0.8, 0.8};  ///< red, green, blue in [0, 1]
  double opacity = 1;                           ///< 0 clear, 1 solid

  bool operator==(const PartLook&) const = default;
};

/// How one patch is drawn, on both surfaces.
struct PatchLook {
  bool visible = true;
  std::array<double, 3> colour{0.8, 0.8, 0.8};  ///< red, green, blue in [0, 1]

  bool operator==(const PatchLook&) const = default;
};

/// Names of the parts as the tree and the views know them.
namespace part {
inline constexpr char kPreop[] = "preop", kScan[] = "scan";
inline constexpr char kPreopLandmarks[] = "preopLandmarks", kScanLandmarks[] = "scanLandmarks";
inline constexpr char kTargets[] = "targets";
[[nodiscard]] inline std::string structure(const std::string& name) { return "structure/" + name; }
}  // namespace part

/// Which of the two surfaces a step needs to see.
enum class Arrangement {
  Together,   ///< both, the scan placed by the registration
  PreopOnly,  ///< the pre-operative side
  ScanOnly,   ///< the scan in its scanner's own frame
};

struct ViewOptions {
  std::map<std::string, PartLook> looks;  ///< what differs from defaultLook()
  std::map<int, PatchLook> patchLooks;    ///< what differs from patchColour()
  Arrangement arrangement = Arrangement::Together;
  bool afterRegistration = true;                       ///< false shows the scan at the start pose
  Matrix4d startPreopFromScan = Matrix4d::Identity();  ///< where a registration would begin
  std::optional<Matrix4d> livePreopFromScan;  ///< a pose that is shown before the others, and not stored
  std::string liveCaption;                    ///< what that pose is
  bool moving = false;                        ///< handles in the 3D view change that pose
  double moveStepMm = 5, moveStepDeg = 5;     ///< of a key while moving
  bool distanceShown = false;                 ///< the distance map's colours, where there is one
  bool distanceOnScan = false;                ///< on the scan instead of the liver
  ScalarMap distanceColours{
      kSignedDistance,  "Signed distance",  "mm", -10,          10,
      OutOfRange::Grey, Palette::Diverging, 0,    "not covered"};  ///< which of its arrays, and how
  std::vector<MappedCase> mappedCases;  ///< several cases in those colours beside each other, in place of the
  bool galleryShown = false;            ///< one, if this says so
  int enlargedCase = -1;                ///< only this one of them; -1: all
  bool painting = false;                ///< left drag paints
  std::shared_ptr<const Points> suggestedLine;  ///< on the liver, pre-op mm: where a patch may belong,
  int suggestedLabel = 0;                       ///< and which
  bool supportsShown = false;                   ///< painted supports on the liver in place of its patches
  /// The pre-operative surface as supports move it, with "displacement_mm", or as a model update does; not
  /// stored. Painting shows the liver at rest.
  std::shared_ptr<const Surface> liveDeformed;
  std::string deformedCaption;             ///< what it is
  bool displacementColours = true;         ///< how far it has moved as colour, else its supports
  double displacementLimitMm = 10;         ///< colours run from 0 to this
  bool updateShown = false;                ///< what moves it is a model update: the scan is shown with it,
  std::optional<ScalarMap> updateColours;  ///< these are its colours, where it has their array,
  std::map<std::string, std::shared_ptr<const Surface>>
      movedStructures;                         ///< these its structures, pre-op mm,
  std::shared_ptr<const Points> movedTargets;  ///< these its targets, pre-op mm, in the order of the case's,
  bool structuresBefore = false;               ///< and where they were is drawn as well
  std::shared_ptr<const Surface>
      comparedLiver;            ///< beside it in a second view: the liver as only registered,
  std::string comparedCaption;  ///< and what that is
  bool colourBarShown = true;   ///< of two views beside each other one is enough
  bool slicesShown = false;     ///< CT or label map as three cuts, with outlines: the step wants them,
  bool slicesWanted = false;    ///< or the user, whatever the step
  bool slicesLarge = false;     ///< to work in: one of them large, all of the volume in sight
  GreyWindow greyWindow;        ///< of the CT in all slices
  std::map<int, std::array<double, 3>> labelColours;  ///< what differs from labelColour()
  bool labelsShown = true;                            ///< over the CT
  SliceTool sliceTool = SliceTool::Look;
  double sliceBrushMm = 8;                     ///< radius of the tools that paint
  std::shared_ptr<const LabelMap> liveLabels;  ///< in slices, in place of the case's: a front, a stroke
  std::shared_ptr<const LabelMap> forbidden;   ///< in slices: where the front is kept out
  int labelEdits = 0;                          ///< counts changes within these two
  std::shared_ptr<const Points> seeds;         ///< LPS mm, in slices and 3D
  /// In place of the pre-operative surface: what a running front, or an import, makes; not stored.
  std::shared_ptr<const Surface> previewSurface;
  std::string previewCaption;    ///< what it is
  bool previewIsSketch = false;  ///< coarse: drawn see-through, and not in slices
  bool darkScene = false;        ///< a darker background, for the dark theme

  bool operator==(const ViewOptions&) const = default;
};

/// What the views show and how; panels and tree write it, views follow it. Nothing of it is part of the case.
class ViewState {
 public:
  Signal<> changed;
  Signal<const std::string&> warned;  ///< what mouse or key asked for is not done, or not seen, and why
  Signal<> brushChanged;              ///< the mouse or a key changed radius, patch, labels or undo steps
  Signal<const SliceTouch&> touched;  ///< the mouse in a slice, with a tool in hand
  Signal<const Vector3d&> wanderTo;   ///< slices shall show this place, LPS mm

  [[nodiscard]] const ViewOptions& options() const { return options_; }
  [[nodiscard]] PartLook look(const std::string& part) const;
  void setLook(const std::string& part, const PartLook& look);
  [[nodiscard]] PatchLook patchLook(int label) const;
  void setPatchLook(int label, const PatchLook& look);

  /// `change(ViewOptions&)`, announced once if anything is different afterwards.
  template <class Change>
  void edit(Change change) {
    ViewOptions next = options_;
    change(next);
    if (next == options_) return;
    options_ = std::move(next);
    changed.emit();
  }

 private:
  ViewOptions options_;
};

/// The look of a part nobody has touched: liver and scan in their usual colours, vessels and tumours by their
/// names.
[[nodiscard]] PartLook defaultLook(const std::string& part);

}  // namespace falciform
