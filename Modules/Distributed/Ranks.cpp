#include "Modules/Distributed/Ranks.h"

#include <cstdlib>

#include "Logic/Core/Errors.h"
#include "Modules/Distributed/PetscCheck.h"

namespace falciform::distributed {
Ranks::Ranks() {
  check(PetscInitializeNoArguments());  // options come by PETSC_OPTIONS
  check(PetscPopSignalHandler());
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));  // errors are told by exceptions alone
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank_);
  MPI_Comm_size(PETSC_COMM_WORLD, &size_);
}

Ranks::~Ranks() { PetscFinalize(); }

void Ranks::together(const std::function<void()>& work) const {
  std::string message;
  bool failed = false;
  try {
    work();
  } catch (const InputError& error) {
    failed = true;
    message = error.what();
  }
  int mine = failed ? rank_ : size_, firstFailed = size_;
  MPI_Allreduce(&mine, &firstFailed, 1, MPI_INT, MPI_MIN, PETSC_COMM_WORLD);
  if (firstFailed == size_) return;
  auto length = static_cast<int>(message.size());
  MPI_Bcast(&length, 1, MPI_INT, firstFailed, PETSC_COMM_WORLD);
  message.resize(static_cast<std::size_t>(length));
  MPI_Bcast(message.data(), length, MPI_CHAR, firstFailed, PETSC_COMM_WORLD);
  throw InputError(message);
}

double Ranks::sum(double value) const {
  double total = 0;
  MPI_Allreduce(&value, &total, 1, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
  return total;
}

void Ranks::abort(int code) const {
  MPI_Abort(PETSC_COMM_WORLD, code);
  std::abort();
}

}  // namespace falciform::distributed
