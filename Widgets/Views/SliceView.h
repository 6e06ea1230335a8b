#pragma once
#include <QColor>
#include <QWidget>
#include <map>
#include <memory>
#include <vector>

#include "Logic/Core/Surface.h"
#include "Widgets/Views/SliceImage.h"

namespace falciform {

/// A surface drawn on slices as its outline.
struct SliceOutline {
  std::shared_ptr<const Surface> surface;  ///< patient LPS
  QColor colour;
  bool dashed = false;
};

/// One upright cut through CT or label map with outlines of surfaces on it, by QPainter: no OpenGL. The wheel
/// moves the cut, a click moves the cursor, which views of other planes share.
class SliceView : public QWidget {
  Q_OBJECT

 public:
  explicit SliceView(SlicePlane plane, QWidget* parent = nullptr);

  /// The CT if there is one, else the label map, else nothing behind the outlines.
  void setVolume(std::shared_ptr<const Image> ct, std::shared_ptr<const LabelMap> labels);
  void setOutlines(std::vector<SliceOutline> outlines);
  /// The box that is shown, LPS mm, made as large as it can be. Its middle becomes the cursor.
  void setExtent(const Vector3d& low, const Vector3d& high);
  /// Where the cut lies, and the cross on it; without announcing.
  void setCursorMm(const Vector3d& mm);
  [[nodiscard]] const Vector3d& cursorMm() const { return cursor_; }
  [[nodiscard]] SlicePlane plane() const { return plane_; }
  /// Where a place of the patient is drawn.
  [[nodiscard]] QPointF positionOf(const Vector3d& mm) const;

  QSize sizeHint() const override { return {240, 220}; }
  QSize minimumSizeHint() const override { return {120, 110}; }

 Q_SIGNALS:
  void cursorMoved(const Vector3d& mm);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  [[nodiscard]] QRectF frame() const;    ///< of the picture, widget pixels
  [[nodiscard]] QRectF shownMm() const;  ///< what it shows, screen mm
  [[nodiscard]] double at() const { return cursor_[axes_.through]; }
  void pointAt(const QPointF& pixel);
  void moveTo(const Vector3d& mm);
  void drawOutlines(QPainter& painter);
  void drawWords(QPainter& painter) const;

  SlicePlane plane_;
  SliceAxes axes_;
  std::shared_ptr<const Image> ct_;
  std::shared_ptr<const LabelMap> labels_;
  std::vector<SliceOutline> outlines_;
  Vector3d low_ = Vector3d::Constant(-100), high_ = Vector3d::Constant(100), cursor_ = Vector3d::Zero();
  struct Section {
    double at = 0;
    Points ends;
  };
  std::map<std::shared_ptr<const Surface>, Section> sections_;  ///< of the last paint
  QImage image_;
  bool imageOld_ = true;
  double wheel_ = 0;
};

}  // namespace falciform
