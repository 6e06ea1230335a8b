#pragma once
#include <functional>
#include <string>
#include <vector>

namespace falciform::test {

/// What a run of `falciform` left.
struct Ran {
  int exitCode = -1;  ///< 128 + n if signal n ended it
  std::string out, err;
};

struct RunOptions {
  std::string folder;           ///< working folder; empty: as it is
  std::string standardOutput;   ///< a file such as /dev/full; empty: captured
  std::size_t largestFile = 0;  ///< bytes that one file may have, as on a disk that fills; 0: any
  /// Called again and again while the program runs; true: send it SIGINT, once.
  std::function<bool()> interruptWhen;
};

/// Runs the built executable with these arguments, no DISPLAY, and waits for its end.
[[nodiscard]] Ran falciform(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Number of lines, an unfinished last one counted.
[[nodiscard]] int lineCount(const std::string& text);

}  // namespace falciform::test
