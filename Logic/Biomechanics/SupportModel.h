#pragma once
#include <memory>

#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Biomechanics/LiverModelSettings.h"
#include "Logic/Biomechanics/MeshPlaces.h"
#include "Logic/Biomechanics/SupportSites.h"
#include "Logic/Biomechanics/SupportSolver.h"
#include "Logic/Biomechanics/SupportTemplates.h"
#include "Logic/Core/SupportPainting.h"

namespace falciform {

/// A liver meshed and factorised: whatever is painted on it afterwards is answered at once.
struct SupportModel {
  SupportModel(std::shared_ptr<const Surface> surface, LiverMesh filled, SupportSites places,
               CandidateSupports mayHold, SupportSolver factorised);

  std::shared_ptr<const Surface> preop;  ///< whose points are moved
  LiverMesh liver;
  SupportSites sites;
  CandidateSupports candidates;  ///< where the factorisation allows supports
  SupportSolver solver;
  MeshPlaces places;             ///< of preop's points in the mesh
  std::vector<int> faceOfPoint;  ///< the boundary face nearest to each of preop's points
};

/// Meshes, finds the support sites and factorises. `painted` (may be nullptr) adds the faces of what is
/// painted already to where supports may be. Tumours become regions of their own stiffness. Throws InputError
/// for a surface or settings that cannot be used.
[[nodiscard]] std::shared_ptr<const SupportModel> prepareSupportModel(
    const std::shared_ptr<const Surface>& preop, const std::vector<Surface>& tumours,
    const std::shared_ptr<const SupportPainting>& painted, const LiverModelSettings& settings,
    const Progress& progress = {});

/// The painted label of each boundary face: the one that most of the surface points on it have; that of the
/// nearest point where there is none.
[[nodiscard]] std::vector<int> faceLabels(const SupportModel& model, const std::vector<int>& pointLabels);

[[nodiscard]] SupportKind supportKindOf(SupportRegionKind kind);

/// The painted regions as supports, ascending by label; `labels` says which is which. A region too small to
/// fill half of any face is left out and named in `warnings`.
struct PaintedSupports {
  std::vector<Support> supports;
  std::vector<int> labels;
  std::vector<std::string> warnings;
};
[[nodiscard]] PaintedSupports supportsOf(const SupportModel& model, const SupportPainting& painting);

/// Empty, or what must be done before these supports can be computed, in words: paint something fixed,
/// prepare the model anew where the paint lies outside of what it was prepared for.
[[nodiscard]] std::string missingSupport(const SupportModel& model, const PaintedSupports& painted);

/// A template as labels of the surface's points; `painting` (the case's, or an empty one) keeps its own
/// regions and their names.
[[nodiscard]] SupportPainting paintedTemplate(const SupportModel& model, SupportPainting painting,
                                              const SupportTemplateSettings& settings);

}  // namespace falciform
