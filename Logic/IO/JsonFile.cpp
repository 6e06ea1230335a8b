#include "Logic/IO/JsonFile.h"

#include <Eigen/SVD>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

nlohmann::json readJsonFile(const std::filesystem::path& file) {
  const std::string text = readTextFile(file);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(file.filename().string() + " is no sound JSON: fault at byte " +
                     std::to_string(error.byte) + " of " + std::to_string(text.size()) +
                     "; mend or export it again");
  } catch (const nlohmann::json::out_of_range&) {  // 1e999: no fault of the syntax to the parser
    throw InputError(file.filename().string() + " holds a number beyond 1.8e308; mend or export it again");
  }
}

void writeJsonFile(const std::filesystem::path& file, const nlohmann::json& json, Overwrite overwrite) {
  writeTextFile(file, overwrite, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

nlohmann::json numberOrNull(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json matrixToJson(const Isometry3d& transform) {
  nlohmann::json rows = nlohmann::json::array();
  for (Index i = 0; i < 4; ++i) {
    nlohmann::json row = nlohmann::json::array();
    for (Index k = 0; k < 4; ++k) row.push_back(transform.matrix()(i, k));
    rows.push_back(row);
  }
  return rows;
}

Isometry3d rigidFromJson(const nlohmann::json& json, const std::string& what) {
  std::vector<double> numbers;
  const auto take = [&](const nlohmann::json& entry) {
    if (entry.is_number()) numbers.push_back(entry.get<double>());
  };
  if (json.is_array())
    for (const nlohmann::json& row : json) {
      if (row.is_array())
        for (const nlohmann::json& entry : row) take(entry);
      else
        take(row);
    }
  if (numbers.size() != 16)
    throw InputError(what + ": the matrix has " + std::to_string(numbers.size()) +
                     " numbers; give 4 rows of 4");
  return checkedRigid(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data()), what);
}

Isometry3d checkedRigid(const Matrix4d& matrix, const std::string& what) {
  constexpr double kTolerance = 1e-5;  // texts of six digits are off by up to 2e-6
  if (!matrix.allFinite())
    throw InputError(what + ": the matrix holds numbers that are not finite; write it again");
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > kTolerance)
    throw InputError(what + ": the last row of the matrix is not 0 0 0 1; give a row-major rigid transform");
  const Matrix3d turn = matrix.topLeftCorner<3, 3>();
  const double skew = (turn.transpose() * turn - Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (skew > kTolerance || std::abs(turn.determinant() - 1) > kTolerance)
    throw InputError(what + " is not rigid: its determinant is " +
                     numberText(static_cast<float>(turn.determinant())) + " and R^T R differs from 1 by " +
                     numberText(static_cast<float>(skew)) +
                     "; give a rotation and a translation without scale or mirror");
  Isometry3d rigid = Isometry3d::Identity();
  rigid.translation() = matrix.topRightCorner<3, 1>();
  // Only where digits were lost, so that what was exact stays exact.
  if (skew < 1e-14)
    rigid.linear() = turn;
  else {
    const Eigen::JacobiSVD<Matrix3d> svd(turn, Eigen::ComputeFullU | Eigen::ComputeFullV);
    rigid.linear() = svd.matrixU() * svd.matrixV().transpose();
  }
  return rigid;
}

}  // namespace falciform
