#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Types.h"

namespace falciform {

/// A named point, mm, in the frame of the list that holds it.
struct Landmark {
  std::string name;
  Vector3d position = Vector3d::Zero();
};

struct Landmarks {
  std::vector<Landmark> points;
  std::string frame = "LPS";
};

}  // namespace falciform
