#include "Widgets/Views/RangeHistogram.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace falciform {
namespace {

constexpr double kGripPx = 9;     // how near a handle the mouse takes it
constexpr double kFarthest = 2;   // the axis goes no farther than this many scales
constexpr double kRoom = 1.3;     // and leaves this much to drag a limit outwards
constexpr int kStepsAHalf = 100;  // of the keyboard, from 0 to the axis's end
constexpr int kPageSteps = 10;

QColor screenColour(const Vector3d& colour) { return QColor::fromRgbF(colour.x(), colour.y(), colour.z()); }

QString number(double value) { return QString::number(value, 'g', 4); }

}  // namespace

RangeHistogram::RangeHistogram(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Histogram with the limits of the colours"));
}

void RangeHistogram::setValues(VectorXd values, double scaleEnd) {
  values_ = std::move(values);
  scaleEnd_ = scaleEnd > 0 ? scaleEnd : 1;
  count();
}

void RangeHistogram::setColours(const ScalarMap& colours) {
  const bool limitsMoved = colours.low != colours_.low || colours.high != colours_.high;
  colours_ = colours;
  if (limitsMoved && !dragging_) count();  // under the mouse the axis stands still
  describe();
  update();
}

void RangeHistogram::setSymmetric(bool symmetric) { symmetric_ = symmetric; }

void RangeHistogram::setEmptyText(const QString& text) {
  emptyText_ = text;
  update();
}

void RangeHistogram::clear() { setValues({}, 1); }

void RangeHistogram::count() {
  double largest = 0;
  counted_ = 0;
  for (const double value : values_)
    if (std::isfinite(value)) {
      largest = std::max(largest, std::abs(value));
      ++counted_;
    }
  reach_ = std::max({std::min(largest, kFarthest * scaleEnd_), kRoom * std::abs(colours_.low),
                     kRoom * std::abs(colours_.high), 1e-9});
  const double width = binWidth(-reach_, reach_);
  reach_ = width * std::ceil(reach_ / width - 1e-9);
  histogram_ = histogramOf(values_, -reach_, reach_, width);
  describe();
  update();
}

QFont RangeHistogram::smallFont() const {
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.88);
  return small;
}

QRectF RangeHistogram::plotArea() const {
  const int line = QFontMetrics(smallFont()).height();
  return QRectF(rect()).adjusted(14, line + 12, -14, -(2 * line + 7));
}

double RangeHistogram::positionOf(double value) const {
  const QRectF plot = plotArea();
  return plot.left() + (value + reach_) / (2 * reach_) * plot.width();
}

double RangeHistogram::valueAt(double x) const {
  const QRectF plot = plotArea();
  return (x - plot.left()) / std::max(1.0, plot.width()) * 2 * reach_ - reach_;
}

QString RangeHistogram::barText(double x) const {
  const double value = valueAt(x);
  const auto bin = static_cast<long>(std::floor((value - histogram_.low) / histogram_.width));
  const auto bins = static_cast<long>(histogram_.shares.size());
  if (empty() || bin < 0 || bin >= bins) return {};
  const double from = histogram_.low + static_cast<double>(bin) * histogram_.width;
  const double share = histogram_.shares[static_cast<std::size_t>(bin)];
  const QString unit = QString::fromStdString(colours_.unit);
  const QString span = bin == 0 ? tr("up to %1 %2").arg(number(from + histogram_.width), unit)
                       : bin == bins - 1
                           ? tr("%1 %2 and more").arg(number(from), unit)
                           : tr("%1 to %2 %3").arg(number(from)).arg(number(from + histogram_.width), unit);
  return tr("%1: %L2 places (%3 %)")
      .arg(span)
      .arg(std::lround(share * static_cast<double>(counted_)))
      .arg(100 * share, 0, 'f', 1);
}

bool RangeHistogram::isNear(Limit limit, double x) const {
  return std::abs(x - positionOf(limit == Limit::Low ? low() : high())) <= kGripPx;
}

void RangeHistogram::move(Limit limit, double value) {
  const double step = reach_ / kStepsAHalf;
  value = std::clamp(step * std::round(value / step), -reach_, reach_);
  double low = colours_.low, high = colours_.high;
  if (symmetric_) {
    high = std::max(step, limit == Limit::High ? value : -value);
    low = -high;
  } else if (limit == Limit::Low) {
    low = std::min(value, high - step);
  } else {
    high = std::max(value, low + step);
  }
  if (low == colours_.low && high == colours_.high) return;
  colours_.low = low;
  colours_.high = high;
  describe();
  update();
  Q_EMIT limitsChanged(low, high);
}

// For screen readers, which see no bars.
void RangeHistogram::describe() {
  setAccessibleDescription(empty() ? emptyText_
                                   : tr("%L1 values; colours from %2 to %3 %4; the %5 limit is marked")
                                         .arg(counted_)
                                         .arg(number(low()), number(high()),
                                              QString::fromStdString(colours_.unit),
                                              marked_ == Limit::Low ? tr("lower") : tr("upper")));
}

void RangeHistogram::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || empty()) return;
  const double x = event->localPos().x();
  for (const Limit limit : {Limit::High, Limit::Low})
    if (isNear(limit, x)) {
      marked_ = limit;
      dragging_ = true;
      grip_ = positionOf(limit == Limit::Low ? low() : high()) - x;
      describe();
      update();
      return;
    }
}

void RangeHistogram::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->localPos().x();
  if (dragging_) return move(marked_, valueAt(x + grip_));
  const bool near = !empty() && (isNear(Limit::Low, x) || isNear(Limit::High, x));
  setCursor(near ? Qt::SizeHorCursor : Qt::ArrowCursor);
}

void RangeHistogram::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragging_) return;
  dragging_ = false;
  count();  // room to drag on
}

void RangeHistogram::mouseDoubleClickEvent(QMouseEvent*) {
  dragging_ = false;
  if (!empty()) Q_EMIT automaticWanted();
}

void RangeHistogram::keyPressEvent(QKeyEvent* event) {
  const double now = marked_ == Limit::Low ? low() : high(), step = reach_ / kStepsAHalf;
  if (empty()) return QWidget::keyPressEvent(event);
  switch (event->key()) {
    case Qt::Key_Left:
      return move(marked_, now - step);
    case Qt::Key_Right:
      return move(marked_, now + step);
    case Qt::Key_PageDown:
      return move(marked_, now - kPageSteps * step);
    case Qt::Key_PageUp:
      return move(marked_, now + kPageSteps * step);
    case Qt::Key_Home:
      Q_EMIT automaticWanted();
      return;
    case Qt::Key_Space:
      marked_ = marked_ == Limit::Low ? Limit::High : Limit::Low;
      describe();
      return update();
    default:
      return QWidget::keyPressEvent(event);
  }
}

bool RangeHistogram::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString bar = plotArea().contains(help->pos()) ? barText(help->pos().x()) : QString();
    if (!bar.isEmpty()) {
      QToolTip::showText(help->globalPos(), bar, this);
      return true;
    }
  }
  return QWidget::event(event);
}

void RangeHistogram::drawBars(QPainter& painter, const QRectF& plot, double tallest) const {
  for (std::size_t i = 0; i < histogram_.shares.size(); ++i) {
    const double from = histogram_.low + static_cast<double>(i) * histogram_.width;
    const double left = positionOf(from), right = positionOf(from + histogram_.width);
    const double height = histogram_.shares[i] / tallest * plot.height();
    painter.setPen(QPen(QColor(0, 0, 0, 60), 0.6));
    painter.setBrush(screenColour(colourOf(colours_, from + histogram_.width / 2)));
    if (height > 0) painter.drawRect(QRectF(left, plot.bottom() - height, right - left, height));
  }
}

void RangeHistogram::drawHandle(QPainter& painter, const QRectF& plot, Limit limit) const {
  const double value = limit == Limit::Low ? low() : high();
  const double x = positionOf(value);
  const bool strong = limit == marked_ && hasFocus();
  const QColor ink = strong ? palette().highlight().color() : palette().text().color();
  painter.setPen(QPen(ink, strong ? 2.2 : 1.4));
  painter.drawLine(QPointF(x, plot.top() - 4), QPointF(x, plot.bottom()));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  const QPointF grip[] = {{x - 5, plot.top() - 9}, {x + 5, plot.top() - 9}, {x, plot.top() - 1}};
  painter.drawPolygon(grip, 3);
  painter.setPen(palette().text().color());
  const QFontMetrics metrics(painter.font());
  const QString text = (value > 0 ? "+" : "") + number(value);
  const double half = metrics.horizontalAdvance(text) / 2.0 + 2;
  const double middle = std::clamp(x, half, width() - half);
  painter.drawText(QRectF(middle - half, plot.top() - 11 - metrics.height(), 2 * half, metrics.height()),
                   Qt::AlignCenter, text);
}

void RangeHistogram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  painter.setFont(smallFont());
  if (empty()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, emptyText_);
    return;
  }
  const QRectF plot = plotArea();
  const int line = QFontMetrics(painter.font()).height();
  const double tallest = *std::max_element(histogram_.shares.begin(), histogram_.shares.end());
  drawBars(painter, plot, tallest);
  painter.setPen(palette().text().color());
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  for (const double tick : tickValues(-reach_, reach_, 7)) {
    const double x = positionOf(tick);
    painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 3));
    painter.drawText(QRectF(x - 40, plot.bottom() + 3, 80, line), Qt::AlignHCenter | Qt::AlignTop,
                     (tick > 0 ? "+" : "") + number(tick));
  }
  QString title = QString::fromStdString(colours_.title);
  if (!colours_.unit.empty()) title += ", " + QString::fromStdString(colours_.unit);
  painter.drawText(QRectF(0, height() - line - 1, width(), line), Qt::AlignCenter, title);
  drawHandle(painter, plot, Limit::Low);
  drawHandle(painter, plot, Limit::High);
  if (hasFocus()) {
    painter.setPen(QPen(palette().highlight().color(), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

}  // namespace falciform
