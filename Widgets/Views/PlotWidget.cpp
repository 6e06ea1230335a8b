#include "Widgets/Views/PlotWidget.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "Widgets/Views/PlotAxis.h"

namespace falciform {

PlotWidget::PlotWidget(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void PlotWidget::setTitles(const QString& x, const QString& left, const QString& right) {
  xTitle_ = x;
  leftTitle_ = left;
  rightTitle_ = right;
  update();
}

void PlotWidget::setCurves(QVector<Curve> curves) {
  curves_ = std::move(curves);
  update();
}

void PlotWidget::setBars(QVector<Bars> bars) {
  bars_ = std::move(bars);
  update();
}

void PlotWidget::setMarkers(QVector<double> markers) {
  markers_ = std::move(markers);
  update();
}

void PlotWidget::clear() {
  curves_.clear();
  bars_.clear();
  markers_.clear();
  update();
}

void PlotWidget::setEmptyText(const QString& text) {
  emptyText_ = text;
  update();
}

// A curve without a name shows its colour beside its axis's title.
void PlotWidget::drawTitles(QPainter& painter, int line) const {
  constexpr int kSwatch = 14, kGap = 5, kMargin = 4;
  for (const bool right : {false, true}) {
    const auto own = std::find_if(curves_.begin(), curves_.end(), [right](const Curve& curve) {
      return curve.name.isEmpty() && curve.rightAxis == right;
    });
    const int room = own == curves_.end() ? 0 : kSwatch + kGap;
    const QRectF place(kMargin, 1, width() - 2 * kMargin, line);
    painter.drawText(place.adjusted(right ? 0 : room, 0, right ? -room : 0, 0),
                     Qt::AlignVCenter | (right ? Qt::AlignRight : Qt::AlignLeft),
                     right ? rightTitle_ : leftTitle_);
    if (room > 0)
      painter.fillRect(QRectF(right ? place.right() - kSwatch : place.left(), 1 + line / 2.0 - 2, kSwatch, 4),
                       own->colour);
  }
}

void PlotWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().base());
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.88);
  painter.setFont(small);
  const QFontMetrics metrics(small);
  const QColor ink = palette().text().color();
  QColor faint = ink;
  faint.setAlphaF(0.15);

  PlotAxis x, left, right;
  for (const Curve& curve : curves_)
    if (curve.logarithmic) (curve.rightAxis ? right : left) = PlotAxis(true);
  for (const Curve& curve : curves_) {
    x.include(curve.x);
    (curve.rightAxis ? right : left).include(curve.y);
    if (!curve.logarithmic) (curve.rightAxis ? right : left).include(0);
  }
  for (const Bars& bars : bars_) {
    x.include(bars.edges);
    left.include(bars.heights);
    left.include(0);
  }
  x.finish();
  left.finish();
  right.finish();
  if (x.empty() || left.empty()) {
    painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, emptyText_);
    return;
  }

  const int line = metrics.height();
  const auto widest = [&](const PlotAxis& axis) {
    int width = 0;
    for (const double tick : axis.ticks())
      width = std::max(width, metrics.horizontalAdvance(PlotAxis::label(tick)));
    return width;
  };
  const bool named =
      std::any_of(bars_.begin(), bars_.end(), [](const Bars& b) { return !b.name.isEmpty(); }) ||
      std::any_of(curves_.begin(), curves_.end(), [](const Curve& c) { return !c.name.isEmpty(); });
  const QRectF plot = QRectF(rect()).adjusted(widest(left) + 10, (named ? 2 * line : line) + 8,
                                              right.empty() ? -12 : -(widest(right) + 10), -(2 * line + 8));
  const auto at = [&](double px, double py, const PlotAxis& axis) {
    return QPointF(plot.left() + x.share(px) * plot.width(), plot.bottom() - axis.share(py) * plot.height());
  };

  for (const double tick : left.ticks()) {
    const double y = plot.bottom() - left.share(tick) * plot.height();
    painter.setPen(faint);
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(ink);
    painter.drawText(QRectF(0, y - line / 2.0, plot.left() - 5, line), Qt::AlignRight | Qt::AlignVCenter,
                     PlotAxis::label(tick));
  }
  for (const double tick : right.ticks()) {
    const double y = plot.bottom() - right.share(tick) * plot.height();
    painter.drawText(QRectF(plot.right() + 5, y - line / 2.0, width() - plot.right() - 5, line),
                     Qt::AlignLeft | Qt::AlignVCenter, PlotAxis::label(tick));
  }
  for (const double tick : x.ticks()) {
    const double px = plot.left() + x.share(tick) * plot.width();
    painter.setPen(faint);
    painter.drawLine(QPointF(px, plot.top()), QPointF(px, plot.bottom()));
    painter.setPen(ink);
    painter.drawText(QRectF(px - 40, plot.bottom() + 3, 80, line), Qt::AlignHCenter | Qt::AlignTop,
                     PlotAxis::label(tick));
  }
  painter.drawText(QRectF(plot.left(), height() - line - 2, plot.width(), line), Qt::AlignCenter, xTitle_);
  drawTitles(painter, line);

  double legendX = plot.left();
  const auto legend = [&](const QString& name, const QColor& colour) {
    if (name.isEmpty()) return;
    painter.fillRect(QRectF(legendX, line + 4 + line / 2.0 - 2, 14, 4), colour);
    painter.setPen(ink);
    painter.drawText(QPointF(legendX + 18, line + 4 + metrics.ascent()), name);
    legendX += 30 + metrics.horizontalAdvance(name);
  };
  painter.save();
  painter.setClipRect(plot.adjusted(-1, -1, 1, 1));
  for (const Bars& bars : bars_) {
    QColor fill = bars.colour;
    fill.setAlphaF(0.6);
    for (int i = 0; i < bars.heights.size(); ++i)
      painter.fillRect(QRectF(at(bars.edges[i], bars.heights[i], left), at(bars.edges[i + 1], 0, left)),
                       fill);
  }
  for (const Curve& curve : curves_) {
    const PlotAxis& axis = curve.rightAxis ? right : left;
    QPainterPath path;
    bool pen = false;
    for (int i = 0; i < curve.x.size(); ++i) {
      if (!std::isfinite(curve.y[i]) || (curve.logarithmic && curve.y[i] <= 0)) {
        pen = false;
        continue;
      }
      const QPointF point = at(curve.x[i], curve.y[i], axis);
      if (pen)
        path.lineTo(point);
      else
        path.moveTo(point);
      pen = true;
    }
    painter.setPen(QPen(curve.colour, 1.8));
    painter.drawPath(path);
  }
  painter.setPen(QPen(ink, 1, Qt::DashLine));
  for (const double marker : markers_)
    painter.drawLine(QPointF(at(marker, 0, left).x(), plot.top()),
                     QPointF(at(marker, 0, left).x(), plot.bottom()));
  painter.restore();
  for (const Bars& bars : bars_) legend(bars.name, bars.colour);
  for (const Curve& curve : curves_) legend(curve.name, curve.colour);
}

}  // namespace falciform
