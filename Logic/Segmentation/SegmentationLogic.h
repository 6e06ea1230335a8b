#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "Logic/Core/Case.h"
#include "Logic/Segmentation/LabelBrush.h"
#include "Logic/Segmentation/LevelSet.h"

namespace falciform {

/// What a brush stroke makes of the voxels it goes over.
enum class LabelStroke {
  Paint,  ///< they get the label, and are no longer forbidden
  Erase,  ///< they are background, and the front never enters them again
};

/// The level-set step on a Case: seeds in its CT, the job that grows them, its label map mended by a brush,
/// and going on from there. Seeds, strokes and results can be undone.
class SegmentationLogic {
 public:
  explicit SegmentationLogic(Case& document) : case_(document) {}

  LevelSetSettings settings;
  double brushMm = 8;  ///< radius of the brush, a ball

  [[nodiscard]] const Points& seeds() const { return seeds_; }  ///< N x 3, LPS mm
  /// Throws InputError for a place outside the CT, or without one.
  void addSeed(const Vector3d& mm);
  void removeSeed(Index seed);
  void clearSeeds();
  /// The CT's nearest voxel, HU; NaN outside.
  [[nodiscard]] double huAt(const Vector3d& mm) const;

  /// A stroke: begin, dabs from place to place (LPS mm), end. The case gets the map as mended at the end.
  /// Without a label map an empty one on the CT's grid is begun. Throws InputError if there is neither.
  void beginStroke(LabelStroke kind, int label);
  void dab(const Vector3d& mm);
  void endStroke();
  /// As it stands while a stroke runs, else the case's. nullptr if there is none.
  [[nodiscard]] std::shared_ptr<const LabelMap> shownLabels() const;
  /// Erased voxels, 1, on the grid of the labels; nullptr if none.
  [[nodiscard]] std::shared_ptr<const LabelMap> forbidden() const { return forbidden_; }

  [[nodiscard]] bool canUndo() const { return !undo_.empty(); }
  [[nodiscard]] bool canRedo() const { return !redo_.empty(); }
  void undo();
  void redo();
  /// Seeds, erased voxels and steps gone; the case stays: for another CT.
  void forget();

  /// In words what a segmentation needs and is not there.
  [[nodiscard]] std::string missingInput() const;
  [[nodiscard]] std::string missingToContinue() const;
  /// Grows the organ from the seeds, or, to `goOn`, from the case's labels and the seeds. For a worker.
  [[nodiscard]] std::function<LevelSetResult(const Progress&)> prepare(bool goOn,
                                                                       LevelSetPreview preview) const;
  /// The same from a front that was stopped: its voxels brought onto the CT's grid.
  [[nodiscard]] std::function<LevelSetResult(const Progress&)> prepareStopped(
      bool goOn, std::shared_ptr<const LabelMap> front) const;
  /// Puts the result's labels into the case; its figures stay in last().
  void accept(LevelSetResult result);
  [[nodiscard]] const std::optional<LevelSetResult>& last() const { return last_; }

 private:
  /// How to take a change back: all of it swaps with what is there now.
  struct Step {
    std::optional<Points> seeds;
    std::vector<VoxelChange> voxels;
    std::optional<std::shared_ptr<const LabelMap>> map;  ///< the whole label map
  };

  void remember(Step step);
  [[nodiscard]] Step swapped(Step step);
  void setSeeds(Points seeds);
  void change(std::size_t voxel, std::uint16_t label, bool forbidden);
  void startEditing();
  void followCase();

  Case& case_;
  Points seeds_ = Points(0, 3);
  std::shared_ptr<LabelMap> editing_;    ///< the map that a stroke changes
  std::shared_ptr<LabelMap> forbidden_;  ///< nullptr until something is erased
  std::vector<VoxelChange> stroke_;
  LabelStroke kind_ = LabelStroke::Paint;
  std::uint16_t label_ = 1;
  std::optional<Vector3d> lastDab_;
  std::vector<Step> undo_, redo_;
  std::shared_ptr<const LabelMap> known_;  ///< the case's labels that the steps belong to
  std::optional<LevelSetResult> last_;
};

}  // namespace falciform
