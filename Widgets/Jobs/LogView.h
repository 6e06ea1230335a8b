#pragma once
#include <QPlainTextEdit>

#include "Widgets/Jobs/Log.h"

namespace falciform {

/// The log at the foot of the window: time, level by colour and word, text. Keeps the last 2,000 lines.
class LogView : public QPlainTextEdit {
  Q_OBJECT

 public:
  explicit LogView(const Log& log, QWidget* parent = nullptr);

  void append(Log::Level level, const QString& text);
};

}  // namespace falciform
