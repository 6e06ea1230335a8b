#include "Logic/Biomechanics/SupportModel.h"

#include <algorithm>
#include <array>
#include <set>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/TriangleTree.h"

namespace falciform {
namespace {

std::vector<int> nearestFaces(const SupportSites& sites, const Points& points) {
  const TriangleTree tree(sites.boundary.surface);
  std::vector<int> faces(static_cast<std::size_t>(points.rows()));
  forEachChunk(faces.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      faces[i] = tree.closest(points.row(static_cast<Index>(i)).transpose()).triangle;
  });
  return faces;
}

std::vector<int> labelsOfFaces(const Points& points, const std::vector<int>& faceOfPoint,
                               const Points& centres, const std::vector<int>& pointLabels) {
  std::vector<std::map<int, int>> votes(static_cast<std::size_t>(centres.rows()));
  for (std::size_t i = 0; i < faceOfPoint.size(); ++i)
    ++votes[static_cast<std::size_t>(faceOfPoint[i])][pointLabels[i]];
  std::vector<int> labels(votes.size(), support_label::kFree);
  KdTree tree;
  for (std::size_t f = 0; f < votes.size(); ++f) {
    if (votes[f].empty()) {
      if (tree.empty()) tree = KdTree(points);
      const int nearest = tree.nearest(Vector3d(centres.row(static_cast<Index>(f)).transpose())).index;
      labels[f] = pointLabels[static_cast<std::size_t>(nearest)];
      continue;
    }
    const auto most = std::max_element(votes[f].begin(), votes[f].end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    labels[f] = most->first;
  }
  return labels;
}

/// Where supports may be: the sites, and what is painted already.
CandidateSupports candidatesFor(const SupportSites& sites, const std::vector<int>& labels,
                                const SupportPainting* painted) {
  CandidateSupports candidates = candidatesOf(sites);
  std::set<int> sliding(candidates.sliding.begin(), candidates.sliding.end()),
      fixed(candidates.fixed.begin(), candidates.fixed.end());
  for (std::size_t f = 0; f < labels.size(); ++f) {
    if (labels[f] == support_label::kFree) continue;
    const bool binds = painted->regions.at(labels[f]).kind == SupportRegionKind::Fixed;
    (binds ? fixed : sliding).insert(static_cast<int>(f));
  }
  for (const int f : fixed) sliding.erase(f);
  candidates.sliding.assign(sliding.begin(), sliding.end());
  candidates.fixed.assign(fixed.begin(), fixed.end());
  return candidates;
}

}  // namespace

SupportModel::SupportModel(std::shared_ptr<const Surface> surface, LiverMesh filled, SupportSites where,
                           CandidateSupports mayHold, SupportSolver factorised)
    : preop(std::move(surface)),
      liver(std::move(filled)),
      sites(std::move(where)),
      candidates(std::move(mayHold)),
      solver(std::move(factorised)),
      places(liver.mesh, preop->points),
      faceOfPoint(nearestFaces(sites, preop->points)) {}

std::shared_ptr<const SupportModel> prepareSupportModel(const std::shared_ptr<const Surface>& preop,
                                                        const std::vector<Surface>& tumours,
                                                        const std::shared_ptr<const SupportPainting>& painted,
                                                        const LiverModelSettings& settings,
                                                        const Progress& progress) {
  checkSettings(settings);
  if (painted) checkSupportPainting(*painted, preop->size(), "the painting of supports");
  MeshSettings meshing;
  meshing.edgeLengthMm = settings.edgeLengthMm;
  LiverMesh liver = meshLiver(*preop, tumours, meshing, progress.part(0, 0.3));

  progress.report(0.3, "finding support sites");
  const BoundaryFaces faces = boundaryFaces(liver.mesh);
  SupportSites sites = findSupportSites(*preop, liver.mesh, faces);
  std::vector<int> labels;
  if (painted)
    labels = labelsOfFaces(preop->points, nearestFaces(sites, preop->points), sites.centres, painted->labels);
  CandidateSupports candidates = candidatesFor(sites, labels, painted.get());

  const Material tissue{.youngsModulusMPa = settings.youngsModulusKPa / 1000,
                        .poissonsRatio = settings.poissonsRatio};
  const Material tumour{.youngsModulusMPa = settings.tumourModulusKPa / 1000,
                        .poissonsRatio = settings.poissonsRatio};
  SupportSolver solver(liver.mesh, {tissue, tumour}, candidates, progress.part(0.32, 0.97));
  progress.report(0.97, "placing the surface in the mesh");
  return std::make_shared<const SupportModel>(preop, std::move(liver), std::move(sites),
                                              std::move(candidates), std::move(solver));
}

SupportKind supportKindOf(SupportRegionKind kind) {
  switch (kind) {
    case SupportRegionKind::Sliding:
      return SupportKind::Sliding;
    case SupportRegionKind::Pushed:
      return SupportKind::Pushed;
    case SupportRegionKind::Fixed:
      break;
  }
  return SupportKind::Fixed;
}

std::vector<int> faceLabels(const SupportModel& model, const std::vector<int>& pointLabels) {
  return labelsOfFaces(model.preop->points, model.faceOfPoint, model.sites.centres, pointLabels);
}

PaintedSupports supportsOf(const SupportModel& model, const SupportPainting& painting) {
  checkSupportPainting(painting, model.preop->size(), "the painting of supports");
  std::map<int, std::vector<int>> faces;
  const std::vector<int> labels = faceLabels(model, painting.labels);
  for (std::size_t f = 0; f < labels.size(); ++f) faces[labels[f]].push_back(static_cast<int>(f));
  PaintedSupports painted;
  for (const int label : paintedSupports(painting)) {
    const SupportRegion& region = painting.regions.at(label);
    if (!faces.contains(label)) {
      painted.warnings.push_back(
          "'" + region.name + "' is smaller than the model's elements and holds nothing; paint more of it");
      continue;
    }
    Support support;
    support.name = region.name;
    support.kind = supportKindOf(region.kind);
    support.faces = faces[label];
    support.pushMm = region.kind == SupportRegionKind::Pushed ? region.pushMm : 0;
    painted.supports.push_back(std::move(support));
    painted.labels.push_back(label);
  }
  return painted;
}

std::string missingSupport(const SupportModel& model, const PaintedSupports& painted) {
  if (painted.supports.empty()) return "Paint a support, or choose a template.";
  const auto isIn = [](const std::vector<int>& ascending, int f) {
    return std::binary_search(ascending.begin(), ascending.end(), f);
  };
  for (const Support& support : painted.supports)
    for (const int f : support.faces)
      if (!isIn(model.candidates.fixed, f) &&
          (support.kind == SupportKind::Fixed || !isIn(model.candidates.sliding, f)))
        return "'" + support.name +
               "' lies where the model was not prepared for it: prepare the model again.";
  return {};
}

SupportPainting paintedTemplate(const SupportModel& model, SupportPainting painting,
                                const SupportTemplateSettings& settings) {
  const SupportHypothesis hypothesis = supportTemplate(model.sites, settings);
  const SupportPainting standard = emptySupportPainting(model.preop->size());
  std::vector<int> labelOfFace(static_cast<std::size_t>(model.sites.centres.rows()), support_label::kFree);
  // A packed place goes before what else lies there, as in the solver.
  for (const Support& support : hypothesis.supports)
    for (const auto& [label, region] : standard.regions) {
      if (region.name != support.name) continue;
      painting.regions[label] = region;
      if (support.kind == SupportKind::Pushed) painting.regions[label].pushMm = support.pushMm;
      for (const int f : support.faces) labelOfFace[static_cast<std::size_t>(f)] = label;
    }
  painting.labels.resize(model.faceOfPoint.size());
  for (std::size_t i = 0; i < painting.labels.size(); ++i)
    painting.labels[i] = labelOfFace[static_cast<std::size_t>(model.faceOfPoint[i])];
  painting.turnDeg = settings.posture == SupportTemplate::TurnedLeft && settings.turnDeg == 0
                         ? kUsualTurnDeg
                         : settings.turnDeg;
  return painting;
}

}  // namespace falciform
