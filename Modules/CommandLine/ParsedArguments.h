#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "Modules/CommandLine/Arguments.h"

namespace falciform::commandline {

/// "-3", "0.5": the whole of a text as a number; throws InputError that names `what`.
[[nodiscard]] double parseNumber(const std::string& what, const std::string& text);
[[nodiscard]] int parseInteger(const std::string& what, const std::string& text);
/// "1,2,5".
[[nodiscard]] std::vector<int> parseIntegers(const std::string& what, const std::string& text);

/// The arguments of one call, each checked against its declaration. A name asked for must be declared.
class ParsedArguments {
 public:
  /// Reads `--name value`, `--name=value`, flags and positional arguments. Throws InputError for unknown
  /// names, missing values, wrong kinds, values out of range and required arguments that are missing (not
  /// with --help or --xml).
  ParsedArguments(const Syntax& syntax, const std::vector<std::string>& words);

  [[nodiscard]] bool has(const std::string& name) const;          ///< given by the caller; of a flag: set
  [[nodiscard]] std::string text(const std::string& name) const;  ///< as given, or the default
  [[nodiscard]] int integer(const std::string& name) const { return parseInteger(name, text(name)); }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return text(name); }

  /// `settings` with the members replaced that were given; `prefix` as they were declared.
  template <class S>
  [[nodiscard]] S settings(S settings, const std::string& prefix = {}) const {
    describe(settings, [&]<class T>(const FieldInfo& info, T& value) {
      const std::string key = prefix + kebabCase(info.key);
      if constexpr (std::is_same_v<T, bool>) {
        if (declared("no-" + key) && has("no-" + key)) value = false;
        if (declared(key) && has(key)) value = true;
      } else {
        if (!declared(key) || (!has(key) && info.key != "seed")) return;
        const std::string given = text(key), flag = "--" + prefix + flagName(info);
        if constexpr (std::is_same_v<T, int>)
          value = parseInteger(flag, given);
        else if constexpr (std::is_same_v<T, double>)
          value = parseNumber(flag, given);
        else if constexpr (std::is_same_v<T, std::vector<int>>)
          value = parseIntegers(flag, given);
        else if constexpr (NamedEnum<T>)
          value = enumFromString<T>(flag, given);
        else
          value = given;
      }
    });
    return settings;
  }

 private:
  [[nodiscard]] bool declared(const std::string& name) const { return syntax_->find(name) != nullptr; }
  void take(const Argument& argument, const std::string& value);

  const Syntax* syntax_;
  std::map<std::string, std::string> given_;  // by declared name
};

}  // namespace falciform::commandline
