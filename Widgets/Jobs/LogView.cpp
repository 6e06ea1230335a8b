#include "Widgets/Jobs/LogView.h"

#include <QTime>

namespace falciform {

LogView::LogView(const Log& log, QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("log");
  setReadOnly(true);
  setMaximumBlockCount(2000);
  setToolTip(tr("What the program did and what it warns of, newest last"));
  setPlaceholderText(tr("Messages appear here."));
  connect(&log, &Log::added, this, &LogView::append);
}

void LogView::append(Log::Level level, const QString& text) {
  const QString time = QTime::currentTime().toString("HH:mm:ss");
  // The word says the level as well: colour alone is lost on some eyes and in copied text.
  const char* word = level == Log::Level::Info ? "" : level == Log::Level::Warning ? "Warning: " : "Error: ";
  const bool dark = palette().base().color().lightness() < 128;
  const char* colour = level == Log::Level::Info      ? ""
                       : level == Log::Level::Warning ? (dark ? "#f0c060" : "#8a5a00")
                                                      : (dark ? "#ff9a8f" : "#a3160d");
  const QString line = (time + "  " + tr(word) + text).toHtmlEscaped();
  appendHtml(*colour ? QString("<span style=\"color:%1\">%2</span>").arg(colour, line)
                     : QString("<span>%1</span>").arg(line));
}

}  // namespace falciform
