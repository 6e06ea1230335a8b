#pragma once
#include <QWidget>
#include <vector>

#include "Logic/Core/Results.h"

class QLabel;
class QPushButton;
class QSlider;
class QTimer;

namespace falciform {

class PlotWidget;

/// The curves of a registration, live while it runs, and a replay of its poses afterwards.
class ConvergenceReplay : public QWidget {
  Q_OBJECT

 public:
  explicit ConvergenceReplay(QWidget* parent = nullptr);

  /// Draws the curves; a running replay ends without a word. `running`: more is to come, nothing to replay
  /// yet.
  void show(const std::vector<IterationRecord>& records, bool running);
  /// Back to the end, without announcing.
  void stop();

 Q_SIGNALS:
  /// The pose after this iteration is to be shown; 0 is the start.
  void frameShown(int iteration);
  /// The last iteration was reached: the result itself is to be shown.
  void ended();

 private:
  void play();
  void showFrame(int frame);

  std::vector<IterationRecord> records_;
  PlotWidget* curves_;
  QWidget* row_;
  QPushButton* replay_;
  QSlider* slider_;
  QLabel* words_;
  QTimer* timer_;
};

}  // namespace falciform
