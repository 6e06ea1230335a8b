#include "Testing/Benchmarks/ModelFile.h"

#include <array>
#include <cstdio>

namespace falciform::bench {

namespace {

std::string array(const std::string& name, const double* values, Index count) {
  std::string text = "constexpr std::array<double, " + std::to_string(count) + "> " + name + "{\n";
  std::string line = "   ";
  for (Index i = 0; i < count; ++i) {
    std::array<char, 32> word{};
    std::snprintf(word.data(), word.size(), " %.7g,", values[i]);
    if (line.size() + std::string(word.data()).size() > 128) {
      text += line + "\n";
      line = "   ";
    }
    line += word.data();
  }
  return text + line + "\n};\n";
}

}  // namespace

std::string modelAsSource(const FeatureModel& model) {
  const EndsModel& ends = model.ridgeEnds;
  return "// Printed by `./run bench feature-model`, from the marked livers of Docs/Features.md. Weights of\n"
         "// QuadraticScorer (constant, descriptors, products), mean and inverse covariance of EndsModel.\n"
         "#include <array>\n\n#include \"Logic/Patches/FeatureModel.h\"\n\nnamespace falciform "
         "{\n\nnamespace {\n\n"
         "// clang-format off\n" +
         array("kRidge", model.ridge.weights.data(), model.ridge.weights.size()) +
         array("kRidgeEndsMean", ends.mean.data(), ends.mean.size()) +
         array("kRidgeEndsPrecision", ends.precision.data(), ends.precision.size()) +
         array("kGroove", model.groove.weights.data(), model.groove.weights.size()) +
         "// clang-format on\n\n"
         "template <std::size_t N>\n"
         "VectorXd vectorOf(const std::array<double, N>& values) {\n"
         "  return Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(N));\n"
         "}\n\n}  // namespace\n\n"
         "const FeatureModel& builtInFeatureModel() {\n"
         "  static const FeatureModel model = [] {\n"
         "    FeatureModel made;\n"
         "    made.ridge.weights = vectorOf(kRidge);\n"
         "    made.groove.weights = vectorOf(kGroove);\n"
         "    made.ridgeEnds.mean = vectorOf(kRidgeEndsMean);\n"
         "    const Index n = made.ridgeEnds.mean.size();\n"
         "    made.ridgeEnds.precision = vectorOf(kRidgeEndsPrecision).reshaped(n, n);\n"
         "    made.ridgeEnds.shortestMm = " +
         std::to_string(static_cast<int>(ends.shortestMm)) +
         ";\n"
         "    return made;\n"
         "  }();\n"
         "  return model;\n}\n\n}  // namespace falciform\n";
}

}  // namespace falciform::bench
