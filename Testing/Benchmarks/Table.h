#pragma once
#include <string>

#include "Testing/Benchmarks/Outcomes.h"

namespace falciform::bench {

/// One way of doing a thing, and how it went.
struct Row {
  std::string who;
  Tally tally;
  bool judged = true;  ///< whether right or wrong means anything here
};

/// The head of the one table; rows of all kinds share its columns.
void printHead();

/// The rows of one comparison, each printed when it is there. The first is the reference of the ratios.
class Comparison {
 public:
  explicit Comparison(std::string what) : what_(std::move(what)) {}
  void print(const Row& row);

 private:
  std::string what_;
  double referenceMs_ = 0;
};

}  // namespace falciform::bench
