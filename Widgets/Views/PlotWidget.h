#pragma once
#include <QColor>
#include <QString>
#include <QVector>
#include <QWidget>

namespace falciform {

/// A small plot drawn by QPainter: curves against a left and a right axis, bars, and upright marker lines.
/// Light enough to redraw twenty times a second while a job runs, and works without OpenGL.
class PlotWidget : public QWidget {
  Q_OBJECT

 public:
  struct Curve {
    QString name;  ///< empty: its axis's title names it
    QColor colour;
    QVector<double> x, y;
    bool rightAxis = false;
    bool logarithmic = false;  ///< of its axis; values must be > 0
  };
  struct Bars {
    QString name;
    QColor colour;
    QVector<double> edges;  ///< one more than heights, ascending
    QVector<double> heights;
  };

  explicit PlotWidget(QWidget* parent = nullptr);

  void setTitles(const QString& x, const QString& left, const QString& right = {});
  void setCurves(QVector<Curve> curves);
  void setBars(QVector<Bars> bars);
  /// Upright dashed lines at these x values.
  void setMarkers(QVector<double> markers);
  void clear();
  /// Shown in the middle while there is nothing to plot.
  void setEmptyText(const QString& text);

  QSize sizeHint() const override { return {320, 170}; }
  QSize minimumSizeHint() const override { return {200, 140}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawTitles(QPainter& painter, int line) const;

  QString xTitle_, leftTitle_, rightTitle_, emptyText_;
  QVector<Curve> curves_;
  QVector<Bars> bars_;
  QVector<double> markers_;
};

}  // namespace falciform
