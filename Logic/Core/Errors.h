#pragma once
#include <stdexcept>
#include <string>

namespace falciform {

/// Something the user can mend: a missing file, an empty patch, an open surface. The message is one line that
/// names the thing, the value found and the remedy. Caught only in JobRunner and in the command line's main.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace falciform
