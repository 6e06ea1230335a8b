#pragma once
#include <petscsys.h>

#include <new>
#include <stdexcept>
#include <string>

namespace falciform::distributed {

/// PETSc's return codes as exceptions. Only source files that call PETSc include this.
inline void check(PetscErrorCode code) {
  if (code == 0) return;
  if (code == PETSC_ERR_MEM) throw std::bad_alloc();
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw std::runtime_error(std::string("PETSc: ") + (text != nullptr ? text : std::to_string(code)));
}

}  // namespace falciform::distributed
