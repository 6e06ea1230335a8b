#include "Modules/CommandLine/ParsedArguments.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <charconv>
#include <sstream>

namespace falciform::commandline {

namespace {

std::string shown(const Argument& argument) {
  return argument.positional ? argument.name : "--" + argument.name;
}

void checkNumber(const Argument& argument, double value) {
  if (argument.min == argument.max) return;
  const std::string flag = shown(argument);
  checkRange(FieldInfo{flag, argument.label, argument.unit, argument.min, argument.max, argument.help},
             value);
}

/// A wrong ending of an output shall not show after minutes of computing.
void checkEnding(const Argument& argument, const std::string& value) {
  static const std::vector<std::string_view> surfaces{".vtp", ".vtk", ".stl", ".ply", ".obj"},
      transforms{".tfm", ".txt", ".json"};
  const auto& allowed = argument.kind == ArgumentKind::Surface ? surfaces : transforms;
  std::string ending = std::filesystem::path(value).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (std::find(allowed.begin(), allowed.end(), ending) == allowed.end())
    throw InputError(shown(argument) + " is '" + value + "'; let it end in " + listOfNames(allowed));
}

void checkValue(const Argument& argument, const std::string& value) {
  switch (argument.kind) {
    case ArgumentKind::Integer:
      checkNumber(argument, parseInteger(shown(argument), value));
      break;
    case ArgumentKind::Number:
      checkNumber(argument, parseNumber(shown(argument), value));
      break;
    case ArgumentKind::Integers:
      for (const int one : parseIntegers(shown(argument), value)) checkNumber(argument, one);
      break;
    case ArgumentKind::Choice:
      if (std::find(argument.choices.begin(), argument.choices.end(), value) == argument.choices.end()) {
        const std::vector<std::string_view> names(argument.choices.begin(), argument.choices.end());
        throw InputError(shown(argument) + " is '" + value + "'; choose " + listOfNames(names));
      }
      break;
    case ArgumentKind::Surface:
    case ArgumentKind::Transform:
      if (argument.output) checkEnding(argument, value);
      [[fallthrough]];
    default:
      if (value.empty()) throw InputError(shown(argument) + " is empty; give a value");
  }
}

[[noreturn]] void refuseUnknown(const Syntax& syntax, const std::string& word) {
  throw InputError("'" + syntax.command() + "' knows no " + word + "; see falciform " + syntax.command() +
                   " --help");
}

}  // namespace

double parseNumber(const std::string& what, const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(what + " is '" + text + "'; it must be a number");
  return value;
}

int parseInteger(const std::string& what, const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(what + " is '" + text + "'; it must be a whole number");
  return value;
}

std::vector<int> parseIntegers(const std::string& what, const std::string& text) {
  std::vector<int> values;
  if (text.empty()) return values;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) values.push_back(parseInteger(what, part));
  if (text.back() == ',')
    throw InputError(what + " is '" + text + "'; it must be whole numbers with commas between");
  return values;
}

ParsedArguments::ParsedArguments(const Syntax& syntax, const std::vector<std::string>& words)
    : syntax_(&syntax) {
  std::vector<const Argument*> open;  // positional arguments still to be filled
  for (const Argument& argument : syntax.arguments())
    if (argument.positional) open.push_back(&argument);

  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (!word.starts_with("--")) {
      if (word.size() > 1 && word[0] == '-') refuseUnknown(syntax, "option " + word);
      if (open.empty())
        throw InputError("'" + word + "' is one argument too many; see falciform " + syntax.command() +
                         " --help");
      take(*open.front(), word);
      open.erase(open.begin());
      continue;
    }
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(2, equals == std::string::npos ? equals : equals - 2);
    const Argument* argument = syntax.find(name);
    if (!argument || argument->positional) refuseUnknown(syntax, "option --" + name);
    if (argument->kind == ArgumentKind::Flag) {
      if (equals != std::string::npos)
        throw InputError("--" + name + " takes no value; leave '" + word.substr(equals) + "' out");
      given_[argument->name] = "true";
    } else if (equals != std::string::npos) {
      take(*argument, word.substr(equals + 1));
    } else if (i + 1 < words.size()) {
      take(*argument, words[++i]);
    } else {
      throw InputError("--" + name + " has no value; see falciform " + syntax.command() + " --help");
    }
  }
  if (has("help") || has("xml")) return;
  if (has("slicer-progress"))  // Slicer passes its whole form; a preset shall not be overruled by untouched
                               // fields
    std::erase_if(given_, [&](const auto& entry) {
      const Argument& argument = *syntax.find(entry.first);
      return argument.kind != ArgumentKind::Flag && entry.second == argument.fallback;
    });
  for (const Argument& argument : syntax.arguments())
    if (argument.required && !given_.count(argument.name))
      throw InputError(shown(argument) + " is missing (" + argument.label + "); see falciform " +
                       syntax.command() + " --help");
}

void ParsedArguments::take(const Argument& argument, const std::string& value) {
  if (given_.count(argument.name)) throw InputError(shown(argument) + " is given twice; give it once");
  // Slicer passes an empty list for an untouched vector field.
  if (!(value.empty() && argument.kind == ArgumentKind::Integers)) checkValue(argument, value);
  given_[argument.name] = value;
}

bool ParsedArguments::has(const std::string& name) const {
  const Argument* argument = syntax_->find(name);
  assert(argument && "an argument that is asked for must be declared");
  return argument && given_.count(argument->name) > 0;
}

std::string ParsedArguments::text(const std::string& name) const {
  const Argument* argument = syntax_->find(name);
  assert(argument && "an argument that is asked for must be declared");
  if (!argument) return {};
  const auto found = given_.find(argument->name);
  return found == given_.end() ? argument->fallback : found->second;
}

}  // namespace falciform::commandline
