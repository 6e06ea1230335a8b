#pragma once
#include <QWidget>

#include "Logic/Core/Types.h"

class QLabel;
class QPushButton;

namespace falciform {

class NumberBox;

/// Buttons and steps that move the scan by hand; the handles in the 3D view do the same.
class HandPoseControls : public QWidget {
  Q_OBJECT

 public:
  explicit HandPoseControls(QWidget* parent = nullptr);

  [[nodiscard]] double stepMm() const;
  [[nodiscard]] double stepDeg() const;
  /// `on`: handles are shown. `placed`: there is a pose of the hand's. `missing`: why there can be none.
  /// `busy`: a job runs.
  void show(bool on, bool placed, const QString& missing, bool busy);

 Q_SIGNALS:
  void toggled(bool on);
  /// By one step along or about an axis of the pre-op frame (0 x, 1 y, 2 z); sign +1 or -1.
  void shiftWanted(int axis, int sign);
  void turnWanted(int axis, int sign);
  void stepsChanged();
  void registerWanted();
  void resetWanted();

 private:
  QWidget* stepGrid();

  QPushButton *move_, *register_, *reset_;
  QWidget* steps_;
  NumberBox *stepMm_, *stepDeg_;
  QLabel* words_;
};

}  // namespace falciform
