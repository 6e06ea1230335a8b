#include "Testing/Gui/SmoothFixture.h"

#include <cstdio>

namespace falciform::test {

void SmoothFixture::isSmooth(const char* what, const std::function<void()>& action) {
  WatchedApplication::Slow best{"", 1e9, 1e9};
  for (int attempt = 0; attempt < 3 && best.cpuMs > kLongestMs; ++attempt) {
    handleEvents(100);
    application().watch();
    action();
    handleEvents(100);
    if (application().slowest().cpuMs < best.cpuMs) best = application().slowest();
  }
  std::printf("%-28s %6.1f ms processor, %6.1f ms by the clock: %s\n", what, best.cpuMs, best.wallMs,
              qPrintable(best.what));
  EXPECT_GT(best.cpuMs, 0) << what << ": nothing happened";
  EXPECT_LE(best.cpuMs, kLongestMs) << what << ": " << best.what.toStdString();
}

}  // namespace falciform::test
