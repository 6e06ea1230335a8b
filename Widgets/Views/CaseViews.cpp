#include "Widgets/Views/CaseViews.h"

#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "Widgets/Views/CaseSlices.h"
#include "Widgets/Views/MapGalleryView.h"

namespace falciform {
namespace {

constexpr int kFitAfterMs = 30;

}  // namespace

CaseViews::CaseViews(Case& document, ViewState& view, PatchPaintingLogic& painting, QWidget* parent)
    : QWidget(parent),
      case_(document),
      view_(view),
      painting_(painting),
      rows_(new QSplitter(Qt::Vertical, this)),
      columns_(new QSplitter(Qt::Horizontal, rows_)),
      main_(new CaseView3D(document, view, painting, columns_)) {
  setObjectName("caseViews");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(main_->toolBar());  // one for both views, which look from the same place
  column->addWidget(rows_);
  rows_->setChildrenCollapsible(false);
  columns_->setChildrenCollapsible(false);
  viewChanged_ = view.changed.connect([this] { follow(); });
}

CaseViews::~CaseViews() { delete compared_; }  // it follows comparedView_

void CaseViews::follow() {
  const ViewOptions& options = view_.options();
  const bool compare = options.updateShown && options.liveDeformed && options.comparedLiver;
  if (compare) {
    comparedView_.edit([&](ViewOptions& other) {
      other = options;
      other.painting = other.moving = other.structuresBefore = false;
      other.colourBarShown = false;
      other.liveDeformed = options.comparedLiver;
      other.deformedCaption = options.comparedCaption;
      other.movedStructures.clear();
      other.movedTargets.reset();
      for (const auto& [name, surface] : case_.structures()) other.movedStructures[name] = surface;
    });
    if (!compared_) {
      compared_ = new CaseView3D(case_, comparedView_, painting_, columns_);
      compared_->setObjectName("comparedView3D");
      columns_->insertWidget(0, compared_);
      compared_->toolBar()->hide();
      compared_->shareCamera(*main_);
    }
  }
  const bool gallery = options.galleryShown && !options.mappedCases.empty();
  if (gallery && !gallery_) layout()->addWidget(gallery_ = new MapGalleryView(view_, this));
  if (gallery_) gallery_->setVisible(gallery);
  main_->toolBar()->setVisible(!gallery);
  rows_->setVisible(!gallery);
  const bool wasCompared = compared_ && compared_->isVisibleTo(this);
  const bool slices = options.slicesShown || options.slicesWanted;
  const bool wereSlices = slices_ && slices_->isVisibleTo(this);
  if (compared_) compared_->setVisible(compare);
  if (compare && !wasCompared) columns_->setSizes({1000, 1000});
  if (slices && !slices_) {
    slices_ = new CaseSlices(case_, view_, rows_);
    rows_->setSizes({1300, 1000});
  }
  if (slices_ && std::exchange(largeSlices_, options.slicesLarge) != options.slicesLarge)
    rows_->setSizes(options.slicesLarge ? QList<int>{1000, 1500} : QList<int>{1300, 1000});
  if (slices_) slices_->setVisible(slices);
  // Once the views have their new sizes.
  if (compare != wasCompared || slices != wereSlices)
    QTimer::singleShot(kFitAfterMs, this, [this] {
      if (compared_ && compared_->isVisible()) compared_->fit();
      main_->fit();
    });
}

std::function<void(const std::filesystem::path&)> CaseViews::picture() {
  return gallery_ && gallery_->isVisible() ? gallery_->picture() : main_->picture();
}

}  // namespace falciform
