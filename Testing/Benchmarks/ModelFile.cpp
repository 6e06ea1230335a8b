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

std::string line(const std::string& name, const LineModel& model) {
  return array("k" + name + "Weights", model.scorer.weights.data(), model.scorer.weights.size()) +
         array("k" + name + "Mean", model.ends.mean.data(), model.ends.mean.size()) +
         array("k" + name + "Precision", model.ends.precision.data(), model.ends.precision.size());
}

}  // namespace

std::string modelAsSource(const FeatureModel& model) {
  return "// Printed by `./run bench feature-model`, from the marked livers of Docs/Features.md. Weights of\n"
         "// QuadraticScorer (constant, descriptors, products), mean and inverse covariance of EndsModel.\n"
         "#include <array>\n\n#include \"Logic/Patches/FeatureModel.h\"\n\nnamespace falciform "
         "{\n\nnamespace {\n\n"
         "// clang-format off\n" +
         line("Ridge", model.ridge) + line("Groove", model.groove) +
         "// clang-format on\n\n"
         "template <std::size_t W, std::size_t M, std::size_t P>\n"
         "LineModel lineModel(const std::array<double, W>& weights, const std::array<double, M>& mean,\n"
         "                    const std::array<double, P>& precision, double shortestMm) {\n"
         "  static_assert(P == M * M);\n"
         "  LineModel model;\n"
         "  model.scorer.weights = Eigen::Map<const VectorXd>(weights.data(), static_cast<Index>(W));\n"
         "  model.ends.mean = Eigen::Map<const VectorXd>(mean.data(), static_cast<Index>(M));\n"
         "  model.ends.precision =\n"
         "      Eigen::Map<const Eigen::MatrixXd>(precision.data(), static_cast<Index>(M), "
         "static_cast<Index>(M));\n"
         "  model.ends.shortestMm = shortestMm;\n"
         "  return model;\n"
         "}\n\n}  // namespace\n\n"
         "const FeatureModel& builtInFeatureModel() {\n"
         "  static const FeatureModel model{lineModel(kRidgeWeights, kRidgeMean, kRidgePrecision, " +
         std::to_string(static_cast<int>(model.ridge.ends.shortestMm)) +
         "),\n"
         "                                  lineModel(kGrooveWeights, kGrooveMean, kGroovePrecision, " +
         std::to_string(static_cast<int>(model.groove.ends.shortestMm)) +
         ")};\n"
         "  return model;\n}\n\n}  // namespace falciform\n";
}

}  // namespace falciform::bench
