#pragma once
#include <QObject>
#include <QString>

namespace falciform {

/// What the program has to tell the user, in the order it happened. Panels write, LogView shows.
class Log : public QObject {
  Q_OBJECT

 public:
  enum class Level { Info, Warning, Error };

  using QObject::QObject;

  void info(const QString& text) { Q_EMIT added(Level::Info, text); }
  void warn(const QString& text) { Q_EMIT added(Level::Warning, text); }
  void error(const QString& text) { Q_EMIT added(Level::Error, text); }

 Q_SIGNALS:
  void added(falciform::Log::Level level, const QString& text);
};

}  // namespace falciform
