#pragma once
#include <string>

#include "Testing/Fuzz/FuzzTarget.h"

namespace falciform::test {

/// What became of the mutants of one good file.
struct FuzzOutcome {
  int read = 0, refused = 0;
  std::string failure;   ///< of the first bad mutant, with what happened; empty: none
  double slowestMs = 0;  ///< of one mutant
  double largestMb = 0;  ///< asked for at once by operator new
};

/// Reads `count` mutants in a process of its own, so that a crash or a hang is a finding and not the end.
/// Limits: 10 s a mutant; as much memory as deflate could unpack from the file (1032 times its bytes) and
/// 256 MB. `keep`: a folder into which bad mutants are written; empty: none.
[[nodiscard]] FuzzOutcome fuzz(const FuzzTarget& target, int count, unsigned seed,
                               const std::filesystem::path& keep = {});

}  // namespace falciform::test
