#include "Testing/Gui/EventWatch.h"

#include <QThread>
#include <chrono>
#include <ctime>

namespace falciform::test {
namespace {

double threadMs() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

}  // namespace

void WatchedApplication::watch() { byCpu_ = byWall_ = {}; }

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  if (thread() != QThread::currentThread()) return QApplication::notify(receiver, event);
  const int level = QThread::currentThread()->loopLevel();
  // Whoever is open at a lower level waits in a dialog.
  for (std::size_t i = 0; i < open_.size(); ++i)
    if (level_[i] < level) *open_[i] = true;
  bool waited = false;
  open_.push_back(&waited);
  level_.push_back(level);
  const QString what = QString("%1 %2, event %3")
                           .arg(receiver->metaObject()->className(), receiver->objectName())
                           .arg(event->type());
  const double cpu = threadMs();
  const auto wall = std::chrono::steady_clock::now();
  const bool result = QApplication::notify(receiver, event);  // `receiver` may be gone afterwards
  const Slow spent{
      what, threadMs() - cpu,
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - wall).count()};
  open_.pop_back();
  level_.pop_back();
  if (!waited && spent.cpuMs > byCpu_.cpuMs) byCpu_ = spent;
  if (!waited && spent.wallMs > byWall_.wallMs) byWall_ = spent;
  return result;
}

}  // namespace falciform::test
