#include "Testing/CommandLine/Program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "Logic/IO/OutputFile.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {

namespace {

/// In the child: never returns.
[[noreturn]] void become(const std::string& executable, const std::vector<std::string>& arguments,
                         const RunOptions& options, const std::string& out, const std::string& err) {
  const int outFile = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
            errFile = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
  if (outFile < 0 || errFile < 0 || dup2(outFile, 1) < 0 || dup2(errFile, 2) < 0) _exit(127);
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(127);
  if (options.largestFile > 0) {
    std::signal(SIGXFSZ, SIG_IGN);  // the write then fails, as on a full disk
    const rlimit limit{options.largestFile, options.largestFile};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  unsetenv("DISPLAY");
  std::vector<char*> words{const_cast<char*>(executable.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(executable.c_str(), words.data());
  _exit(127);
}

}  // namespace

Ran falciform(const std::vector<std::string>& arguments, const RunOptions& options) {
  const TemporaryFolder folder;
  const std::string out = options.standardOutput.empty() ? (folder / "out").string() : options.standardOutput;
  const std::string err = (folder / "err").string();
  const pid_t child = fork();
  if (child == 0) become(FALCIFORM_EXECUTABLE, arguments, options, out, err);
  int status = 0;
  bool interrupted = false;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (options.interruptWhen && !interrupted && options.interruptWhen()) {
      kill(child, SIGINT);
      interrupted = true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  Ran ran;
  ran.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (options.standardOutput.empty()) ran.out = readTextFile(out);
  ran.err = readTextFile(err);
  return ran;
}

int lineCount(const std::string& text) {
  const auto ends = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  return ends + (!text.empty() && text.back() != '\n' ? 1 : 0);
}

}  // namespace falciform::test
