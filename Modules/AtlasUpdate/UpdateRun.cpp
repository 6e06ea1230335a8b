#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <cmath>
#include <utility>

#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/AtlasUpdate/UpdatePage.h"
#include "Widgets/Views/PlotWidget.h"

// The jobs of the update page: preparing, updating, opening and saving.

namespace falciform {
void UpdatePage::prepareModel() { makeModel(tr("Preparing the model"), logic_.prepareModel()); }

void UpdatePage::openAtlas() {
  const QString file = askForFile(tr("Open an atlas of this liver"), tr("Atlases (*.h5)"));
  if (!file.isEmpty()) makeModel(tr("Opening the atlas"), logic_.prepareModel(file.toStdString()));
}

void UpdatePage::makeModel(const QString& title,
                           std::function<ModelUpdateLogic::Model(const Progress&)> make) {
  preparing_ = true;
  bench().runner.start(
      title, std::move(make),
      [this](ModelUpdateLogic::Model model) {
        preparing_ = false;
        if (!logic_.acceptModel(std::move(model))) {
          bench().log.warn(tr("The liver changed while its model was prepared: it is dropped."));
          return;
        }
        bench().log.info(tr("Model: %1").arg(updateModelState(logic_)));
      },
      [this] { preparing_ = false; });
}

void UpdatePage::runUpdate() {
  watch_ = std::make_unique<UpdateWatch>(document(), logic_.model());
  liveShown_ = 0;
  running_ = true;
  curves_->clear();
  liveWords_->clear();
  timer_->start();
  logic_.observer = watch_->observer();
  bench().runner.start(
      tr("Updating the model"),
      [job = logic_.prepare()](const Progress& progress) {
        return mapsOf(job(progress.part(0, 0.8)), progress.part(0.8, 1));
      },
      [this](std::shared_ptr<const UpdateMaps> maps) { updated(std::move(maps)); },
      [this] {
        endRun();
        bench().log.info(tr("The update was cancelled; what was there before stands."));
      });
}

void UpdatePage::updated(std::shared_ptr<const UpdateMaps> maps) {
  endRun();
  const auto before = std::exchange(maps_, maps);  // first: the case announces the result
  if (!logic_.accept(maps->of)) {
    maps_ = before;
    bench().log.warn(tr("The liver was replaced while the model was updated: the result is dropped."));
    return;
  }
  const UpdatedCase& made = *maps_->of;
  bench().log.info(tr("Updated: %1").arg(updateFigures(made.update)));
  for (const std::string& warning : updateWarnings(made)) bench().log.warn(QString::fromStdString(warning));
  look_.share = 1;
  showInViews();
}

// A case that was opened has brought a result; its distances are worked out anew, once.
void UpdatePage::showKept() {
  if (maps_ || !entered_ || running_ || bench().runner.busy() || !logic_.result() ||
      triedKept_ == logic_.result())
    return;
  triedKept_ = logic_.result();
  bench().runner.start(
      tr("Showing the saved update"),
      [made = logic_.result()](const Progress& progress) { return mapsOf(made, progress); },
      [this](std::shared_ptr<const UpdateMaps> maps) {
        if (maps->of != logic_.result()) return;
        maps_ = std::move(maps);
        look_.share = 1;
        showInViews();
      });
}

void UpdatePage::endRun() {
  preparing_ = false;
  if (!running_) return;
  showLive();
  running_ = false;
  timer_->stop();
  watch_.reset();
  logic_.observer = nullptr;
  showInViews();  // what stood before, until a new result is accepted
}

void UpdatePage::showLive() {
  if (!watch_ || watch_->size() == liveShown_) return;
  const std::vector<UpdateRecord> records = watch_->records();
  liveShown_ = records.size();
  liveWords_->setText(liveWords(records));
  showCurves(records);
  if (entered_ && running_ && !records.empty())
    showSettling(bench().view, document(), *records.back().shape, records.back().iteration);
}

void UpdatePage::showCurves(const std::vector<UpdateRecord>& records) {
  PlotWidget::Curve rms{tr("residual (fit)"), QColor("#0072b2"), {}, {}};
  PlotWidget::Curve bend{tr("bending"), QColor("#e69f00"), {}, {}};
  PlotWidget::Curve expected{tr("expected error"), QColor("#009e73"), {}, {}};
  for (const UpdateRecord& record : records) {
    rms.x << record.iteration;
    rms.y << record.rmsMm;
    bend.x << record.iteration;
    bend.y << record.bendMm;
    if (std::isnan(record.expectedMm)) continue;
    expected.x << record.iteration;
    expected.y << record.expectedMm;
  }
  curves_->setCurves({rms, bend, expected});
}

void UpdatePage::openTargets(FileRole role, const QString& title) {
  const QString file = askForFile(title, tr("Points (*.mrk.json *.fcsv)"));
  if (!file.isEmpty()) bench().files.open(file.toStdString(), role);
}

QString UpdatePage::askWhere(const QString& title, const QString& name, const QString& filter) {
  const QString folder = QSettings().value("lastFolder").toString();
  return QFileDialog::getSaveFileName(this, title, folder + "/" + name, filter);
}

void UpdatePage::saveSurface() {
  const QString file =
      askWhere(tr("Save the updated surface"), "updated.vtp", tr("Surfaces (*.vtp *.vtk *.ply *.stl *.obj)"));
  if (file.isEmpty() || !maps_) return;
  bench().runner.start(
      tr("Saving the surface"),
      [made = maps_->of, path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        writeSurface(path, *made->surface, Overwrite::Replace);  // the file dialog has asked already
      },
      [this, file] { bench().log.info(tr("Saved %1.").arg(QFileInfo(file).fileName())); });
}

void UpdatePage::saveTargets() {
  const QString file =
      askWhere(tr("Save the updated targets"), "targets_updated.mrk.json", tr("Points (*.mrk.json)"));
  if (file.isEmpty() || !maps_) return;
  Landmarks now;
  now.frame = maps_->of->surface->frame;
  for (const UpdatedTarget& target : maps_->of->targets)
    if (!target.structure) now.points.push_back({target.name, target.now});
  bench().runner.start(
      tr("Saving the targets"),
      [now, path = file.toStdString()](const Progress& progress) {
        progress.report(0, "writing");
        writeLandmarks(path, now, Overwrite::Replace);
      },
      [this, file] { bench().log.info(tr("Saved %1.").arg(QFileInfo(file).fileName())); });
}

}  // namespace falciform
