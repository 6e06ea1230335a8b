#pragma once
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "Logic/Core/Settings.h"

namespace falciform::commandline {

/// What an argument's value is: decides how it is checked, how help writes it and what 3D Slicer's form
/// shows.
enum class ArgumentKind {
  Flag,
  Integer,
  Number,
  Text,
  Choice,
  Integers,
  Surface,
  LabelMap,
  Transform,
  Points,
  File,
  Folder
};

/// One argument of a command. Parsing, help and Slicer's XML all read this and nothing else.
struct Argument {
  std::string name;  ///< `--name`, kebab-case; of a positional argument its name in the usage line
  ArgumentKind kind = ArgumentKind::Text;
  std::string label = {}, unit = {}, help = {};
  std::string fallback = {};              ///< default as it would be typed; empty: none
  double min = 0, max = 0;                ///< range of numbers, both ends allowed; unchecked if equal
  std::vector<std::string> choices = {};  ///< of ArgumentKind::Choice
  bool required = false, positional = false, output = false;
  std::string alias = {};  ///< another spelling, without dashes
  std::string group = {};  ///< heading in help and in the form
};

/// A number or text that the command reports back to 3D Slicer by `--returnparameterfile`: a key of the
/// figures.
struct ResultField {
  std::string key, label, unit;
};

/// `edgeLengthMm` in mm -> `edge-length`: the unit stands in the help, not in the flag.
[[nodiscard]] std::string flagName(const FieldInfo& info);
/// `edgeLengthMm` -> `edge-length-mm`.
[[nodiscard]] std::string kebabCase(std::string_view key);
/// `edge-length` -> `edgeLength`, for XML names.
[[nodiscard]] std::string camelCase(std::string_view flag);
/// Shortest text that reads back as `value`, C locale.
[[nodiscard]] std::string numberText(double value);
/// "1,2,3".
[[nodiscard]] std::string integersText(const std::vector<int>& values);

/// All that a command takes and reports.
class Syntax {
 public:
  Syntax(std::string command, std::string title, std::string summary);

  void add(Argument argument);
  void addResult(ResultField field) { results_.push_back(std::move(field)); }

  /// One argument a setting, from `describe`. `seed` is left to the global `--seed`; a switch that is on by
  /// default becomes `--no-...`, since 3D Slicer can only turn flags on. `prefix` ("mesh-") keeps steps apart
  /// that have settings of one name.
  template <class S>
  void addSettings(S defaults, const std::string& group, const std::string& prefix = {}) {
    describe(defaults, [&]<class T>(const FieldInfo& info, T& value) {
      if (info.key == "seed") return;
      Argument argument = argumentOf(info, group);
      argument.name = prefix + argument.name;
      if (!argument.alias.empty()) argument.alias = prefix + argument.alias;
      if constexpr (std::is_same_v<T, bool>) {
        argument.kind = ArgumentKind::Flag;
        if (value) negate(argument);
      } else if constexpr (std::is_same_v<T, int>) {
        argument.kind = ArgumentKind::Integer;
        argument.fallback = std::to_string(value);
      } else if constexpr (std::is_same_v<T, double>) {
        argument.kind = ArgumentKind::Number;
        argument.fallback = numberText(value);
      } else if constexpr (std::is_same_v<T, std::vector<int>>) {
        argument.kind = ArgumentKind::Integers;
        argument.fallback = integersText(value);
      } else if constexpr (NamedEnum<T>) {
        argument.kind = ArgumentKind::Choice;
        argument.fallback = enumToString(value);
        for (const std::string_view name : enumNames(T{})) argument.choices.emplace_back(name);
      } else {
        argument.fallback = value;
      }
      add(std::move(argument));
    });
  }

  /// Another spelling of a declared argument; `preferred` is the one that help shows.
  void rename(const std::string& name, const std::string& preferred);

  /// The argument called or aliased so, or nullptr.
  [[nodiscard]] const Argument* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Argument>& arguments() const { return arguments_; }
  [[nodiscard]] const std::vector<ResultField>& results() const { return results_; }
  [[nodiscard]] const std::string& command() const { return command_; }
  [[nodiscard]] const std::string& title() const { return title_; }
  [[nodiscard]] const std::string& summary() const { return summary_; }

 private:
  static Argument argumentOf(const FieldInfo& info, const std::string& group);
  static void negate(Argument& argument);

  std::string command_, title_, summary_;
  std::vector<Argument> arguments_;
  std::vector<ResultField> results_;
};

/// The group of flags that every command takes.
inline constexpr char kGlobalGroup[] = "Every command";
void addGlobalArguments(Syntax& syntax);

/// --series: which of several DICOM series is meant, "of the label map".
void declareSeries(Syntax& syntax, const std::string& group, const std::string& what);

}  // namespace falciform::commandline
