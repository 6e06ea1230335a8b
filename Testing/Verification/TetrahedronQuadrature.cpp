#include "Testing/Verification/TetrahedronQuadrature.h"

#include <array>
#include <cmath>

namespace falciform::verification {

const std::vector<QuadraturePlace>& finePlaces() {
  static const std::vector<QuadraturePlace> places = [] {
    // Gauss-Legendre on [0, 1], exact to degree 9; the collapse's Jacobian takes two of those.
    const double near = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3,
                 far = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
    const double nearWeight = (322 + 13 * std::sqrt(70.0)) / 1800,
                 farWeight = (322 - 13 * std::sqrt(70.0)) / 1800;
    const std::array<double, 5> at{(1 - far) / 2, (1 - near) / 2, 0.5, (1 + near) / 2, (1 + far) / 2};
    const std::array<double, 5> weight{farWeight, nearWeight, 128.0 / 450, nearWeight, farWeight};
    std::vector<QuadraturePlace> result;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t k = 0; k < 5; ++k) {
          const double u = at[i], v = (1 - u) * at[j], w = (1 - u - v) * at[k];
          const double jacobian = (1 - u) * (1 - u - v);
          result.push_back({.barycentric = {1 - u - v - w, u, v, w},
                            .weight = 6 * jacobian * weight[i] * weight[j] * weight[k]});
        }
    return result;
  }();
  return places;
}

}  // namespace falciform::verification
