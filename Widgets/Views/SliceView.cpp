#include "Widgets/Views/SliceView.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>

#include "Logic/Geometry/PlaneSection.h"

namespace falciform {
namespace {

const std::array<const char*, 3> kNames{"Axial", "Coronal", "Sagittal"};
const std::array<const char*, 3> kAxisNames{"x", "y", "z"};
constexpr double kWheelMm = 2;

}  // namespace

SliceView::SliceView(SlicePlane plane, QWidget* parent)
    : QWidget(parent), plane_(plane), axes_(axesOf(plane)) {
  setObjectName(QString("slice%1").arg(kNames[static_cast<std::size_t>(plane)]));
  setToolTip(
      tr("A cut through the patient as imaged, patient LPS, mm. Click: the other cuts go there. Wheel: next "
         "cut, 2 mm a step."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SliceView::setVolume(std::shared_ptr<const Image> ct, std::shared_ptr<const LabelMap> labels) {
  if (ct == ct_ && labels == labels_) return;
  ct_ = std::move(ct);
  labels_ = std::move(labels);
  imageOld_ = true;
  update();
}

void SliceView::setOutlines(std::vector<SliceOutline> outlines) {
  outlines_ = std::move(outlines);
  update();
}

void SliceView::setExtent(const Vector3d& low, const Vector3d& high) {
  low_ = low;
  high_ = high;
  setCursorMm((low + high) / 2);
}

void SliceView::setCursorMm(const Vector3d& mm) {
  cursor_ = mm.cwiseMax(low_).cwiseMin(high_);
  imageOld_ = true;
  update();
}

void SliceView::moveTo(const Vector3d& mm) {
  setCursorMm(mm);
  Q_EMIT cursorMoved(cursor_);
}

QRectF SliceView::shownMm() const {
  const QPointF a = axes_.onScreen(low_), b = axes_.onScreen(high_);
  return QRectF(a, b).normalized();
}

QRectF SliceView::frame() const {
  const QRectF mm = shownMm();
  const double scale = std::min(width() / std::max(1.0, mm.width()), height() / std::max(1.0, mm.height()));
  const QSizeF size(mm.width() * scale, mm.height() * scale);
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QPointF SliceView::positionOf(const Vector3d& mm) const {
  const QRectF from = shownMm(), to = frame();
  const QPointF place = axes_.onScreen(mm);
  return {to.left() + (place.x() - from.left()) * to.width() / from.width(),
          to.top() + (place.y() - from.top()) * to.height() / from.height()};
}

void SliceView::pointAt(const QPointF& pixel) {
  const QRectF from = frame(), to = shownMm();
  if (from.isEmpty()) return;
  moveTo(axes_.inPatient({to.left() + (pixel.x() - from.left()) * to.width() / from.width(),
                          to.top() + (pixel.y() - from.top()) * to.height() / from.height()},
                         at()));
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(18, 20, 24));
  const QRectF picture = frame();
  const QSize pixels = (picture.size() * std::min(1.5, devicePixelRatioF())).toSize();
  if ((ct_ || labels_) && !pixels.isEmpty()) {
    if (imageOld_ || image_.size() != pixels)
      image_ = ct_ ? sliceOf(*ct_, plane_, at(), shownMm(), pixels)
                   : sliceOf(*labels_, plane_, at(), shownMm(), pixels);
    imageOld_ = false;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(picture, image_);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(255, 255, 255, 90), 1));
  const QPointF cross = positionOf(cursor_);
  painter.drawLine(QPointF(picture.left(), cross.y()), QPointF(picture.right(), cross.y()));
  painter.drawLine(QPointF(cross.x(), picture.top()), QPointF(cross.x(), picture.bottom()));
  drawOutlines(painter);
  drawWords(painter);
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

void SliceView::drawWords(QPainter& painter) const {
  painter.setPen(QColor(235, 238, 242));
  const QRectF inside = QRectF(rect()).adjusted(5, 3, -5, -3);
  painter.drawText(
      inside, Qt::AlignLeft | Qt::AlignTop,
      QString("%1, %2 = %3 mm")
          .arg(kNames[static_cast<std::size_t>(plane_)], kAxisNames[static_cast<std::size_t>(axes_.through)])
          .arg(at(), 0, 'f', 0));
  painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, axes_.left);
  painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, axes_.right);
  painter.drawText(inside, Qt::AlignRight | Qt::AlignTop, axes_.top);
  painter.drawText(inside, Qt::AlignHCenter | Qt::AlignBottom, axes_.bottom);
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pointAt(event->localPos());
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) pointAt(event->localPos());
}

void SliceView::wheelEvent(QWheelEvent* event) {
  wheel_ += event->angleDelta().y() / 120.0;
  const int steps = static_cast<int>(wheel_);
  wheel_ -= steps;
  Vector3d next = cursor_;
  next[axes_.through] += steps * kWheelMm;
  if (steps != 0) moveTo(next);
  event->accept();
}

}  // namespace falciform
