#include "Testing/Benchmarks/ChildProcess.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

namespace falciform::bench {

ChildRun runChild(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  const std::string log = (folder / "log").string();
  const auto began = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start " + words.front());
  if (child == 0) {
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0 || chdir(folder.c_str()) != 0) _exit(127);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments.front(), arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) < 0) throw std::runtime_error("lost " + words.front());
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .wallS = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(),
          .cpuS = seconds(used.ru_utime) + seconds(used.ru_stime),
          .peakMb = static_cast<double>(used.ru_maxrss) / 1024};
}

}  // namespace falciform::bench
