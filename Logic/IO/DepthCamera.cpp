#include "Logic/IO/DepthCamera.h"

#include <cmath>
#include <optional>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/TransformFiles.h"

namespace falciform {

namespace {

using nlohmann::json;

std::optional<double> numberOf(const json& object, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (const auto found = object.find(key); found != object.end() && found->is_number())
      return found->get<double>();
  return std::nullopt;
}

/// Nine numbers, in one list or in three; empty if it is anything else.
std::vector<double> nineOf(const json& matrix) {
  std::vector<double> values;
  const auto take = [&](const json& entry) {
    if (entry.is_number()) values.push_back(entry.get<double>());
  };
  if (!matrix.is_array()) return {};
  for (const json& entry : matrix)
    if (entry.is_array())
      for (const json& inner : entry) take(inner);
    else
      take(entry);
  return values.size() == 9 ? values : std::vector<double>{};
}

void setByRows(DepthCamera& camera, const std::vector<double>& k) {
  camera.fx = k[0];
  camera.cx = k[2];
  camera.fy = k[4];
  camera.cy = k[5];
}

DepthCamera fromJson(json object) {
  DepthCamera camera;
  if (object.is_object() && object.contains("intrinsic")) object = object["intrinsic"];
  if (!object.is_object()) return camera;
  if (const auto fx = numberOf(object, {"fx"})) {
    camera.fx = *fx;
    camera.fy = numberOf(object, {"fy"}).value_or(0);
    camera.cx = numberOf(object, {"cx", "ppx"}).value_or(-1);
    camera.cy = numberOf(object, {"cy", "ppy"}).value_or(-1);
  } else if (const auto k = nineOf(object.value("intrinsic_matrix", json())); !k.empty()) {
    // Open3D writes column by column; files written by hand go by rows, and are known by their zeros.
    setByRows(camera, k[2] == 0 && k[5] == 0 ? std::vector{k[0], k[3], k[6], k[1], k[4], k[7]} : k);
  } else {
    for (const char* key : {"K", "camera_matrix"})
      if (const auto rows = nineOf(object.value(key, json())); !rows.empty()) setByRows(camera, rows);
  }
  const auto size = [&](const char* key) {
    const double value = numberOf(object, {key}).value_or(0);
    return value >= 0 && value <= 1e6 ? static_cast<int>(value) : -1;
  };
  camera.width = size("width");
  camera.height = size("height");
  if (const auto scale = numberOf(object, {"depth_scale"}))
    camera.unitsPerMm = *scale >= 1 ? *scale / 1000 : 1 / (*scale * 1000);
  return camera;
}

std::vector<double> numbersIn(const std::string& text) {
  std::vector<double> numbers;
  std::string_view rest = text;
  constexpr std::size_t kEnough = 100;
  for (std::string_view word = nextWord(rest, " \t\r\n,;"); !word.empty() && numbers.size() < kEnough;
       word = nextWord(rest, " \t\r\n,;")) {
    double value = 0;
    if (!parseNumber(word, value)) return {};
    numbers.push_back(value);
  }
  return numbers;
}

DepthCamera fromText(const std::string& text) {
  std::vector<double> numbers = numbersIn(text);
  DepthCamera camera;
  if (numbers.size() == 4) {
    camera.fx = numbers[0];
    camera.fy = numbers[1];
    camera.cx = numbers[2];
    camera.cy = numbers[3];
    return camera;
  }
  if (numbers.size() >= 11 && numbers[0] >= 1 && numbers[1] >= 1 && std::max(numbers[0], numbers[1]) <= 1e6) {
    camera.width = static_cast<int>(numbers[0]);
    camera.height = static_cast<int>(numbers[1]);
    numbers.erase(numbers.begin(), numbers.begin() + 2);
  }
  if (numbers.size() >= 9) setByRows(camera, numbers);
  return camera;
}

}  // namespace

DepthCamera readDepthCamera(const std::filesystem::path& file) {
  const DepthCamera camera =
      file.extension() == ".json" ? fromJson(readJsonFile(file)) : fromText(readTextFile(file));
  const auto sound = [](double value, double least) { return value >= least && value <= 1e6; };
  if (!sound(camera.fx, 1e-3) || !sound(camera.fy, 1e-3) || !sound(camera.cx, 0) || !sound(camera.cy, 0) ||
      camera.width < 0 || camera.height < 0 || !(camera.unitsPerMm >= 1e-6 && camera.unitsPerMm <= 1e6))
    throw InputError(file.filename().string() +
                     R"( holds no camera: write {"width": 640, "height": 480, "fx": 895.2, "fy": 893.8, )" +
                     R"("cx": 319.5, "cy": 239.5, "depth_scale": 1000})");
  return camera;
}

Isometry3d readCameraPose(const std::filesystem::path& file) {
  if (file.extension() != ".xml") return readTransform(file);
  const std::string text = readTextFile(file), name = file.filename().string();
  const std::size_t tag = text.find("<position_camera");
  const std::size_t begin = tag == std::string::npos ? tag : text.find('>', tag);
  const std::size_t end = begin == std::string::npos ? begin : text.find('<', begin);
  const std::vector<double> v =
      end == std::string::npos ? std::vector<double>{} : numbersIn(text.substr(begin + 1, end - begin - 1));
  if (v.size() != 7)
    throw InputError(name + " has no <position_camera> of seven numbers (quaternion x y z w, translation)");
  const Eigen::Quaterniond turn(v[3], v[0], v[1], v[2]);
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() << v[4], v[5], v[6];
  if (!(std::abs(turn.norm() - 1) < 1e-2) || !pose.translation().allFinite())
    throw InputError(name + ": its quaternion has length " + numberText(turn.norm()) +
                     ", not 1; export the pose again");
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

}  // namespace falciform
