#pragma once
#include <functional>

#include "Testing/Gui/EventWatch.h"
#include "Testing/Gui/WindowFixture.h"

namespace falciform::test {

/// The window in an application that notes how long each event takes.
struct SmoothFixture : WindowTest {
  static constexpr double kLongestMs = 100;  ///< of one event: what a person takes for "at once"

  static WatchedApplication& application() { return *static_cast<WatchedApplication*>(qApp); }
  /// Does it up to three times, since a busy machine, or a picture drawn for the first time, makes one slow
  /// turn; no event of the best of them may hold the window up. Judged by the thread's own processor time,
  /// which other programs do not lengthen much.
  void isSmooth(const char* what, const std::function<void()>& action);
};

}  // namespace falciform::test
