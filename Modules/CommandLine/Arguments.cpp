#include "Modules/CommandLine/Arguments.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>

namespace falciform::commandline {

std::string kebabCase(std::string_view key) {
  std::string text;
  for (const char c : key) {
    if (std::isupper(static_cast<unsigned char>(c)) && !text.empty()) text += '-';
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

std::string camelCase(std::string_view flag) {
  std::string text;
  bool upper = false;
  for (const char c : flag) {
    if (c == '-' || c == '_') {
      upper = true;
    } else {
      text += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      upper = false;
    }
  }
  return text;
}

std::string flagName(const FieldInfo& info) {
  std::string name = kebabCase(info.key);
  const std::string suffix = "-" + std::string(info.unit);
  if (!info.unit.empty() && name.ends_with(suffix)) name.resize(name.size() - suffix.size());
  return name;
}

std::string numberText(double value) {
  char text[32];
  // Whole numbers without an exponent: 3D Slicer reads "1e+05" as the integer 1.
  const bool whole = std::abs(value) < 1e15 && value == std::floor(value);
  const auto end = whole ? std::to_chars(text, text + sizeof text, static_cast<long long>(value)).ptr
                         : std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string integersText(const std::vector<int>& values) {
  std::string text;
  for (const int value : values) text += (text.empty() ? "" : ",") + std::to_string(value);
  return text;
}

Syntax::Syntax(std::string command, std::string title, std::string summary)
    : command_(std::move(command)), title_(std::move(title)), summary_(std::move(summary)) {}

void Syntax::add(Argument argument) {
  assert(!find(argument.name) && "an argument is declared twice");
  arguments_.push_back(std::move(argument));
}

void Syntax::rename(const std::string& name, const std::string& preferred) {
  const auto found =
      std::find_if(arguments_.begin(), arguments_.end(), [&](const Argument& a) { return a.name == name; });
  assert(found != arguments_.end());
  found->name = preferred;
  if (found->alias.empty()) found->alias = name;
}

const Argument* Syntax::find(std::string_view name) const {
  for (const Argument& argument : arguments_)
    if (argument.name == name || (!argument.alias.empty() && argument.alias == name)) return &argument;
  return nullptr;
}

Argument Syntax::argumentOf(const FieldInfo& info, const std::string& group) {
  Argument argument;
  argument.name = flagName(info);
  if (const std::string whole = kebabCase(info.key); whole != argument.name) argument.alias = whole;
  argument.label = info.label;
  argument.unit = info.unit;
  argument.help = info.help;
  argument.min = info.min;
  argument.max = info.max;
  argument.group = group;
  return argument;
}

void Syntax::negate(Argument& argument) {
  argument.name = "no-" + argument.name;
  argument.label = "No: " + argument.label;
  argument.help = "Turns this off: " + argument.help;
}

void addGlobalArguments(Syntax& syntax) {
  using enum ArgumentKind;
  const auto add = [&](Argument argument) {
    argument.group = kGlobalGroup;
    syntax.add(std::move(argument));
  };
  add({.name = "report",
       .kind = File,
       .label = "Report",
       .help = "Also write the JSON sidecar to this file.",
       .output = true});
  if (syntax.find("seed") == nullptr)  // a command without random draws may mean another kind of seed
    add({.name = "seed",
         .kind = Integer,
         .label = "Seed",
         .help = "Of every random draw; the same seed gives the same result.",
         .fallback = "1",
         .min = 0,
         .max = 2147483647});
  add({.name = "threads",
       .kind = Integer,
       .label = "Threads",
       .help = "0: all cores. Results do not depend on it.",
       .fallback = "0",
       .min = 0,
       .max = 1024});
  add({.name = "quiet", .kind = Flag, .label = "Quiet", .help = "Print warnings and errors only."});
  add({.name = "force", .kind = Flag, .label = "Replace files", .help = "Replace files that exist."});
  add({.name = "slicer-progress",
       .kind = Flag,
       .label = "Slicer progress",
       .help = "Run as a module of 3D Slicer: progress on standard output, values left at their default "
               "count as not given."});
  add({.name = "returnparameterfile",
       .kind = File,
       .label = "Return parameters",
       .help = "Write figures as `name = value` to this file, for 3D Slicer."});
  add({.name = "processinformationaddress",
       .kind = Text,
       .label = "Process information",
       .help = "Taken from 3D Slicer and not used."});
  add({.name = "xml",
       .kind = Flag,
       .label = "XML",
       .help = "Print 3D Slicer's description of this command."});
  add({.name = "help", .kind = Flag, .label = "Help", .help = "Print this."});
}

void declareSeries(Syntax& syntax, const std::string& group, const std::string& what) {
  syntax.add({.name = "series",
              .label = "DICOM series",
              .help = "Number or code of the DICOM series " + what +
                      ", where its folder holds several; falciform info FOLDER lists them.",
              .group = group});
}

}  // namespace falciform::commandline
