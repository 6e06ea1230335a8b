#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QToolButton>
#include <chrono>
#include <cmath>

#include "Logic/IO/VolumeFiles.h"
#include "Modules/SegmentationImport/SegmentationBox.h"
#include "Widgets/Forms/NumberBox.h"

// What the controls of the segmentation box do.

namespace falciform {
namespace {

constexpr int kMostSeedRows = 6;
constexpr std::chrono::milliseconds kBetweenPreviews{250};

/// Turns the front into something to look at a few times a second, on the thread that computes it.
LevelSetPreview previewInto(const std::shared_ptr<LiveValue<FrontPreview>>& live) {
  return [live, last = std::chrono::steady_clock::time_point{}](const Mask& front) mutable {
    if (std::chrono::steady_clock::now() - last < kBetweenPreviews) return;
    live->set(std::make_shared<const FrontPreview>(previewOf(front)));
    last = std::chrono::steady_clock::now();
  };
}

/// A part of a preview that keeps the whole alive.
template <class Part>
std::shared_ptr<const Part> partOf(const std::shared_ptr<const FrontPreview>& whole, const Part& part) {
  return {whole, &part};
}

QString number(double value, int digits) { return QString::number(value, 'f', digits); }

void showWords(QLabel* label, const QString& words) {
  label->setText(words);
  label->setVisible(!words.isEmpty());
}

}  // namespace

void SegmentationBox::enter() {
  onScreen_ = true;
  showSeeds();
  showStroke();
}

void SegmentationBox::leave() {
  sketching_.drop();
  if (stroking_) stroke({SliceTouch::What::Release, {}});
  bench_.view.edit([](ViewOptions& options) {
    options.sliceTool = SliceTool::Look;
    options.liveLabels = options.forbidden = nullptr;
    options.seeds = nullptr;
    options.previewSurface = nullptr;
  });
  onScreen_ = false;
}

void SegmentationBox::forget() {
  logic_.forget();
  showWords(result_, {});
  showWords(places_, {});
  showWords(warnings_, {});
  showSeeds();
}

void SegmentationBox::setPaintLabel(int label) {
  paintLabel_ = label;
  paint_->setText(label == 1 ? tr("Paint") : tr("Paint %1").arg(label));
}

void SegmentationBox::choose(SliceTool tool, bool on) {
  bench_.view.edit([&](ViewOptions& options) { options.sliceTool = on ? tool : SliceTool::Look; });
  showTools();
}

void SegmentationBox::showTools() {
  const ViewOptions& options = bench_.view.options();
  const bool idle = !bench_.runner.busy();
  const bool ct = bench_.document.ct() != nullptr, labels = bench_.document.labels() != nullptr;
  for (const auto& [button, tool, ready] : {std::tuple(seed_, SliceTool::Seed, ct),
                                            std::tuple(paint_, SliceTool::Paint, (ct || labels) && !live_),
                                            std::tuple(erase_, SliceTool::Erase, (ct || labels) && !live_)}) {
    button->setEnabled(ready);
    button->setChecked(options.sliceTool == tool);
  }
  undo_->setEnabled(logic_.canUndo() && idle);
  redo_->setEnabled(logic_.canRedo() && idle);
  const QSignalBlocker quiet(radius_);
  radius_->setValue(options.sliceBrushMm);
}

void SegmentationBox::refresh() {
  showTools();
  const bool running = live_ != nullptr, idle = !bench_.runner.busy();
  const std::string missing = logic_.missingInput(), missingMore = logic_.missingToContinue();
  segment_->setEnabled(idle && missing.empty());
  continue_->setEnabled(idle && missingMore.empty());
  stop_->setEnabled(running);
  stop_->setVisible(running);
  continue_->setVisible(!running);
  bar_->setVisible(running);
  save_->setEnabled(idle && bench_.document.labels() != nullptr);
  showWords(missing_, running ? QString() : QString::fromStdString(missing));
  removeSeed_->setEnabled(logic_.seeds().rows() > 0);
  clearSeeds_->setEnabled(logic_.seeds().rows() > 0);
}

void SegmentationBox::touch(const SliceTouch& touch) {
  using What = SliceTouch::What;
  if (touch.what == What::Undo || touch.what == What::Redo) return take(touch.what == What::Undo);
  if (bench_.view.options().sliceTool != SliceTool::Seed) return stroke(touch);
  if (touch.what != What::Press) return;
  if (std::isnan(logic_.huAt(touch.mm))) {
    bench_.view.warned.emit("No seed is placed outside the CT: click inside the liver.");
    return;
  }
  logic_.addSeed(touch.mm);
  showSeeds();
}

void SegmentationBox::stroke(const SliceTouch& touch) {
  const SliceTool tool = bench_.view.options().sliceTool;
  if (touch.what == SliceTouch::What::Press) {
    if (live_ || (!bench_.document.ct() && !bench_.document.labels())) {
      bench_.view.warned.emit(live_ ? "The front is moving: stop it before mending what it makes."
                                    : "There is nothing to paint on: open a CT or a label map.");
      return;
    }
    stroking_ = true;
    logic_.beginStroke(tool == SliceTool::Erase ? LabelStroke::Erase : LabelStroke::Paint, paintLabel_);
  }
  if (!stroking_) return;
  if (touch.what != SliceTouch::What::Release) {
    logic_.dab(touch.mm);
    return showStroke();
  }
  stroking_ = false;
  Q_EMIT changing(false);
  logic_.endStroke();
  Q_EMIT changed();
  showStroke();
  sketchLabels();
}

void SegmentationBox::take(bool undo) {
  if (bench_.runner.busy() || stroking_) return;
  Q_EMIT changing(false);
  undo ? logic_.undo() : logic_.redo();
  Q_EMIT changed();
  showStroke();
  showSeeds();
  sketchLabels();
}

void SegmentationBox::showStroke() {
  if (!onScreen_ || live_) return;
  bench_.view.edit([this](ViewOptions& options) {
    options.liveLabels = stroking_ ? logic_.shownLabels() : nullptr;
    options.forbidden = logic_.forbidden();
    ++options.labelEdits;
  });
}

void SegmentationBox::showSeeds() {
  const Points& seeds = logic_.seeds();
  const QSignalBlocker quiet(seeds_);
  seeds_->setRowCount(static_cast<int>(seeds.rows()));
  for (int row = 0; row < seeds_->rowCount(); ++row)
    for (int column = 0; column < 4; ++column) {
      const double value = column < 3 ? seeds(row, column) : logic_.huAt(seeds.row(row).transpose());
      auto* item = new QTableWidgetItem(number(value, column < 3 ? 1 : 0));
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      seeds_->setItem(row, column, item);
    }
  const int rows = std::clamp(seeds_->rowCount(), 1, kMostSeedRows);
  seeds_->setFixedHeight(seeds_->horizontalHeader()->sizeHint().height() + 2 * seeds_->frameWidth() +
                         rows * seeds_->verticalHeader()->defaultSectionSize());
  if (onScreen_)
    bench_.view.edit([&](ViewOptions& options) {
      options.seeds = seeds.rows() > 0 ? std::make_shared<const Points>(seeds) : nullptr;
    });
  refresh();
}

void SegmentationBox::segment(bool goOn) {
  const auto live = std::make_shared<LiveValue<FrontPreview>>();
  auto job = logic_.prepare(goOn, previewInto(live));
  live_ = live;
  bar_->setValue(0);
  for (QLabel* label : {result_, places_, warnings_}) showWords(label, {});
  bench_.view.edit([](ViewOptions& options) { options.sliceTool = SliceTool::Look; });
  poll_.start();
  const bool started = bench_.runner.start(
      goOn ? tr("Continuing the segmentation") : tr("Segmenting"), std::move(job),
      [this, goOn](LevelSetResult result) { accept(std::move(result), goOn); },
      [this, goOn, live] { keepStopped(goOn, live->get()); });
  if (!started) endLive();
}

void SegmentationBox::keepStopped(bool goOn, const std::shared_ptr<const FrontPreview>& front) {
  if (!front) return;
  // Once the job that was stopped is put away.
  QTimer::singleShot(0, this, [this, goOn, front] {
    bench_.runner.start(tr("Keeping the front"), logic_.prepareStopped(goOn, partOf(front, front->labels)),
                        [this, goOn](LevelSetResult result) { accept(std::move(result), goOn); });
  });
}

void SegmentationBox::accept(LevelSetResult result, bool goOn) {
  endLive();
  Q_EMIT changing(!goOn);
  logic_.accept(std::move(result));
  Q_EMIT changed();
  showStroke();
  showResult();
  sketchLabels();
}

void SegmentationBox::showResult() {
  if (!logic_.last()) return;
  const LevelSetResult& last = *logic_.last();
  QString words = tr("%1 ml").arg(number(last.volumeMl, 0));
  if (last.tissueSpreadHu > 0)
    words += tr(", tissue of %1 ± %2 HU, narrowest neck passed %3 mm, %4 % of the border without an edge")
                 .arg(number(last.tissueLevelHu, 0), number(last.tissueSpreadHu, 0), number(last.neckMm, 1),
                      number(100 * last.weakBorderShare, 0));
  showWords(result_, words + ".");
  bench_.log.info(tr("Segmented the liver: %1.").arg(words));
  QStringList warnings, places;
  for (const std::string& warning : last.warnings) {
    warnings << QString::fromUtf8("⚠ ") + QString::fromStdString(warning);
    bench_.log.warn(QString::fromStdString(warning));
  }
  for (const LeftOut& part : last.leftOut) {
    const QString at = QString("%1,%2,%3").arg(part.place.x()).arg(part.place.y()).arg(part.place.z());
    places << QString("<a href='%1'>%2</a>").arg(at, tr("%1 ml left out").arg(number(part.volumeMl, 0)));
  }
  showWords(warnings_, warnings.join("\n"));
  showWords(places_, places.isEmpty() ? QString() : tr("Look at: ") + places.join(", "));
}

void SegmentationBox::showLive() {
  if (!live_) return poll_.stop();
  const auto front = live_->get();
  if (!front || front == shownFront_ || !onScreen_) return;
  shownFront_ = front;
  bench_.view.edit([&](ViewOptions& options) {
    options.liveLabels = partOf(front, front->labels);
    options.previewSurface = partOf(front, front->surface);
    options.previewCaption = "The front so far";
    options.previewIsSketch = true;
    ++options.labelEdits;
  });
}

/// The labels as they are now, in 3D, until a surface is made of them.
void SegmentationBox::sketchLabels() {
  const auto labels = bench_.document.labels();
  if (!labels || !onScreen_) return;
  sketching_.submit(
      [labels] {
        Mask inside{labels->size, labels->worldFromIndex, {}};
        inside.voxels.reserve(labels->voxels.size());
        for (const std::uint16_t label : labels->voxels) inside.voxels.push_back(label > 0);
        return std::make_shared<const Surface>(previewOf(inside).surface);
      },
      [this, labels](const std::shared_ptr<const Surface>& sketch) {
        if (bench_.document.labels() != labels || live_ || !onScreen_) return;
        bench_.view.edit([&](ViewOptions& options) {
          options.previewSurface = sketch->size() > 0 ? sketch : nullptr;
          options.previewCaption = "Labels as they are: no surface is made of them yet";
          options.previewIsSketch = true;
        });
      });
}

void SegmentationBox::endLive() {
  live_.reset();
  shownFront_.reset();
  poll_.stop();
  bench_.view.edit([](ViewOptions& options) {
    options.liveLabels = nullptr;
    options.previewSurface = nullptr;
  });
  refresh();
}

void SegmentationBox::saveLabels() {
  QSettings settings;
  QString file = QFileDialog::getSaveFileName(this, tr("Save label map"),
                                              settings.value("lastFolder").toString() + "/liver.nii.gz",
                                              tr("Label maps (*.nii.gz *.nii *.nrrd *.mha)"));
  if (file.isEmpty() || !bench_.document.labels()) return;
  if (!isVolumeFile(file.toStdString())) file += ".nii.gz";
  settings.setValue("lastFolder", QFileInfo(file).absolutePath());
  bench_.runner.start(
      tr("Saving the labels"),
      [labels = bench_.document.labels(), path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        writeLabelMap(path, *labels, Overwrite::Replace);
      },
      [this, file] { bench_.log.info(tr("Saved %1.").arg(QFileInfo(file).fileName())); });
}

}  // namespace falciform
