#include "Modules/CommandLine/TerminalProgress.h"

#include <csignal>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

namespace falciform::commandline {

namespace {

void showOnTerminal(int percent, const std::string& stage) {
  std::fprintf(stderr, "\r\033[K[%3d %%] %s", percent, stage.c_str());
  std::fflush(stderr);
}

void showInSlicer(double fraction, const std::string& stage) {
  std::printf("<filter-progress>%.3f</filter-progress>\n", fraction);
  if (!stage.empty()) std::printf("<filter-comment>%s</filter-comment>\n", stage.c_str());
  std::fflush(stdout);
}

/// The thread that waits for signals, for the handler.
pthread_t waiter;

}  // namespace

Progress makeProgress(ProgressStyle style, std::stop_token stop) {
  if (style == ProgressStyle::Silent) return {{}, std::move(stop)};
  struct Last {
    int percent = -1;
    std::string stage;
  };
  auto last = std::make_shared<Last>();
  const auto sink = [style, last](double fraction, std::string_view stage) {
    const int percent = static_cast<int>(100 * fraction);
    if (percent == last->percent && (stage.empty() || stage == last->stage)) return;
    last->percent = percent;
    if (!stage.empty()) last->stage = stage;
    if (style == ProgressStyle::Terminal)
      showOnTerminal(percent, last->stage);
    else
      showInSlicer(fraction, last->stage);
  };
  return {sink, std::move(stop)};
}

void clearProgressLine(ProgressStyle style) {
  if (style != ProgressStyle::Terminal) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

std::stop_source stopOnSignals() {
  std::stop_source source;
  // A handler may do next to nothing; a thread that waits for the signal may do anything. All threads inherit
  // the mask.
  sigset_t waited;
  sigemptyset(&waited);
  sigaddset(&waited, SIGINT);  // also where a script's shell has it ignored for jobs in the background
  sigaddset(&waited, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &waited, nullptr);
  std::thread waiting([source, waited]() mutable {
    int signal = 0;
    if (sigwait(&waited, &signal) == 0) source.request_stop();
  });
  waiter = waiting.native_handle();
  waiting.detach();
  // All but those that a library started before main, as OpenBLAS does: they hand the signal on.
  struct sigaction action {};
  action.sa_handler = [](int signal) { pthread_kill(waiter, signal); };
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  return source;
}

}  // namespace falciform::commandline
