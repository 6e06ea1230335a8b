#include "Widgets/Views/SliceView.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "Logic/Geometry/PlaneSection.h"

namespace falciform {
namespace {

const std::array<const char*, 3> kNames{"Axial", "Coronal", "Sagittal"};
const std::array<const char*, 3> kAxisNames{"x", "y", "z"};
constexpr double kFilled = 0.25, kFilledAlone = 0.5;       // share of opacity, over a CT and without
constexpr double kSeedNearMm = 2.5, kSeedFarMm = 15;       // from the cut: full, faint
const QColor kSeed(255, 69, 58), kForbidden(255, 90, 80);  // red stands for nothing else here

}  // namespace

SliceView::SliceView(SlicePlane plane, QWidget* parent)
    : QWidget(parent), plane_(plane), axes_(axesOf(plane)) {
  setObjectName(QString("slice%1").arg(kNames[static_cast<std::size_t>(plane)]));
  setToolTip(tr(
      "A cut through the patient as imaged, patient LPS, mm. Click: the other cuts go there. Wheel: next "
      "cut, 2 mm a step; with Ctrl: zoom. Right drag: window and level. Middle drag: shift. R: all. Double "
      "click: large"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setExtent(low_, high_);
}

void SliceView::setContent(const SliceContent& content) {
  const SliceContent& old = content_;
  greyOld_ |= content.ct != old.ct || !(content.window == old.window);
  labelsOld_ |= content.labels != old.labels || content.forbidden != old.forbidden ||
                content.labelEdits != old.labelEdits || content.labelColours != old.labelColours ||
                (content.ct != nullptr) != (old.ct != nullptr);
  content_ = content;
  setCursor(content.tool == SliceTool::Look ? Qt::ArrowCursor : Qt::CrossCursor);
  update();
}

void SliceView::setOutlines(std::vector<SliceOutline> outlines) {
  outlines_ = std::move(outlines);
  update();
}

void SliceView::setExtent(const Vector3d& low, const Vector3d& high) {
  low_ = low;
  high_ = high;
  imagesAreOld();
  endZoom();
  setCursorMm((low + high) / 2);
}

void SliceView::setCursorMm(const Vector3d& mm) {
  const Vector3d inner = mm.cwiseMax(low_).cwiseMin(high_);
  if (inner[axes_.through] != at()) imagesAreOld();
  cursor_ = inner;
  update();
}

void SliceView::imagesAreOld() { greyOld_ = labelsOld_ = true; }

void SliceView::moveTo(const Vector3d& mm) {
  setCursorMm(mm);
  Q_EMIT cursorMoved(cursor_);
}

void SliceView::endZoom() {
  zoom_ = 1;
  centre_ = axes_.onScreen((low_ + high_) / 2);
  imagesAreOld();
  update();
}

double SliceView::pixelsPerMm() const {
  const QPointF box = axes_.onScreen(low_) - axes_.onScreen(high_);
  return zoom_ *
         std::min(width() / std::max(1.0, std::abs(box.x())), height() / std::max(1.0, std::abs(box.y())));
}

QRectF SliceView::shownMm() const {
  const QSizeF size = QSizeF(this->size()) / pixelsPerMm();
  return {centre_ - QPointF(size.width(), size.height()) / 2, size};
}

QPointF SliceView::positionOf(const Vector3d& mm) const {
  return (axes_.onScreen(mm) - shownMm().topLeft()) * pixelsPerMm();
}

Vector3d SliceView::placeOf(const QPointF& pixel) const {
  return axes_.inPatient(shownMm().topLeft() + pixel / pixelsPerMm(), at());
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(18, 20, 24));
  drawImages(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(255, 255, 255, 90), 1));
  const QPointF cross = positionOf(cursor_);
  painter.drawLine(QPointF(0, cross.y()), QPointF(width(), cross.y()));
  painter.drawLine(QPointF(cross.x(), 0), QPointF(cross.x(), height()));
  drawOutlines(painter);
  drawSeeds(painter);
  drawBrush(painter);
  drawWords(painter);
}

void SliceView::resizeEvent(QResizeEvent*) { imagesAreOld(); }

void SliceView::drawImages(QPainter& painter) {
  const QSize pixels = (QSizeF(size()) * std::min(1.5, devicePixelRatioF())).toSize();
  if (pixels.isEmpty()) return;
  if (greyOld_)
    grey_ = content_.ct ? sliceOf(*content_.ct, plane_, at(), shownMm(), pixels, content_.window) : QImage();
  if (labelsOld_) {
    const auto colour = [this](int label) {
      const auto own = content_.labelColours.find(label);
      const auto rgb = own == content_.labelColours.end() ? labelColour(label) : own->second;
      return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
    };
    labels_ = content_.labels ? labelsOf(*content_.labels, plane_, at(), shownMm(), pixels, colour,
                                         content_.ct ? kFilled : kFilledAlone)
                              : QImage();
    hatch_ = content_.forbidden ? hatchOf(*content_.forbidden, plane_, at(), shownMm(), pixels, kForbidden)
                                : QImage();
  }
  greyOld_ = labelsOld_ = false;
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  for (const QImage* image : {&grey_, &labels_, &hatch_})
    if (!image->isNull()) painter.drawImage(QRectF(rect()), *image);
}

void SliceView::drawOutlines(QPainter& painter) {
  std::map<std::shared_ptr<const Surface>, Section> used;
  for (const SliceOutline& outline : outlines_) {
    if (!outline.surface) continue;
    Section& section = used[outline.surface];
    const auto known = sections_.find(outline.surface);
    if (known != sections_.end() && known->second.at == at())
      section = known->second;
    else if (section.ends.rows() == 0)
      section = {at(), planeSection(*outline.surface, axes_.through, at())};
    QVector<QLineF> lines;
    for (Index s = 0; s < section.ends.rows() / 2; ++s)
      lines << QLineF(positionOf(section.ends.row(2 * s).transpose()),
                      positionOf(section.ends.row(2 * s + 1).transpose()));
    // Segments are short, so dashes are made of whole ones, by where they lie.
    if (outline.dashed)
      lines.erase(std::remove_if(lines.begin(), lines.end(),
                                 [](const QLineF& line) {
                                   return (static_cast<int>(line.center().x() + line.center().y()) / 5) % 2;
                                 }),
                  lines.end());
    painter.setPen(QPen(outline.colour, 1.6));
    painter.drawLines(lines);
  }
  sections_ = std::move(used);
}

void SliceView::drawSeeds(QPainter& painter) const {
  if (!content_.seeds) return;
  for (Index s = 0; s < content_.seeds->rows(); ++s) {
    const Vector3d mm = content_.seeds->row(s).transpose();
    const double away = std::abs(mm[axes_.through] - at());
    if (away > kSeedFarMm) continue;
    const QPointF place = positionOf(mm);
    QColor colour = kSeed;
    if (away > kSeedNearMm) colour.setAlpha(120);
    painter.setPen(QPen(QColor(255, 255, 255, colour.alpha()), 1.2));
    painter.setBrush(away > kSeedNearMm ? QBrush(Qt::NoBrush) : QBrush(colour));
    if (away > kSeedNearMm) painter.setPen(QPen(colour, 1.2));
    painter.drawEllipse(place, 4.5, 4.5);
    painter.setPen(QColor(255, 235, 230, colour.alpha()));
    painter.drawText(place + QPointF(7, -5), QString::number(s + 1));
  }
  painter.setBrush(Qt::NoBrush);
}

bool SliceView::brushing() const {
  return content_.tool == SliceTool::Paint || content_.tool == SliceTool::Erase;
}

void SliceView::drawBrush(QPainter& painter) const {
  if (!brushing() || !mouse_) return;
  const double radius = content_.brushMm * pixelsPerMm();
  painter.setPen(QPen(QColor(0, 0, 0, 160), 3));
  painter.drawEllipse(*mouse_, radius, radius);
  painter.setPen(QPen(content_.tool == SliceTool::Erase ? kForbidden : QColor(120, 230, 140), 1.4));
  painter.drawEllipse(*mouse_, radius, radius);
}

void SliceView::drawWords(QPainter& painter) const {
  const QRectF inside = QRectF(rect()).adjusted(5, 3, -5, -3);
  const auto word = [&](Qt::Alignment where, const QString& text) {
    painter.setPen(QColor(0, 0, 0, 200));
    painter.drawText(inside.translated(1, 1), static_cast<int>(where), text);
    painter.setPen(QColor(235, 238, 242));
    painter.drawText(inside, static_cast<int>(where), text);
  };
  word(Qt::AlignLeft | Qt::AlignTop,
       QString("%1, %2 = %3 mm")
           .arg(kNames[static_cast<std::size_t>(plane_)], kAxisNames[static_cast<std::size_t>(axes_.through)])
           .arg(at(), 0, 'f', 0));
  word(Qt::AlignLeft | Qt::AlignVCenter, axes_.left);
  word(Qt::AlignRight | Qt::AlignVCenter, axes_.right);
  word(Qt::AlignRight | Qt::AlignTop, axes_.top);
  word(Qt::AlignHCenter | Qt::AlignBottom, axes_.bottom);
  if (content_.ct)
    word(Qt::AlignLeft | Qt::AlignBottom,
         QString("W %1 L %2").arg(content_.window.width, 0, 'f', 0).arg(content_.window.level, 0, 'f', 0));
}

}  // namespace falciform
