#include "Modules/CommandLine/SlicerXml.h"

#include <algorithm>

#include "Version.h"

namespace falciform::commandline {

namespace {

struct Element {
  std::string name, attributes;
};

Element elementOf(const Argument& argument) {
  switch (argument.kind) {
    case ArgumentKind::Flag:
      return {"boolean", ""};
    case ArgumentKind::Integer:
      return {"integer", ""};
    case ArgumentKind::Number:
      return {"double", ""};
    case ArgumentKind::Choice:
      return {"string-enumeration", ""};
    case ArgumentKind::Integers:
      return {"integer-vector", ""};
    case ArgumentKind::Surface:
      return {"geometry", " fileExtensions=\".vtp\""};
    case ArgumentKind::LabelMap:
      return {"image", " type=\"label\" fileExtensions=\".nrrd\""};
    case ArgumentKind::Transform:
      return {"transform", " type=\"linear\" fileExtensions=\".tfm\""};
    case ArgumentKind::Points:
      return {"pointfile", " fileExtensions=\".mrk.json\" coordinateSystem=\"lps\""};
    case ArgumentKind::File:
      return {"file", ""};
    case ArgumentKind::Folder:
      return {"directory", ""};
    case ArgumentKind::Text:
      break;
  }
  return {"string", ""};
}

bool isFile(const Argument& argument) { return argument.kind >= ArgumentKind::Surface; }

std::string tag(const std::string& name, const std::string& text) {
  return "      <" + name + ">" + escaped(text) + "</" + name + ">\n";
}

std::string parameterXml(const Argument& argument, int index) {
  const Element element = elementOf(argument);
  std::string xml =
      "    <" + element.name + element.attributes + ">\n" + tag("name", camelCase(argument.name));
  xml += argument.positional ? tag("index", std::to_string(index)) : tag("longflag", "--" + argument.name);
  xml += tag("label", argument.label + (argument.unit.empty() ? "" : " (" + argument.unit + ")"));
  xml += tag("description", argument.help);
  if (isFile(argument)) xml += tag("channel", argument.output ? "output" : "input");
  if (argument.kind == ArgumentKind::Flag)
    xml += tag("default", "false");
  else if (!argument.fallback.empty())
    xml += tag("default", argument.fallback);
  for (const std::string& choice : argument.choices) xml += tag("element", choice);
  const bool number = argument.kind == ArgumentKind::Integer || argument.kind == ArgumentKind::Number;
  if (number && argument.min != argument.max)
    xml += "      <constraints>\n  " + tag("minimum", numberText(argument.min)) + "  " +
           tag("maximum", numberText(argument.max)) + "      </constraints>\n";
  return xml + "    </" + element.name + ">\n";
}

/// Flags of every command that make sense in a form; the others are Slicer's own or the terminal's.
bool inForm(const Argument& argument) {
  return argument.group != kGlobalGroup || argument.name == "seed" || argument.name == "threads" ||
         argument.name == "force";
}

std::string resultsXml(const std::vector<ResultField>& results) {
  if (results.empty()) return "";
  std::string xml =
      "  <parameters>\n    <label>Figures</label>\n    <description>What came out; residuals are fit, not "
      "target error.</description>\n";
  for (const ResultField& field : results)
    xml += "    <double>\n" + tag("name", field.key) +
           tag("label", field.label + (field.unit.empty() ? "" : " (" + field.unit + ")")) +
           tag("description", field.label) + tag("channel", "output") + tag("default", "0") +
           "    </double>\n";
  return xml + "  </parameters>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string slicerXml(const Syntax& syntax) {
  std::string xml = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<executable>\n";
  xml += "  <category>Falciform</category>\n  <title>" + escaped(syntax.title()) + "</title>\n";
  xml += "  <description>" + escaped(syntax.summary() + " " + kResearchUse + ".") + "</description>\n";
  xml += "  <version>" + std::string(kVersion) + "</version>\n  <license>Apache-2.0</license>\n";
  std::vector<std::string> groups;
  for (const Argument& argument : syntax.arguments())
    if (inForm(argument) && std::find(groups.begin(), groups.end(), argument.group) == groups.end())
      groups.push_back(argument.group);
  int index = 0;
  for (const std::string& group : groups) {
    const bool advanced = group != groups.front();
    xml += std::string("  <parameters") + (advanced ? " advanced=\"true\"" : "") + ">\n    <label>" +
           escaped(group) + "</label>\n    <description>" + escaped(group) + "</description>\n";
    for (const Argument& argument : syntax.arguments())
      if (argument.group == group && inForm(argument)) {
        xml += parameterXml(argument, index);
        if (argument.positional) ++index;
      }
    xml += "  </parameters>\n";
  }
  return xml + resultsXml(syntax.results()) + "</executable>\n";
}

}  // namespace falciform::commandline
