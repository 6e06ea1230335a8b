#pragma once
#include <QWidget>

#include "Widgets/Rendering/Histogram.h"
#include "Widgets/Rendering/ScalarMap.h"

namespace falciform {

/// How often which values occur, each bar in its colour on the surface, with the two ends of the colour scale
/// as handles: the mouse drags them; with the keyboard Left and Right move the marked one (Page keys by ten
/// steps), Space marks the other, Home asks for the automatic range. No OpenGL.
class RangeHistogram : public QWidget {
  Q_OBJECT

 public:
  enum class Limit { Low, High };

  explicit RangeHistogram(QWidget* parent = nullptr);

  /// What is counted; NaN is not. Values far beyond `scaleEnd` (more than twice) are counted at the edge.
  void setValues(VectorXd values, double scaleEnd);
  /// Colours, title, unit and limits; without announcing.
  void setColours(const ScalarMap& colours);
  /// The two limits stay the same distance from 0.
  void setSymmetric(bool symmetric);
  void setEmptyText(const QString& text);
  void clear();

  [[nodiscard]] double low() const { return colours_.low; }
  [[nodiscard]] double high() const { return colours_.high; }
  [[nodiscard]] Limit marked() const { return marked_; }
  [[nodiscard]] bool empty() const { return counted_ == 0; }
  /// Where a value stands in this widget, and what stands there.
  [[nodiscard]] double positionOf(double value) const;
  [[nodiscard]] double valueAt(double x) const;
  /// Of the bar at this place: from, to, number, share; empty where there is none.
  [[nodiscard]] QString barText(double x) const;

  QSize sizeHint() const override { return {320, 160}; }
  QSize minimumSizeHint() const override { return {200, 130}; }

 Q_SIGNALS:
  /// The user moves a limit.
  void limitsChanged(double low, double high);
  void automaticWanted();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRectF plotArea() const;
  [[nodiscard]] QFont smallFont() const;
  [[nodiscard]] bool isNear(Limit limit, double x) const;
  void count();
  void move(Limit limit, double value);
  void describe();
  void drawBars(QPainter& painter, const QRectF& plot, double tallest) const;
  void drawHandle(QPainter& painter, const QRectF& plot, Limit limit) const;

  VectorXd values_;
  ScalarMap colours_;
  Histogram histogram_;
  Index counted_ = 0;
  double scaleEnd_ = 1, reach_ = 1;  ///< the axis runs from -reach_ to reach_
  double grip_ = 0;                  ///< from the mouse to the handle, pixels
  bool symmetric_ = true, dragging_ = false;
  Limit marked_ = Limit::High;
  QString emptyText_;
};

}  // namespace falciform
