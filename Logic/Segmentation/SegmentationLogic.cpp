#include "Logic/Segmentation/SegmentationLogic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "Logic/Core/Errors.h"
#include "Logic/Core/PlaceText.h"
#include "Logic/Segmentation/FrontPreview.h"

namespace falciform {
namespace {

constexpr std::size_t kSteps = 50, kWholeMaps = 3;  ///< that can be undone
constexpr double kSameGridMm = 1e-3;
constexpr double kDabShare = 0.5;  ///< of the radius, from dab to dab

template <class A, class B>
bool onOneGrid(const Volume<A>& a, const Volume<B>& b) {
  return a.size == b.size && (a.worldFromIndex - b.worldFromIndex).cwiseAbs().maxCoeff() <= kSameGridMm;
}

LabelMap emptyMap(const Vector3i& size, const Matrix4d& worldFromIndex) {
  return {size, worldFromIndex,
          std::vector<std::uint16_t>(static_cast<std::size_t>(size.cast<Index>().prod()), 0)};
}

/// What was labelled otherwise before (a tumour, a vessel) keeps its label.
void keepOldLabels(LabelMap& labels, const LabelMap* before) {
  if (before == nullptr || before->voxels.size() != labels.voxels.size()) return;
  for (std::size_t i = 0; i < labels.voxels.size(); ++i)
    if (labels.voxels[i] > 0 && before->voxels[i] > 0) labels.voxels[i] = before->voxels[i];
}

}  // namespace

double SegmentationLogic::huAt(const Vector3d& mm) const {
  if (!case_.ct() || case_.ct()->voxels.empty()) return std::numeric_limits<double>::quiet_NaN();
  const Image& ct = *case_.ct();
  const Vector3d index = (ct.worldFromIndex.inverse() * mm.homogeneous()).head<3>();
  if ((index.array() < -0.5).any() || (index.array() >= ct.size.cast<double>().array() - 0.5).any() ||
      !mm.allFinite())
    return std::numeric_limits<double>::quiet_NaN();
  const Vector3i at = index.array().round().cast<int>();
  return static_cast<double>(ct.at(at.x(), at.y(), at.z()));
}

void SegmentationLogic::addSeed(const Vector3d& mm) {
  if (!case_.ct()) throw InputError("seeds are placed in a CT; open one first");
  if (std::isnan(huAt(mm)))
    throw InputError("the place " + placeText(mm) + " lies outside the CT; click inside the organ");
  Points more(seeds_.rows() + 1, 3);
  more.topRows(seeds_.rows()) = seeds_;
  more.bottomRows(1) = mm.transpose();
  setSeeds(std::move(more));
}

void SegmentationLogic::removeSeed(Index seed) {
  if (seed < 0 || seed >= seeds_.rows()) return;
  Points fewer(seeds_.rows() - 1, 3);
  fewer.topRows(seed) = seeds_.topRows(seed);
  fewer.bottomRows(fewer.rows() - seed) = seeds_.bottomRows(fewer.rows() - seed);
  setSeeds(std::move(fewer));
}

void SegmentationLogic::clearSeeds() {
  if (seeds_.rows() > 0) setSeeds(Points(0, 3));
}

void SegmentationLogic::setSeeds(Points seeds) {
  remember({.seeds = seeds_, .voxels = {}, .map = {}});
  seeds_ = std::move(seeds);
}

void SegmentationLogic::followCase() {
  if (case_.labels() == known_) return;
  // Somebody else has changed the labels: steps that are about voxels mean nothing any more.
  const auto aboutVoxels = [](const Step& step) { return !step.voxels.empty() || step.map; };
  std::erase_if(undo_, aboutVoxels);
  std::erase_if(redo_, aboutVoxels);
  if (forbidden_ && (!case_.labels() || !onOneGrid(*case_.labels(), *forbidden_))) forbidden_ = nullptr;
  known_ = case_.labels();
}

void SegmentationLogic::startEditing() {
  const auto& labels = case_.labels();
  if (labels && !labels->voxels.empty())
    editing_ = std::make_shared<LabelMap>(*labels);
  else if (case_.ct())
    editing_ = std::make_shared<LabelMap>(emptyMap(case_.ct()->size, case_.ct()->worldFromIndex));
  else
    throw InputError("there is nothing to paint on; open a CT or a label map first");
}

void SegmentationLogic::beginStroke(LabelStroke kind, int label) {
  followCase();
  startEditing();
  kind_ = kind;
  label_ =
      kind == LabelStroke::Erase ? std::uint16_t{0} : static_cast<std::uint16_t>(std::clamp(label, 1, 65535));
  stroke_.clear();
  lastDab_.reset();
}

void SegmentationLogic::change(std::size_t voxel, std::uint16_t label, bool forbidden) {
  if (forbidden && !forbidden_)
    forbidden_ = std::make_shared<LabelMap>(emptyMap(editing_->size, editing_->worldFromIndex));
  editing_->voxels[voxel] = label;
  if (forbidden_) forbidden_->voxels[voxel] = forbidden;
}

void SegmentationLogic::dab(const Vector3d& mm) {
  if (!editing_) return;
  const Vector3d from = lastDab_.value_or(mm);
  const int steps = std::max(1, static_cast<int>(std::ceil((mm - from).norm() / (kDabShare * brushMm))));
  lastDab_ = mm;
  const bool erase = kind_ == LabelStroke::Erase;
  for (int step = 1; step <= steps; ++step)
    for (const std::size_t voxel : voxelsInBall(*editing_, from + (mm - from) * step / steps, brushMm)) {
      const bool was = forbidden_ && forbidden_->voxels[voxel] > 0;
      if (editing_->voxels[voxel] == label_ && was == erase) continue;
      stroke_.push_back({voxel, editing_->voxels[voxel], was});
      change(voxel, label_, erase);
    }
}

void SegmentationLogic::endStroke() {
  if (!editing_) return;
  const auto mended = std::exchange(editing_, nullptr);
  if (stroke_.empty()) return;
  remember({.seeds = {}, .voxels = std::exchange(stroke_, {}), .map = {}});
  known_ = mended;
  case_.setLabels(known_);
}

std::shared_ptr<const LabelMap> SegmentationLogic::shownLabels() const {
  return editing_ ? std::shared_ptr<const LabelMap>(editing_) : case_.labels();
}

void SegmentationLogic::remember(Step step) {
  redo_.clear();
  undo_.push_back(std::move(step));
  const auto whole = [](const Step& one) { return one.map.has_value(); };
  while (undo_.size() > kSteps ||
         static_cast<std::size_t>(std::count_if(undo_.begin(), undo_.end(), whole)) > kWholeMaps)
    undo_.erase(undo_.begin());
}

SegmentationLogic::Step SegmentationLogic::swapped(Step step) {
  Step back;
  if (step.seeds) back.seeds = std::exchange(seeds_, std::move(*step.seeds));
  if (step.map) {
    back.map = case_.labels();
    known_ = *step.map;
    case_.setLabels(known_);
  }
  if (step.voxels.empty()) return back;
  startEditing();
  for (auto one = step.voxels.rbegin(); one != step.voxels.rend(); ++one) {
    back.voxels.push_back(
        {one->voxel, editing_->voxels[one->voxel], forbidden_ && forbidden_->voxels[one->voxel] > 0});
    change(one->voxel, one->label, one->forbidden);
  }
  known_ = std::exchange(editing_, nullptr);
  case_.setLabels(known_);
  return back;
}

void SegmentationLogic::undo() {
  followCase();
  if (undo_.empty()) return;
  Step step = std::move(undo_.back());
  undo_.pop_back();
  redo_.push_back(swapped(std::move(step)));
}

void SegmentationLogic::redo() {
  followCase();
  if (redo_.empty()) return;
  Step step = std::move(redo_.back());
  redo_.pop_back();
  undo_.push_back(swapped(std::move(step)));
}

void SegmentationLogic::forget() {
  seeds_ = Points(0, 3);
  forbidden_ = nullptr;
  editing_ = nullptr;
  undo_.clear();
  redo_.clear();
  last_.reset();
}

std::string SegmentationLogic::missingInput() const {
  if (!case_.ct()) return "Open a CT to segment the liver in it.";
  if (seeds_.rows() == 0) return "Press Add seed and click into the liver in a slice.";
  return {};
}

std::string SegmentationLogic::missingToContinue() const {
  if (!case_.ct()) return "Open a CT to segment the liver in it.";
  if (!case_.labels()) return "There is no label map to go on from: segment first.";
  if (!onOneGrid(*case_.labels(), *case_.ct()))
    return "The label map is not on the CT's grid: the front cannot go on from it.";
  return {};
}

std::function<LevelSetResult(const Progress&)> SegmentationLogic::prepare(bool goOn,
                                                                          LevelSetPreview preview) const {
  if (const std::string missing = goOn ? missingToContinue() : missingInput(); !missing.empty())
    throw InputError(missing);
  // A copy: strokes change it in place.
  std::shared_ptr<const LabelMap> forbidden;
  if (forbidden_ && onOneGrid(*forbidden_, *case_.ct()))
    forbidden = std::make_shared<const LabelMap>(*forbidden_);
  return [ct = case_.ct(), start = goOn ? case_.labels() : nullptr, forbidden, seeds = seeds_,
          snapshot = settings, preview = std::move(preview)](const Progress& progress) {
    LevelSetResult result =
        segmentLevelSet({.ct = *ct, .seeds = seeds, .start = start.get(), .forbidden = forbidden.get()},
                        snapshot, progress, preview);
    keepOldLabels(result.labels, start.get());
    return result;
  };
}

std::function<LevelSetResult(const Progress&)> SegmentationLogic::prepareStopped(
    bool goOn, std::shared_ptr<const LabelMap> front) const {
  if (!case_.ct()) throw InputError("the CT is gone; open it again");
  return [ct = case_.ct(), start = goOn ? case_.labels() : nullptr,
          front = std::move(front)](const Progress& progress) {
    progress.report(0, "Keeping the front");
    LevelSetResult result;
    result.labels = onGridOf(*ct, *front);
    keepOldLabels(result.labels, start.get());
    const auto inside = std::count_if(result.labels.voxels.begin(), result.labels.voxels.end(),
                                      [](std::uint16_t label) { return label > 0; });
    result.volumeMl = static_cast<double>(inside) * ct->voxelVolume() / 1000;
    result.warnings.push_back("stopped before the end: this is the front as it stood, on voxels of " +
                              roundedText(front->spacing().maxCoeff(), 1) +
                              " mm; mend it and continue, or segment again");
    return result;
  };
}

void SegmentationLogic::accept(LevelSetResult result) {
  followCase();
  remember({.seeds = {}, .voxels = {}, .map = case_.labels()});
  known_ = std::make_shared<const LabelMap>(std::move(result.labels));
  result.labels = {};
  last_ = std::move(result);
  case_.setLabels(known_);
}

}  // namespace falciform
