#pragma once
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "Logic/Core/Errors.h"

namespace falciform {

/// What a user needs to know of one setting. Every settings struct S has one
///   template <class Visitor> void describe(S& s, Visitor&& field) { field(FieldInfo{...}, s.member); ... }
/// beside it; JSON, range checks, command-line flags, Slicer's XML description and the panel's form all come
/// from it. Members may be bool, int, double, std::string, std::vector<int>, or an enum with `enumNames(E)`.
struct FieldInfo {
  std::string_view key;    ///< camelCase, as in JSON; `--kebab-case` on the command line
  std::string_view label;  ///< as on screen
  std::string_view unit;   ///< "mm", "deg", "" for a pure number
  double min = 0,
         max = 0;  ///< range of a number or of a list's entries, both ends allowed; ignored for other types
  std::string_view help;  ///< one sentence
};

/// The names of an enum's values, in order from 0: found by argument-dependent look-up beside each enum.
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
  { enumNames(e) } -> std::convertible_to<std::span<const std::string_view>>;
};

template <NamedEnum E>
[[nodiscard]] std::string enumToString(E value) {
  return std::string(std::span<const std::string_view>(enumNames(value))[static_cast<std::size_t>(value)]);
}

/// "a, b or c", for messages and help.
[[nodiscard]] std::string listOfNames(std::span<const std::string_view> names);

/// Throws InputError naming `key`, `text` and the allowed names if there is no such value.
template <NamedEnum E>
[[nodiscard]] E enumFromString(std::string_view key, std::string_view text) {
  const std::span<const std::string_view> names = enumNames(E{});
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == text) return static_cast<E>(i);
  throw InputError(std::string(key) + " is '" + std::string(text) + "'; choose " + listOfNames(names));
}

/// Throws InputError if `value` lies outside [info.min, info.max] or is not a number.
void checkRange(const FieldInfo& info, double value);

/// Throws InputError if any number of `settings` lies outside its range.
template <class S>
void checkSettings(S settings) {
  describe(settings, []<class T>(const FieldInfo& info, T& value) {
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>)
      checkRange(info, static_cast<double>(value));
  });
}

template <class S>
[[nodiscard]] nlohmann::json settingsToJson(S settings) {
  nlohmann::json json = nlohmann::json::object();
  describe(settings, [&]<class T>(const FieldInfo& info, T& value) {
    if constexpr (NamedEnum<T>)
      json[std::string(info.key)] = enumToString(value);
    else
      json[std::string(info.key)] = value;
  });
  return json;
}

/// Throws InputError for a value of the wrong kind: `key` and what was expected.
[[noreturn]] void refuseJson(const FieldInfo& info, const nlohmann::json& found, std::string_view expected);

/// Defaults overlaid with the keys found in `json`. Throws InputError for unknown keys, wrong kinds and
/// values out of range.
template <class S>
[[nodiscard]] S settingsFromJson(const nlohmann::json& json, S settings = {}) {
  if (!json.is_object()) throw InputError("settings must be a JSON object {\"key\": value, ...}");
  std::vector<std::string> known;
  describe(settings, [&]<class T>(const FieldInfo& info, T& value) {
    known.emplace_back(info.key);
    const auto found = json.find(std::string(info.key));
    if (found == json.end()) return;
    if constexpr (NamedEnum<T>) {
      if (!found->is_string()) refuseJson(info, *found, listOfNames(enumNames(T{})));
      value = enumFromString<T>(info.key, found->template get<std::string>());
    } else if constexpr (std::is_same_v<T, bool>) {
      if (!found->is_boolean()) refuseJson(info, *found, "true or false");
      value = found->template get<bool>();
    } else if constexpr (std::is_same_v<T, int>) {
      if (!found->is_number_integer()) refuseJson(info, *found, "a whole number");
      checkRange(info, found->template get<double>());
      value = found->template get<int>();
    } else if constexpr (std::is_same_v<T, double>) {
      if (!found->is_number()) refuseJson(info, *found, "a number");
      value = found->template get<double>();
    } else if constexpr (std::is_same_v<T, std::vector<int>>) {
      if (!found->is_array()) refuseJson(info, *found, "a list of whole numbers");
      value.clear();
      for (const auto& entry : *found) {
        if (!entry.is_number_integer()) refuseJson(info, *found, "a list of whole numbers");
        checkRange(info, entry.template get<double>());
        value.push_back(entry.template get<int>());
      }
    } else {
      static_assert(std::is_same_v<T, std::string>, "a setting of a kind that JSON cannot hold");
      if (!found->is_string()) refuseJson(info, *found, "a text");
      value = found->template get<std::string>();
    }
  });
  for (const auto& [key, unused] : json.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InputError("settings have no key '" + key + "'; the keys are " + [&] {
        std::string all;
        for (const auto& k : known) all += (all.empty() ? "" : ", ") + k;
        return all;
      }());
  checkSettings(settings);
  return settings;
}

}  // namespace falciform
