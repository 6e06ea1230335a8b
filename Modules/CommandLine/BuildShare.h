#pragma once
#include <string>
#include <vector>

namespace falciform::commandline {

/// Which part of a build this process does: number `index` of `count`, from 0.
struct BuildShare {
  int index = 0, count = 1;

  [[nodiscard]] bool shared() const { return count > 1; }
  /// Its part of `items` things: a run of neighbours, so that those of one stiffness stay together.
  [[nodiscard]] std::vector<int> of(int items) const;
};

/// "3/10"; an empty text asks OpenMPI's environment (mpirun sets OMPI_COMM_WORLD_RANK and _SIZE), and is the
/// whole where there is none. Throws InputError for anything else.
[[nodiscard]] BuildShare buildShare(const std::string& text);

/// Several processes that mpirun has started on this machine share its cores, unless each is bound to its
/// own: threads are set to each one's part.
void shareThreads();

}  // namespace falciform::commandline
