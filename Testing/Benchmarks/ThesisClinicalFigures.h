#pragma once
#include <array>

namespace falciform {

/// One row of thesis Table III.3 or III.4: ICP, PICP (falciform), PICP2 (both), mm. `gross`: the thesis's
/// dagger, a misalignment seen by eye, by method.
struct ClinicalRow {
  std::array<double, 3> rms, falciform, ridge;
  std::array<bool, 3> gross;
};

/// Table III.3: no initial alignment; patients 1 to 6.
inline constexpr std::array<ClinicalRow, 6> kThesisTableIII3{{
    {{5.2, 4.5, 4.7}, {40.2, 1.7, 1.8}, {107.1, 3.0, 1.7}, {true, false, false}},
    {{5.7, 6.2, 7.0}, {43.9, 3.8, 4.9}, {61.8, 10.9, 3.4}, {true, false, false}},
    {{7.3, 5.5, 6.2}, {86.3, 2.6, 4.2}, {106.3, 12.5, 7.2}, {true, false, false}},
    {{7.5, 10.8, 3.7}, {64.4, 7.1, 3.5}, {140.6, 46.3, 5.9}, {true, true, false}},
    {{11.6, 6.6, 6.4}, {138.6, 3.2, 3.5}, {11.6, 5.4, 5.0}, {true, false, false}},
    {{11.3, 10.8, 5.9}, {74.5, 4.1, 3.7}, {37.5, 104.4, 3.3}, {true, true, false}},
}};

/// Table III.4: started from anatomical landmarks.
inline constexpr std::array<ClinicalRow, 6> kThesisTableIII4{{
    {{2.8, 4.6, 4.7}, {35.9, 1.8, 1.8}, {5.0, 2.7, 1.7}, {false, false, false}},
    {{5.2, 5.7, 7.0}, {63.5, 3.1, 4.9}, {39.9, 38.6, 3.4}, {true, false, false}},
    {{5.2, 5.5, 6.2}, {7.1, 2.8, 4.2}, {10.4, 11.5, 7.2}, {false, false, false}},
    {{3.4, 3.5, 3.7}, {3.9, 3.7, 3.5}, {7.1, 7.2, 5.8}, {false, false, false}},
    {{3.4, 6.5, 6.4}, {30.2, 3.1, 3.5}, {5.3, 8.6, 5.0}, {false, false, false}},
    {{5.4, 5.6, 5.9}, {4.3, 2.9, 3.7}, {5.9, 6.5, 3.3}, {false, false, false}},
}};

}  // namespace falciform
