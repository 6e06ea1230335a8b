#pragma once
#include <QApplication>
#include <QString>
#include <vector>

namespace falciform::test {

/// An application that notes how long each event took to handle: what a person feels as a freeze is one that
/// took long. An event whose handling ran an event loop of its own (a dialog) is not noted, those inside of
/// it are.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  struct Slow {
    QString what;  ///< class and name of the receiver, number of the event's type
    double cpuMs;  ///< processor time of this thread: other programs on the machine do not count
    double wallMs;
  };
  /// Begins anew.
  void watch();
  /// The slowest event since, by processor time; and by the clock.
  [[nodiscard]] Slow slowest() const { return byCpu_; }
  [[nodiscard]] Slow longest() const { return byWall_; }

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  std::vector<bool*> open_;  ///< events being handled: set where a loop began within
  std::vector<int> level_;
  Slow byCpu_{}, byWall_{};
};

}  // namespace falciform::test
