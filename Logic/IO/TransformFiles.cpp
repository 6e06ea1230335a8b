#include "Logic/IO/TransformFiles.h"

#include <algorithm>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

std::vector<double> numbersIn(std::string_view line, const std::string& name) {
  std::vector<double> numbers;
  for (std::string_view word = nextWord(line, " \t\r,;"); !word.empty(); word = nextWord(line, " \t\r,;")) {
    double value = 0;
    if (!parseNumber(word, value))
      throw InputError(name + ": '" + std::string(word.substr(0, 20)) +
                       "' stands where a number should; write it again");
    numbers.push_back(value);
    if (numbers.size() > 100)
      throw InputError(name + " holds too many numbers for one rigid transform; give 4 rows of 4");
  }
  return numbers;
}

/// ITK: x_moving = A (x_fixed - c) + c + t in LPS, by which an image is resampled; points move the other way.
Isometry3d readItk(const std::string& text, const std::string& name) {
  if (!text.starts_with("#Insight Transform File"))
    throw InputError(name +
                     " is no ITK transform file (#Insight Transform File V1.0); export it as .tfm again");
  std::string kind;
  std::vector<double> parameters, centre{0, 0, 0};
  TextCursor cursor(text);
  for (std::string_view line; cursor.nextLine(line);) {
    const std::string_view key = nextWord(line);
    if (key == "Transform:") {
      if (!kind.empty())
        throw InputError(name + " holds several transforms; export one rigid transform alone");
      kind = nextWord(line);
    } else if (key == "Parameters:")
      parameters = numbersIn(line, name);
    else if (key == "FixedParameters:")
      centre = numbersIn(line, name);
  }
  const bool affine = kind.starts_with("AffineTransform_") || kind.starts_with("MatrixOffsetTransformBase_");
  if (!affine || !kind.ends_with("_3_3"))
    throw InputError(name + " holds a '" + kind.substr(0, 40) +
                     "'; export a linear transform (AffineTransform_double_3_3)");
  if (parameters.size() != 12 || centre.size() != 3)
    throw InputError(name + " has " + std::to_string(parameters.size()) + " parameters and " +
                     std::to_string(centre.size()) +
                     " fixed ones instead of 12 and 3 (truncated?); export it again");
  Matrix4d movingFromFixed = Matrix4d::Identity();
  const Eigen::Map<const Vector3d> c(centre.data()), t(parameters.data() + 9);
  movingFromFixed.topLeftCorner<3, 3>() =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(parameters.data());
  movingFromFixed.topRightCorner<3, 1>() = t + c - movingFromFixed.topLeftCorner<3, 3>() * c;
  return checkedRigid(movingFromFixed, name).inverse();
}

Isometry3d readMatrixText(const std::string& text, const std::string& name) {
  std::vector<double> numbers;
  TextCursor cursor(text);
  for (std::string_view line; cursor.nextLine(line);) {
    const std::vector<double> row = numbersIn(line.substr(0, line.find('#')), name);
    numbers.insert(numbers.end(), row.begin(), row.end());
    if (numbers.size() > 16) break;
  }
  if (numbers.size() != 16)
    throw InputError(name + " does not hold 16 numbers; give the 4 rows of 4 of a rigid transform");
  return checkedRigid(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data()), name);
}

Isometry3d readJson(const std::filesystem::path& file, const std::string& name) {
  const nlohmann::json json = readJsonFile(file);
  for (const char* key : {"matrix", "scan_from_preop"})  // the second: a saved registration
    if (json.is_object() && json.contains(key)) return rigidFromJson(json[key], name);
  throw InputError(name + " has no key 'matrix'; give 4 rows of 4 there");
}

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

std::string itkText(const Isometry3d& targetFromSource, const std::string& direction) {
  const Isometry3d inverse = targetFromSource.inverse();
  std::string text = "#Insight Transform File V1.0\n#Transform 0\n# As a linear transform in 3D Slicer it " +
                     direction +
                     "; ITK stores the inverse, in LPS.\nTransform: AffineTransform_double_3_3\nParameters:";
  for (Index i = 0; i < 3; ++i)
    for (Index k = 0; k < 3; ++k) text += ' ' + numberText(inverse.linear()(i, k));
  for (Index i = 0; i < 3; ++i) text += ' ' + numberText(inverse.translation()[i]);
  return text + "\nFixedParameters: 0 0 0\n";
}

std::string matrixText(const Isometry3d& targetFromSource, const std::string& direction) {
  std::string text = "# " + direction + "; row-major, target = matrix * source\n";
  for (Index i = 0; i < 4; ++i)
    for (Index k = 0; k < 4; ++k) text += numberText(targetFromSource.matrix()(i, k)) + (k < 3 ? ' ' : '\n');
  return text;
}

}  // namespace

Isometry3d readTransform(const std::filesystem::path& file) {
  const std::string name = file.filename().string(), extension = file.extension().string();
  if (extension == ".tfm") return readItk(readTextFile(file), name);
  if (extension == ".txt") return readMatrixText(readTextFile(file), name);
  if (extension == ".json") return readJson(file, name);
  throw InputError("'" + name + "' is no transform file; give .tfm, .txt (4 x 4) or .json");
}

void writeTransform(const std::filesystem::path& file, const Isometry3d& targetFromSource,
                    const std::string& direction, Overwrite overwrite) {
  const std::string name = file.filename().string(), extension = file.extension().string(),
                    words = oneLine(direction);
  (void)checkedRigid(targetFromSource.matrix(), "the transform for " + name);
  if (extension == ".tfm")
    writeTextFile(file, overwrite, itkText(targetFromSource, words));
  else if (extension == ".txt")
    writeTextFile(file, overwrite, matrixText(targetFromSource, words));
  else if (extension == ".json")
    writeJsonFile(file,
                  {{"matrix", matrixToJson(targetFromSource)},
                   {"direction", words},
                   {"units", "mm"},
                   {"convention", "row-major; target = matrix * source"}},
                  overwrite);
  else
    throw InputError("cannot write a transform as '" + name + "'; choose .tfm, .txt or .json");
}

}  // namespace falciform
