#include "Widgets/Views/SliceOptions.h"

namespace falciform {

const std::vector<GreyPreset>& greyPresets() {
  static const std::vector<GreyPreset> presets{{"Abdomen", {80, 400}}, {"Soft tissue", {40, 400}},
                                               {"Liver", {90, 160}},   {"Liver, no contrast", {60, 160}},
                                               {"Lung", {-600, 1500}}, {"Bone", {400, 1800}}};
  return presets;
}

std::array<double, 3> labelColour(int label) {
  static const std::array<std::array<double, 3>, 8> colours{{{0.90, 0.45, 0.35},
                                                             {0.94, 0.89, 0.26},
                                                             {0.34, 0.71, 0.91},
                                                             {0.00, 0.45, 0.70},
                                                             {0.00, 0.62, 0.45},
                                                             {0.80, 0.47, 0.65},
                                                             {0.90, 0.60, 0.00},
                                                             {0.60, 0.60, 0.60}}};
  return colours[static_cast<std::size_t>(label < 1 ? 0 : (label - 1) % 8)];
}

}  // namespace falciform
