#pragma once
#include <functional>

namespace falciform::distributed {

/// The processes that mpirun started, one alone without it. MPI and PETSc are up as long as this lives; make
/// one, first thing.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool first() const { return rank_ == 0; }

  /// Runs `work`, in which ranks do not talk, on each. If it throws InputError on any, all throw the first
  /// one's, so that none waits for another that is gone.
  void together(const std::function<void()>& work) const;
  [[nodiscard]] double sum(double value) const;
  /// Ends all ranks at once, for faults of the program.
  [[noreturn]] void abort(int code) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace falciform::distributed
