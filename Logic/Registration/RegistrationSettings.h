#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "Logic/Core/Settings.h"

namespace falciform {

/// Which closest-point method: the first four are sets of values of the one loop, not loops of their own; the
/// others are baselines of the literature (MethodDispatch.h).
enum class RegistrationMethod {
  Icp,     ///< no labels (Besl and McKay 1992)
  Wgf,     ///< labels, constant patch weight (Maurer 1998)
  Picp,    ///< labels, patch weight relaxed by Eq. (III.3)
  Auto,    ///< no labels and no start: every rotation tried on the bare surface
  Dirr,    ///< the largest undeformed share, by Powell's method (Dirr.h)
  Cpt,     ///< interpolated closest-point transform (ClosestPointTransform.h)
  Colour,  ///< nearest in place and colour (ColourIcp.h)
  Tps,     ///< thin-plate-spline ICP, not rigid (NonRigidRegistration.h)
  Rpm,     ///< robust point matching, not rigid (NonRigidRegistration.h)
};
inline std::span<const std::string_view> enumNames(RegistrationMethod) {
  static constexpr std::array<std::string_view, 9> names{"icp", "wgf",    "picp", "auto", "dirr",
                                                         "cpt", "colour", "tps",  "rpm"};
  return names;
}
/// Whether the method is one of MethodDispatch.h: it knows no patches beyond its start and has no finish.
[[nodiscard]] constexpr bool isOtherMethod(RegistrationMethod method) {
  return method >= RegistrationMethod::Dirr;
}

/// Where the search begins.
enum class RegistrationStart {
  Patches,  ///< every rotation of an even grid tried on the patch points, the best kept
  Given,    ///< the one pose given (identity unless landmarks or a file say otherwise)
};
inline std::span<const std::string_view> enumNames(RegistrationStart) {
  static constexpr std::array<std::string_view, 2> names{"patches", "given"};
  return names;
}

/// What has the last word.
enum class RegistrationFinish {
  Elastic,  ///< the most probable rigid motion of a liver that may also have bent (ElasticFit.h)
  None,     ///< the closest-point loop itself
};
inline std::span<const std::string_view> enumNames(RegistrationFinish) {
  static constexpr std::array<std::string_view, 2> names{"elastic", "none"};
  return names;
}

enum class StopRule {
  Motion,  ///< largest point displacement < motionToleranceMm and the patch weight within 1 % of its base
  Rms,     ///< the thesis: RMS residual changes by < rmsToleranceMm
};
inline std::span<const std::string_view> enumNames(StopRule) {
  static constexpr std::array<std::string_view, 2> names{"motion", "rms"};
  return names;
}

struct RegistrationSettings {
  RegistrationMethod method = RegistrationMethod::Picp;
  RegistrationStart start = RegistrationStart::Patches;
  RegistrationFinish finish = RegistrationFinish::Elastic;
  std::vector<int> patches;            ///< labels used; empty: all that both sides have
  double weightMax = 1000;             ///< w_PBR,max of Eq. (III.3)
  double weightBase = 1;               ///< w_PBR,base
  double relaxation = 0.05;            ///< alpha of Eq. (III.3), per iteration
  double correspondenceWeight = 1e-4;  ///< w_PC of Eq. (III.1)
  double robustScaleMm =
      10;  ///< Welsch scale of the residual weights, never below 3 median residuals; 0: none
  int maxIterations = 1000;
  StopRule stop = StopRule::Motion;
  double motionToleranceMm = 1e-3;
  double rmsToleranceMm = 1e-4;
};

template <class Visitor>
void describe(RegistrationSettings& s, Visitor&& field) {
  field(
      FieldInfo{
          "method", "Method", "", 0, 0,
          "icp: no patches, closest points alone; wgf: constant patch weight; picp: patch weight "
          "relaxed as the thesis; auto: no patches and no start. Baselines of the literature, from a start "
          "near by or from patches: dirr (undeformed share), cpt (voxel map), colour (textured scans), "
          "tps and rpm (not rigid)."},
      s.method);
  field(FieldInfo{"start", "Start", "", 0, 0,
                  "patches: no pose needed, every rotation of a grid is tried on them; given: one start."},
        s.start);
  field(FieldInfo{"finish", "Finish", "", 0, 0,
                  "elastic: the pose of the whole liver, which may have bent; none: the closest-point loop. "
                  "Of wgf, picp and auto."},
        s.finish);
  field(FieldInfo{"patches", "Patches", "", 1, 255,
                  "Patch labels to use; none means all that both sides have."},
        s.patches);
  field(FieldInfo{"weightMax", "Largest patch weight", "", 1, 1e6,
                  "w_PBR,max: how strongly patches pull at the beginning."},
        s.weightMax);
  field(FieldInfo{"weightBase", "Base patch weight", "", 1, 1e6,
                  "w_PBR,base: how strongly patches pull at the end."},
        s.weightBase);
  field(FieldInfo{"relaxation", "Relaxation", "", 1e-4, 1,
                  "alpha: how fast the patch weight falls, per iteration."},
        s.relaxation);
  field(FieldInfo{"correspondenceWeight", "Correspondence weight", "", 1e-9, 1,
                  "w_PC: how much nearer a point of the same patch counts."},
        s.correspondenceWeight);
  field(FieldInfo{"robustScaleMm", "Robust scale", "mm", 0, 100,
                  "Residuals well beyond this count little; 0 counts all alike."},
        s.robustScaleMm);
  field(FieldInfo{"maxIterations", "Iterations", "", 1, 100000, "At most so many."}, s.maxIterations);
  field(FieldInfo{"stop", "Stop rule", "", 0, 0,
                  "motion: when nothing moves and the weight has relaxed; rms: the thesis's rule."},
        s.stop);
  field(FieldInfo{"motionToleranceMm", "Motion tolerance", "mm", 1e-9, 1,
                  "Stop when no point moves farther than this."},
        s.motionToleranceMm);
  field(FieldInfo{"rmsToleranceMm", "RMS tolerance", "mm", 1e-9, 1,
                  "Stop when the RMS residual changes by less (rms rule)."},
        s.rmsToleranceMm);
}

/// Whether patches bear on the result, if only through the start.
[[nodiscard]] inline bool looksAtPatches(const RegistrationSettings& s) {
  return s.method == RegistrationMethod::Wgf || s.method == RegistrationMethod::Picp ||
         (isOtherMethod(s.method) && s.start == RegistrationStart::Patches);
}

/// "default", "thesis-phantom" (w_max 1000, alpha 0.01), "thesis-clinical" (3000, 0.005): thesis ch. III, one
/// given start, RMS rule.
[[nodiscard]] RegistrationSettings registrationPreset(const std::string& name);
[[nodiscard]] std::vector<std::string> registrationPresets();

}  // namespace falciform
