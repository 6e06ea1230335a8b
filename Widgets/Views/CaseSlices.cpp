#include "Widgets/Views/CaseSlices.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "Widgets/Rendering/PatchColours.h"
#include "Widgets/Views/SliceView.h"

namespace falciform {
namespace {

constexpr double kMarginMm = 15;
// Of Okabe and Ito (2008); on grey both can be told from it and from each other.
const QColor kAfter(86, 180, 233);

QColor before() { return QColor::fromRgbF(kBeforeColour.x(), kBeforeColour.y(), kBeforeColour.z()); }

QString swatch(const QColor& colour, const QString& line) {
  return QString("<span style='color:%1'><b>%2</b></span> ").arg(colour.name(), line);
}

}  // namespace

CaseSlices::CaseSlices(Case& document, ViewState& view, QWidget* parent)
    : QWidget(parent), case_(document), view_(view), legend_(new QLabel(this)) {
  setObjectName("caseSlices");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal}) {
    auto* slice = new SliceView(plane, this);
    views_.push_back(slice);
    row->addWidget(slice, 1);
    connect(slice, &SliceView::cursorMoved, this, [this, slice](const Vector3d& mm) {
      for (SliceView* other : views_)
        if (other != slice) other->setCursorMm(mm);
    });
  }
  column->addLayout(row, 1);
  legend_->setObjectName("sliceLegend");
  legend_->setTextFormat(Qt::RichText);
  legend_->setContentsMargins(6, 0, 6, 2);
  legend_->setWordWrap(true);
  column->addWidget(legend_);
  caseChanged_ = document.changed.connect([this](Case::Part) {
    if (isVisible()) follow();
  });
  viewChanged_ = view.changed.connect([this] {
    if (isVisible()) follow();
  });
}

void CaseSlices::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follow();
}

void CaseSlices::followExtent() {
  if (extentOf_ == case_.preop() || !case_.preop() || case_.preop()->size() == 0) return;
  const bool same = extentOf_ && extentOf_->size() == case_.preop()->size() &&
                    extentOf_->points == case_.preop()->points;  // painted since
  extentOf_ = case_.preop();
  if (same) return;
  const Points& points = extentOf_->points;
  const Vector3d margin = Vector3d::Constant(kMarginMm);
  for (SliceView* slice : views_)
    slice->setExtent(points.colwise().minCoeff().transpose() - margin,
                     points.colwise().maxCoeff().transpose() + margin);
}

void CaseSlices::follow() {
  followExtent();
  const ViewOptions& options = view_.options();
  std::vector<SliceOutline> outlines;
  const auto visible = [&](const std::string& part) {
    const PartLook look = view_.look(part);
    return look.visible && look.opacity > 0;
  };
  const auto add = [&](const std::string& part, const std::shared_ptr<const Surface>& was,
                       const std::shared_ptr<const Surface>& is) {
    if (!visible(part)) return;
    outlines.push_back({was, before(), true});
    if (is) outlines.push_back({is, kAfter, false});
  };
  const bool updated = options.updateShown && options.liveDeformed;
  add(part::kPreop, case_.preop(), updated ? options.liveDeformed : nullptr);
  for (const auto& [name, surface] : case_.structures()) {
    const auto moved = options.movedStructures.find(name);
    add(part::structure(name), surface,
        updated && moved != options.movedStructures.end() ? moved->second : nullptr);
  }
  for (SliceView* slice : views_) {
    slice->setVolume(case_.ct(), case_.labels());
    slice->setOutlines(outlines);
  }
  const QString picture = case_.ct()       ? tr("CT as imaged")
                          : case_.labels() ? tr("label map as imaged (no CT in the case)")
                                           : tr("no CT and no label map in the case");
  legend_->setText(
      swatch(before(), QString::fromUtf8("– –")) +
      (case_.registration() ? tr("as registered") : tr("surfaces of the case")) + "&nbsp;&nbsp; " +
      (updated ? swatch(kAfter, QString::fromUtf8("——")) + tr("as updated") + "&nbsp;&nbsp; " : QString()) +
      picture + tr(". Patient's frame (LPS), mm"));
}

}  // namespace falciform
