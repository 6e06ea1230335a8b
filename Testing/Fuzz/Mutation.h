#pragma once
#include <random>
#include <string>

namespace falciform::test {

/// `bytes` with one to six changes, half of them among the first 400 bytes, where headers are: bits, bytes,
/// digits, pieces left out, doubled and put in, the end cut off, and 16- and 32-bit numbers set to extremes.
[[nodiscard]] std::string mutated(std::string bytes, std::mt19937& draw);

}  // namespace falciform::test
