#pragma once
#include <array>

namespace falciform {

/// A mean and a largest error, mm, as thesis ch. V prints them; the spread where it does.
struct ThesisError {
  double mean = 0, largest = 0, sd = 0;
};

/// One row of thesis Tables V.1 to V.4: by full and by partial surface, after ICP and ICAt (V.1, V.3) or PICP
/// and ICAt* (V.2, V.4). V.1 and V.2: over the mesh's nodes, without spread; V.3 and V.4: over 43 beads.
struct UpdateRow {
  ThesisError before, fullRigid, fullUpdated, partialRigid, partialUpdated;
};

/// Table V.1: ICP and ICAt; trials 1 to 5.
inline constexpr std::array<UpdateRow, 5> kThesisTableV1{{
    {{11.8, 50.8}, {7.6, 24.2}, {0.1, 0.1}, {9.9, 22.8}, {0.2, 0.3}},
    {{14.1, 59.2}, {6.6, 22.8}, {0.3, 0.3}, {8.6, 25.4}, {5.0, 10.3}},
    {{9.1, 72.2}, {8.3, 23.6}, {0.1, 0.2}, {10.3, 22.3}, {3.2, 5.5}},
    {{13.3, 57.9}, {5.7, 15.5}, {0.1, 0.2}, {7.9, 19.3}, {5.0, 8.5}},
    {{10.3, 69.1}, {8.0, 23.7}, {0.2, 0.2}, {10.2, 23.0}, {3.1, 5.4}},
}};

/// Table V.2: PICP and ICAt*.
inline constexpr std::array<UpdateRow, 5> kThesisTableV2{{
    {{11.8, 50.8}, {6.2, 29.8}, {0.1, 0.2}, {8.7, 32.0}, {0.1, 0.3}},
    {{14.1, 59.2}, {5.8, 28.3}, {0.1, 0.3}, {11.8, 30.7}, {3.9, 5.7}},
    {{9.1, 72.2}, {7.1, 31.9}, {0.04, 0.1}, {7.7, 35.5}, {0.2, 0.4}},
    {{13.3, 57.9}, {6.2, 17.6}, {0.1, 0.2}, {8.4, 22.3}, {0.2, 0.4}},
    {{10.3, 69.1}, {6.8, 31.3}, {0.1, 0.2}, {7.9, 31.3}, {0.1, 0.3}},
}};

/// Table V.3: ICP and ICAt; left, then right lobe packed.
inline constexpr std::array<UpdateRow, 2> kThesisTableV3{{
    {{14.8, 31.0, 8.5}, {3.3, 6.2, 1.6}, {1.9, 4.4, 1.2}, {4.4, 10.9, 2.0}, {4.0, 14.3, 2.6}},
    {{22.8, 42.3, 8.8}, {2.3, 6.9, 1.3}, {1.1, 2.4, 0.6}, {4.3, 8.8, 2.0}, {3.3, 7.4, 1.5}},
}};

/// Table V.4: PICP and ICAt*.
inline constexpr std::array<UpdateRow, 2> kThesisTableV4{{
    {{14.8, 31.0, 8.5}, {3.2, 6.8, 1.6}, {1.8, 4.2, 1.2}, {4.1, 11.3, 2.3}, {2.5, 5.4, 1.1}},
    {{22.8, 42.3, 8.8}, {2.7, 6.7, 1.6}, {1.1, 2.3, 0.5}, {4.5, 10.0, 2.2}, {2.5, 5.3, 1.1}},
}};

/// Figure V.11: mean target error over 25 perturbed starts, mm, and its spread from start to start.
inline constexpr ThesisError kThesisPerturbedIcatPartial{4.8, 0, 1.1},
    kThesisPerturbedIcatStarPartial{4.0, 0, 2.3}, kThesisPerturbedIcatStarFull{1.8, 0, 0.1};

}  // namespace falciform
