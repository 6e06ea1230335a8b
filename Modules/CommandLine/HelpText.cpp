#include "Modules/CommandLine/HelpText.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "Modules/CommandLine/Commands.h"
#include "Version.h"

namespace falciform::commandline {

namespace {

constexpr std::size_t kColumns = 100, kIndent = 30;

std::string valueName(const Argument& argument) {
  switch (argument.kind) {
    case ArgumentKind::Flag:
      return "";
    case ArgumentKind::Integer:
      return "N";
    case ArgumentKind::Integers:
      return "N[,N...]";
    case ArgumentKind::Folder:
      return "DIR";
    case ArgumentKind::Choice:
      return "NAME";
    case ArgumentKind::Text:
      return "TEXT";
    case ArgumentKind::Number: {
      std::string unit = argument.unit.empty() ? "X" : argument.unit;
      std::transform(unit.begin(), unit.end(), unit.begin(), [](unsigned char c) { return std::toupper(c); });
      return unit;
    }
    default:
      return "FILE";
  }
}

std::string head(const Argument& argument) {
  if (argument.positional) return argument.name;
  const std::string value = valueName(argument);
  return "--" + argument.name + (value.empty() ? "" : " " + value);
}

/// "[mm, 0 to 50, default 2]" and the like.
std::string facts(const Argument& argument) {
  std::vector<std::string> parts;
  if (argument.required) parts.emplace_back("required");
  if (!argument.unit.empty()) parts.push_back(argument.unit);
  if (argument.min != argument.max)
    parts.push_back(numberText(argument.min) + " to " + numberText(argument.max));
  if (!argument.choices.empty()) {
    const std::vector<std::string_view> names(argument.choices.begin(), argument.choices.end());
    parts.push_back(listOfNames(names));
  }
  if (!argument.fallback.empty()) parts.push_back("default " + argument.fallback);
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? " [" : "; ") + part;
  return text.empty() ? "" : text + "]";
}

void appendWrapped(std::string& out, const std::string& text, std::size_t column) {
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (column + word.size() + 1 > kColumns) {
      out += "\n" + std::string(kIndent, ' ');
      column = kIndent;
    } else if (column > kIndent) {
      out += " ";
      ++column;
    }
    out += word;
    column += word.size();
  }
  out += "\n";
}

void appendArgument(std::string& out, const Argument& argument) {
  std::string left = "  " + head(argument);
  if (left.size() + 2 > kIndent) {
    out += left + "\n" + std::string(kIndent, ' ');
  } else {
    left.resize(kIndent, ' ');
    out += left;
  }
  appendWrapped(out, argument.help + facts(argument), kIndent);
}

}  // namespace

std::string helpText(const Syntax& syntax) {
  std::string out =
      "falciform " + syntax.command() + ": " + syntax.summary() + "\n\nusage: falciform " + syntax.command();
  for (const Argument& argument : syntax.arguments())
    if (argument.positional || argument.required)
      out += argument.required ? " " + head(argument) : " [" + head(argument) + "]";
  out += " [options]\n";
  std::vector<std::string> groups;
  for (const Argument& argument : syntax.arguments())
    if (std::find(groups.begin(), groups.end(), argument.group) == groups.end())
      groups.push_back(argument.group);
  for (const std::string& group : groups) {
    out += "\n" + group + "\n";
    for (const Argument& argument : syntax.arguments())
      if (argument.group == group) appendArgument(out, argument);
  }
  return out + "\nExit code: 0 done, 2 input or usage, 1 a fault of the program, 130 cancelled.\n" +
         kResearchUse + ".\n";
}

std::string overviewText() {
  std::string out = "Falciform " + std::string(kVersion) +
                    ": image-guided liver surgery on the command line\n\n" +
                    "usage: falciform COMMAND [arguments]\n\n";
  for (const Command& command : commands()) {
    std::string left = "  " + command.name;
    left.resize(14, ' ');
    out += left + command.summary + "\n";
  }
  return out + "\nfalciform COMMAND --help   all arguments of a command, with units, ranges and defaults\n" +
         "falciform --version        the version\n\n" + kResearchUse + ".\n";
}

}  // namespace falciform::commandline
