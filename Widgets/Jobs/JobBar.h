#pragma once
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace falciform {

class JobRunner;

/// The running job's title, stage and share done, with Cancel; "Ready" when nothing runs.
class JobBar : public QWidget {
  Q_OBJECT

 public:
  explicit JobBar(JobRunner& runner, QWidget* parent = nullptr);

 private:
  void showIdle(const QString& text);

  QLabel* text_;
  QProgressBar* bar_;
  QPushButton* cancel_;
};

}  // namespace falciform
