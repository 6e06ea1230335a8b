#pragma once
#include <QColor>
#include <QWidget>
#include <map>
#include <memory>
#include <optional>
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

/// What a slice shows of a case, and what the mouse does there.
struct SliceContent {
  std::shared_ptr<const Image> ct;
  std::shared_ptr<const LabelMap> labels;     ///< laid over the CT
  std::shared_ptr<const LabelMap> forbidden;  ///< hatched where above 0
  int labelEdits = 0;                         ///< another number: these two have changed in place
  std::map<int, std::array<double, 3>> labelColours;
  GreyWindow window;
  std::shared_ptr<const Points> seeds;  ///< LPS mm
  SliceTool tool = SliceTool::Look;
  double brushMm = 8;
};

/// One upright cut through CT or label map with outlines of surfaces on it, by QPainter: no OpenGL. The wheel
/// moves the cut, a click moves the cursor, which views of other planes share, or uses the tool; the right
/// button drags the grey window.
class SliceView : public QWidget {
  Q_OBJECT

 public:
  explicit SliceView(SlicePlane plane, QWidget* parent = nullptr);

  void setContent(const SliceContent& content);
  void setOutlines(std::vector<SliceOutline> outlines);
  /// The box that is shown, LPS mm, made as large as it can be; its middle becomes the cursor, and the zoom
  /// ends.
  void setExtent(const Vector3d& low, const Vector3d& high);
  /// Where the cut lies, and the cross on it; without announcing.
  void setCursorMm(const Vector3d& mm);
  [[nodiscard]] const Vector3d& cursorMm() const { return cursor_; }
  [[nodiscard]] SlicePlane plane() const { return plane_; }
  /// Where a place of the patient is drawn.
  [[nodiscard]] QPointF positionOf(const Vector3d& mm) const;
  [[nodiscard]] double zoom() const { return zoom_; }
  void endZoom();

  QSize sizeHint() const override { return {240, 220}; }
  QSize minimumSizeHint() const override { return {110, 90}; }

 Q_SIGNALS:
  void cursorMoved(const Vector3d& mm);
  void touched(const SliceTouch& touch);
  void windowDragged(const GreyWindow& window);
  void brushScaled(double factor);
  /// Esc: the tool is to be laid down.
  void toolLeft();
  void enlargeWanted();
  void hovered(const Vector3d& mm);
  void hoverEnded();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Drag { None, Cursor, Tool, Window, Pan };

  [[nodiscard]] double pixelsPerMm() const;
  [[nodiscard]] QRectF shownMm() const;  ///< of the whole widget, screen mm
  [[nodiscard]] double at() const { return cursor_[axes_.through]; }
  [[nodiscard]] Vector3d placeOf(const QPointF& pixel) const;
  [[nodiscard]] bool brushing() const;
  [[nodiscard]] Drag dragOf(const QMouseEvent& event) const;
  void moveTo(const Vector3d& mm);
  void step(int cuts);
  void zoomAt(const QPointF& pixel, double factor);
  void imagesAreOld();
  void drawImages(QPainter& painter);
  void drawOutlines(QPainter& painter);
  void drawSeeds(QPainter& painter) const;
  void drawBrush(QPainter& painter) const;
  void drawWords(QPainter& painter) const;

  SlicePlane plane_;
  SliceAxes axes_;
  SliceContent content_;
  std::vector<SliceOutline> outlines_;
  Vector3d low_ = Vector3d::Constant(-100), high_ = Vector3d::Constant(100), cursor_ = Vector3d::Zero();
  double zoom_ = 1;
  QPointF centre_;  ///< of the widget, screen mm
  struct Section {
    double at = 0;
    Points ends;
  };
  std::map<std::shared_ptr<const Surface>, Section> sections_;  ///< of the last paint
  QImage grey_, labels_, hatch_;
  bool greyOld_ = true, labelsOld_ = true;
  Drag drag_ = Drag::None;
  QPointF pressed_, pressedCentre_;
  GreyWindow pressedWindow_;
  std::optional<QPointF> mouse_;
  double wheel_ = 0;
};

}  // namespace falciform
