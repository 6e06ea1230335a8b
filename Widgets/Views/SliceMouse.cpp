#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "Widgets/Views/SliceView.h"

// What mouse and keys do in a slice.

namespace falciform {
namespace {

constexpr double kWheelMm = 2;
constexpr double kZoomStep = 1.15, kMostZoom = 20;
constexpr double kDragPx = 200;  ///< of a right drag that double the window's width, or move it by its width
constexpr double kLeastWidth = 2;
constexpr double kBrushUp = 1.2, kBrushDown = 0.8;

}  // namespace

SliceView::Drag SliceView::dragOf(const QMouseEvent& event) const {
  const auto modifiers = event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier);
  switch (event.button()) {
    case Qt::LeftButton:
      if (modifiers & Qt::ShiftModifier) return Drag::Pan;
      return modifiers || content_.tool == SliceTool::Look ? Drag::Cursor : Drag::Tool;
    case Qt::MiddleButton:
      return Drag::Pan;
    case Qt::RightButton:
      return content_.ct ? Drag::Window : Drag::None;
    default:
      return Drag::None;
  }
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (drag_ != Drag::None) return;  // a second button
  drag_ = dragOf(*event);
  pressed_ = event->localPos();
  pressedCentre_ = centre_;
  pressedWindow_ = content_.window;
  const Vector3d mm = placeOf(event->localPos());
  if (drag_ == Drag::Cursor || (drag_ == Drag::Tool && content_.tool == SliceTool::Seed)) moveTo(mm);
  if (drag_ == Drag::Tool) Q_EMIT touched({SliceTouch::What::Press, mm});
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  mouse_ = event->localPos();
  const QPointF way = event->localPos() - pressed_;
  switch (drag_) {
    case Drag::None:
      break;
    case Drag::Cursor:
      moveTo(placeOf(event->localPos()));
      break;
    case Drag::Tool:
      Q_EMIT touched({SliceTouch::What::Move, placeOf(event->localPos())});
      break;
    case Drag::Window: {
      GreyWindow window = pressedWindow_;
      window.width = std::max(kLeastWidth, window.width * std::exp2(way.x() / kDragPx));
      window.level -= way.y() / kDragPx * pressedWindow_.width;
      Q_EMIT windowDragged(window);
      break;
    }
    case Drag::Pan:
      centre_ = pressedCentre_ - way / pixelsPerMm();
      imagesAreOld();
      break;
  }
  if (brushing() || drag_ == Drag::Pan) update();
  Q_EMIT hovered(placeOf(event->localPos()));
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  if (std::exchange(drag_, Drag::None) == Drag::Tool)
    Q_EMIT touched({SliceTouch::What::Release, placeOf(event->localPos())});
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && content_.tool == SliceTool::Look)
    Q_EMIT enlargeWanted();
  else if (content_.tool != SliceTool::Seed)  // one seed is enough
    mousePressEvent(event);
}

void SliceView::step(int cuts) {
  Vector3d next = cursor_;
  next[axes_.through] += cuts * kWheelMm;
  moveTo(next);
}

void SliceView::zoomAt(const QPointF& pixel, double factor) {
  const QPointF middle(width() / 2.0, height() / 2.0);
  const QPointF held = centre_ + (pixel - middle) / pixelsPerMm();
  zoom_ = std::clamp(zoom_ * factor, 1.0, kMostZoom);
  centre_ = held - (pixel - middle) / pixelsPerMm();
  if (zoom_ == 1) return endZoom();
  imagesAreOld();
  update();
}

void SliceView::wheelEvent(QWheelEvent* event) {
  event->accept();
  // Alt turns the wheel sideways.
  const QPoint delta = event->angleDelta();
  wheel_ += (delta.y() != 0 ? delta.y() : delta.x()) / 120.0;
  const int steps = static_cast<int>(wheel_);
  wheel_ -= steps;
  if (steps == 0) return;
  if (event->modifiers() & Qt::ControlModifier) return zoomAt(event->position(), std::pow(kZoomStep, steps));
  if ((event->modifiers() & Qt::ShiftModifier) && brushing()) {
    Q_EMIT brushScaled(steps > 0 ? kBrushUp : kBrushDown);
    return;
  }
  step(steps);
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      if (content_.tool == SliceTool::Look) break;
      Q_EMIT toolLeft();
      return;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      Q_EMIT brushScaled(kBrushUp);
      return;
    case Qt::Key_Minus:
      Q_EMIT brushScaled(kBrushDown);
      return;
    case Qt::Key_Up:
    case Qt::Key_PageUp:
      return step(1);
    case Qt::Key_Down:
    case Qt::Key_PageDown:
      return step(-1);
    case Qt::Key_R:
      return endZoom();
    case Qt::Key_Z:
    case Qt::Key_Y:
      if (event->modifiers() != Qt::NoModifier) break;
      Q_EMIT touched({event->key() == Qt::Key_Z ? SliceTouch::What::Undo : SliceTouch::What::Redo, cursor_});
      return;
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

void SliceView::leaveEvent(QEvent*) {
  mouse_.reset();
  update();
  Q_EMIT hoverEnded();
}

}  // namespace falciform
