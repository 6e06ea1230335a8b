#pragma once
#include <string>
#include <vector>

namespace falciform {

/// What a reader found, and what the user should know about it (no space tag, suspicious units, ...).
template <class T>
struct Loaded {
  T value;
  std::vector<std::string> warnings;
};

}  // namespace falciform
