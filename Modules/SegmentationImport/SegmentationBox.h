#pragma once
#include <QTimer>
#include <QWidget>
#include <memory>

#include "Logic/Segmentation/FrontPreview.h"
#include "Logic/Segmentation/SegmentationLogic.h"
#include "Modules/Workbench.h"
#include "Widgets/Jobs/LatestRunner.h"
#include "Widgets/Jobs/LiveValue.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;
class QToolButton;

namespace falciform {

class NumberBox;
class SettingsForm;

/// Seeds by click, the level set with its front live in slices and 3D, a brush that mends what came out, and
/// going on from there.
class SegmentationBox : public QWidget {
  Q_OBJECT

 public:
  explicit SegmentationBox(Workbench& workbench, QWidget* parent = nullptr);

  [[nodiscard]] SegmentationLogic& logic() { return logic_; }
  /// The step is on screen, or no longer.
  void enter();
  void leave();
  void refresh();
  /// Another CT: seeds and steps are gone.
  void forget();
  /// A surface has been made of the labels: no sketch of them is wanted.
  void dropSketch() { sketching_.drop(); }
  /// The label that the brush paints.
  void setPaintLabel(int label);

 Q_SIGNALS:
  /// The labels change now by this box's doing, and have changed; a new organ if `fresh`.
  void changing(bool fresh);
  void changed();

 private:
  void addTools();
  void addSeedTable();
  void addRun();
  void choose(SliceTool tool, bool on);
  void touch(const SliceTouch& touch);
  void stroke(const SliceTouch& touch);
  void take(bool undo);
  void showTools();
  void showSeeds();
  void showStroke();
  void segment(bool goOn);
  void keepStopped(bool goOn, const std::shared_ptr<const FrontPreview>& front);
  void accept(LevelSetResult result, bool goOn);
  void showResult();
  void showLive();
  void sketchLabels();
  void endLive();
  void saveLabels();

  Workbench& bench_;
  SegmentationLogic logic_;
  QToolButton *seed_, *paint_, *erase_, *undo_, *redo_;
  NumberBox* radius_;
  QTableWidget* seeds_;
  QPushButton *removeSeed_, *clearSeeds_, *segment_, *continue_, *stop_, *save_;
  SettingsForm* form_;
  QLabel *missing_, *result_, *places_, *warnings_;
  QProgressBar* bar_;
  QTimer poll_;
  LatestRunner sketching_;
  std::shared_ptr<LiveValue<FrontPreview>> live_;  ///< while a front moves
  std::shared_ptr<const FrontPreview> shownFront_;
  int paintLabel_ = 1;
  bool onScreen_ = false, stroking_ = false;
  Connection viewChanged_, touched_;
};

}  // namespace falciform
