#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "Logic/Core/Types.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

/// The file's content; throws InputError for a missing file or one that is no JSON, with the place of the
/// fault.
[[nodiscard]] nlohmann::json readJsonFile(const std::filesystem::path& file);

/// Writes `json` with an indent of two; NaN becomes null, names that are no UTF-8 are mended.
void writeJsonFile(const std::filesystem::path& file, const nlohmann::json& json, Overwrite overwrite);

/// `value`, or null if it is not finite: JSON knows no NaN.
[[nodiscard]] nlohmann::json numberOrNull(double value);
/// Four rows of four.
[[nodiscard]] nlohmann::json matrixToJson(const Isometry3d& transform);
/// Four rows of four numbers, or 16 in one list; throws InputError naming `what` for anything but a rigid
/// transform.
[[nodiscard]] Isometry3d rigidFromJson(const nlohmann::json& json, const std::string& what);

/// Checks R^T R = 1 and det = +1 within 1e-5 (texts with six digits pass) and returns the nearest rigid
/// transform; throws InputError naming `what` otherwise.
[[nodiscard]] Isometry3d checkedRigid(const Matrix4d& matrix, const std::string& what);

}  // namespace falciform
