#include "Widgets/Views/CaseSlices.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "Widgets/Rendering/PatchColours.h"
#include "Widgets/Views/SliceView.h"

namespace falciform {
namespace {

constexpr double kMarginMm = 15;
constexpr double kAirHu = -500;
constexpr double kLeastBrushMm = 0.5, kMostBrushMm = 60;
constexpr int kLargeShare = 17, kSmallShare = 10;  // of the width
// Of Okabe and Ito (2008); on grey both can be told from it and from each other.
const QColor kAfter(86, 180, 233);

QColor before() { return QColor::fromRgbF(kBeforeColour.x(), kBeforeColour.y(), kBeforeColour.z()); }

QString swatch(const QColor& colour, const QString& line) {
  return QString("<span style='color:%1'><b>%2</b></span> ").arg(colour.name(), line);
}

using Box = std::pair<Vector3d, Vector3d>;

Box boxOf(const Surface& surface) {
  const Vector3d margin = Vector3d::Constant(kMarginMm);
  return {surface.points.colwise().minCoeff().transpose() - margin,
          surface.points.colwise().maxCoeff().transpose() + margin};
}

template <class T>
Box boxOf(const Volume<T>& volume) {
  Box box{Vector3d::Constant(1e30), Vector3d::Constant(-1e30)};
  for (int corner = 0; corner < 8; ++corner) {
    Vector3d index;
    for (int a = 0; a < 3; ++a) index[a] = (corner >> a) & 1 ? volume.size[a] - 0.5 : -0.5;
    const Vector3d at = volume.world(index);
    box = {box.first.cwiseMin(at), box.second.cwiseMax(at)};
  }
  return box;
}

/// The nearest voxel's value; nothing outside.
template <class T>
std::optional<T> valueAt(const std::shared_ptr<const Volume<T>>& volume, const Vector3d& mm) {
  if (!volume || volume->voxels.empty()) return {};
  const Vector3d index = (volume->worldFromIndex.inverse() * mm.homogeneous()).template head<3>();
  const Vector3i at = (index.array() + 0.5).floor().template cast<int>();
  if ((at.array() < 0).any() || (at.array() >= volume->size.array()).any()) return {};
  return volume->at(at.x(), at.y(), at.z());
}

}  // namespace

GreyWindow automaticWindow(const Image& ct) {
  constexpr std::size_t kEnough = 100000;
  const std::size_t step = ct.voxels.size() / kEnough + 1;
  std::vector<float> values;
  for (std::size_t i = 0; i < ct.voxels.size(); i += step)
    if (static_cast<double>(ct.voxels[i]) > kAirHu) values.push_back(ct.voxels[i]);
  if (values.empty()) return {};
  const auto percentile = [&](double share) {
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return static_cast<double>(*at);
  };
  const double low = percentile(0.02), high = percentile(0.98);
  return {(low + high) / 2, std::max(20.0, high - low)};
}

CaseSlices::CaseSlices(Case& document, ViewState& view, QWidget* parent)
    : QWidget(parent),
      case_(document),
      view_(view),
      grid_(new QGridLayout),
      legend_(new QLabel(this)),
      readout_(new QLabel(this)),
      preset_(new QComboBox(this)) {
  setObjectName("caseSlices");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  grid_->setSpacing(2);
  column->addLayout(grid_, 1);
  addViews();
  addBottom();
  caseChanged_ = document.changed.connect([this](Case::Part) {
    if (isVisible()) follow();
  });
  viewChanged_ = view.changed.connect([this] {
    if (isVisible()) follow();
  });
  wanderTo_ = view.wanderTo.connect([this](const Vector3d& mm) { moveCursors(mm, nullptr); });
}

void CaseSlices::addViews() {
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal}) {
    auto* slice = new SliceView(plane, this);
    const int index = static_cast<int>(views_.size());
    views_.push_back(slice);
    connect(slice, &SliceView::cursorMoved, this,
            [this, slice](const Vector3d& mm) { moveCursors(mm, slice); });
    connect(slice, &SliceView::touched, this, [this](const SliceTouch& touch) { view_.touched.emit(touch); });
    connect(slice, &SliceView::windowDragged, this, [this](const GreyWindow& window) {
      view_.edit([&](ViewOptions& options) { options.greyWindow = window; });
    });
    connect(slice, &SliceView::brushScaled, this, [this](double factor) {
      view_.edit([&](ViewOptions& options) {
        options.sliceBrushMm = std::clamp(options.sliceBrushMm * factor, kLeastBrushMm, kMostBrushMm);
      });
    });
    connect(slice, &SliceView::toolLeft, this,
            [this] { view_.edit([](ViewOptions& options) { options.sliceTool = SliceTool::Look; }); });
    connect(slice, &SliceView::enlargeWanted, this, [this, index] {
      large_ = index;
      arrangedLarge_.reset();
      arrange();
    });
    connect(slice, &SliceView::hovered, this, &CaseSlices::showReadout);
    connect(slice, &SliceView::hoverEnded, readout_, &QLabel::clear);
  }
}

void CaseSlices::addBottom() {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(6, 0, 6, 0);
  legend_->setObjectName("sliceLegend");
  legend_->setTextFormat(Qt::RichText);
  legend_->setWordWrap(true);
  legend_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  readout_->setObjectName("sliceReadout");
  readout_->setContentsMargins(6, 0, 6, 2);
  readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  readout_->setToolTip(tr("Under the mouse: place in patient LPS, mm; value of the CT in HU; label"));
  preset_->setObjectName("windowPreset");
  preset_->setToolTip(
      tr("Grey window of the CT: width and level in HU. A right drag in a slice changes both: to the right "
         "wider, upwards a higher level"));
  preset_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  for (const GreyPreset& preset : greyPresets())
    preset_->addItem(tr("%1 (W %2, L %3)")
                         .arg(tr(preset.name))
                         .arg(preset.window.width, 0, 'f', 0)
                         .arg(preset.window.level, 0, 'f', 0));
  preset_->addItem(tr("Automatic"));
  preset_->addItem(tr("By hand"));
  connect(preset_, qOverload<int>(&QComboBox::activated), this, &CaseSlices::choosePreset);
  row->addWidget(legend_, 1);
  row->addWidget(preset_);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addLayout(row);
  column->addWidget(readout_);
}

void CaseSlices::choosePreset(int index) {
  const auto count = static_cast<int>(greyPresets().size());
  if (index > count) return;  // as it is
  view_.edit([&](ViewOptions& options) {
    if (index < count)
      options.greyWindow = greyPresets()[static_cast<std::size_t>(index)].window;
    else if (case_.ct())
      options.greyWindow = automaticWindow(*case_.ct());
  });
}

void CaseSlices::moveCursors(const Vector3d& mm, const SliceView* but) {
  for (SliceView* view : views_)
    if (view != but) view->setCursorMm(mm);
}

void CaseSlices::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follow();
}

void CaseSlices::arrange() {
  const bool large = view_.options().slicesLarge;
  if (arrangedLarge_ == large) return;
  arrangedLarge_ = large;
  for (SliceView* view : views_) grid_->removeWidget(view);
  int small = 0;
  for (int v = 0; v < static_cast<int>(views_.size()); ++v) {
    SliceView* view = views_[static_cast<std::size_t>(v)];
    if (!large)
      grid_->addWidget(view, 0, v);
    else if (v == large_)
      grid_->addWidget(view, 0, 0, 2, 1);
    else
      grid_->addWidget(view, small++, 1);
  }
  for (int c = 0; c < 3; ++c)
    grid_->setColumnStretch(c, !large ? 1 : c == 0 ? kLargeShare : c == 1 ? kSmallShare : 0);
  for (int r = 0; r < 2; ++r) grid_->setRowStretch(r, large || r == 0 ? 1 : 0);
}

void CaseSlices::followExtent() {
  const bool hasPreop = case_.preop() && case_.preop()->size() > 0;
  const bool whole = view_.options().slicesLarge || !hasPreop;
  Box box;
  if (whole && case_.ct() && !case_.ct()->voxels.empty())
    box = boxOf(*case_.ct());
  else if (whole && case_.labels() && !case_.labels()->voxels.empty())
    box = boxOf(*case_.labels());
  else if (hasPreop)
    box = boxOf(*case_.preop());
  else
    return;
  if ((box.first - low_).norm() < 1e-6 && (box.second - high_).norm() < 1e-6) return;
  const Vector3d cursor = views_.front()->cursorMm();
  const bool keep = low_ != high_ && (cursor.array() >= box.first.array()).all() &&
                    (cursor.array() <= box.second.array()).all();
  low_ = box.first;
  high_ = box.second;
  for (SliceView* view : views_) view->setExtent(low_, high_);
  if (keep) moveCursors(cursor, nullptr);
}

void CaseSlices::followOutlines() {
  const ViewOptions& options = view_.options();
  std::vector<SliceOutline> outlines;
  const auto visible = [&](const std::string& part) {
    const PartLook look = view_.look(part);
    return look.visible && look.opacity > 0;
  };
  const auto add = [&](const std::string& part, const std::shared_ptr<const Surface>& was,
                       const std::shared_ptr<const Surface>& is) {
    if (!was || !visible(part)) return;
    outlines.push_back({was, before(), true});
    if (is) outlines.push_back({is, kAfter, false});
  };
  const bool updated = options.updateShown && options.liveDeformed;
  if (options.previewSurface && !options.previewIsSketch)
    outlines.push_back({options.previewSurface, kAfter, false});
  else
    add(part::kPreop, case_.preop(), updated ? options.liveDeformed : nullptr);
  for (const auto& [name, surface] : case_.structures()) {
    const auto moved = options.movedStructures.find(name);
    add(part::structure(name), surface,
        updated && moved != options.movedStructures.end() ? moved->second : nullptr);
  }
  for (SliceView* view : views_) view->setOutlines(outlines);
  const QString picture = case_.ct()       ? tr("CT as imaged")
                          : case_.labels() ? tr("label map as imaged (no CT in the case)")
                                           : tr("no CT and no label map in the case");
  QString lines;
  if (!outlines.empty() && (!options.previewSurface || options.previewIsSketch))
    lines = swatch(before(), QString::fromUtf8("– –")) +
            (case_.registration() ? tr("as registered") : tr("surfaces of the case")) + "&nbsp;&nbsp; ";
  if (updated) lines += swatch(kAfter, QString::fromUtf8("——")) + tr("as updated") + "&nbsp;&nbsp; ";
  if (options.previewSurface && !options.previewIsSketch)
    lines += swatch(kAfter, QString::fromUtf8("——")) + tr("surface to be accepted") + "&nbsp;&nbsp; ";
  // To work in they need all the room; the place under the mouse is told with its frame.
  legend_->setText(lines + picture + (options.slicesLarge ? QString() : tr(". Patient's frame (LPS), mm")));
}

void CaseSlices::follow() {
  const ViewOptions& options = view_.options();
  arrange();
  followExtent();
  // Without a CT the label map is the picture.
  const bool labels = !case_.ct() || (options.slicesLarge && options.labelsShown);
  const SliceContent content{.ct = case_.ct(),
                             .labels = options.liveLabels ? options.liveLabels
                                       : labels           ? case_.labels()
                                                          : nullptr,
                             .forbidden = options.slicesLarge ? options.forbidden : nullptr,
                             .labelEdits = options.labelEdits,
                             .labelColours = options.labelColours,
                             .window = options.greyWindow,
                             .seeds = options.slicesLarge ? options.seeds : nullptr,
                             .tool = options.sliceTool,
                             .brushMm = options.sliceBrushMm};
  for (SliceView* view : views_) view->setContent(content);
  followOutlines();
  preset_->setEnabled(case_.ct() != nullptr);
  const auto& presets = greyPresets();
  const auto known = std::find_if(presets.begin(), presets.end(), [&](const GreyPreset& preset) {
    return preset.window == options.greyWindow;
  });
  const QSignalBlocker quiet(preset_);
  preset_->setCurrentIndex(known != presets.end() ? static_cast<int>(known - presets.begin())
                                                  : preset_->count() - 1);
}

void CaseSlices::showReadout(const Vector3d& mm) {
  QStringList parts{
      QString("(%1, %2, %3) mm LPS").arg(mm.x(), 0, 'f', 1).arg(mm.y(), 0, 'f', 1).arg(mm.z(), 0, 'f', 1)};
  if (const auto hu = valueAt(case_.ct(), mm))
    parts << tr("%1 HU").arg(static_cast<double>(*hu), 0, 'f', 0);
  else
    parts << (case_.ct() ? tr("outside the CT") : tr("no CT"));
  const auto& live = view_.options().liveLabels;
  if (const auto label = valueAt(live ? live : case_.labels(), mm))
    parts << (*label == 0 ? tr("background") : tr("label %1").arg(*label));
  readout_->setText(parts.join(QString::fromUtf8(" · ")));
}

}  // namespace falciform
