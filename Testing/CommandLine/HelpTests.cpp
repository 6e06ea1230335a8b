#include <gmock/gmock.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <charconv>
#include <cmath>
#include <map>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Atlas/UpdateSettings.h"
#include "Logic/Biomechanics/MeshSettings.h"
#include "Logic/Deformation/Cohort/LabelPermutation.h"
#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Deformation/Normalisation/LiverRegistration.h"
#include "Logic/Registration/RegistrationSettings.h"
#include "Logic/Registration/Trials/Trials.h"
#include "Logic/Segmentation/LevelSetSettings.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/CommandLine/Program.h"

namespace falciform::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> kCommands{"segment",    "import",    "suggest", "patches",     "register",
                                         "distance",   "normalise", "cohort",  "run",         "demo",
                                         "synthesise", "trials",    "mesh",    "atlas build", "atlas info",
                                         "locate",     "fiducials", "info"};

/// A call of a command of one word or two.
std::vector<std::string> call(const std::string& command, const std::string& flag) {
  const std::size_t blank = command.find(' ');
  if (blank == std::string::npos) return {command, flag};
  return {command.substr(0, blank), command.substr(blank + 1), flag};
}

/// "edgeLengthMm" in mm -> "edge-length".
std::string expectedFlag(const FieldInfo& info) {
  std::string flag;
  for (const char c : info.key) {
    if (std::isupper(static_cast<unsigned char>(c))) flag += '-';
    flag += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  const std::string unit = "-" + std::string(info.unit);
  if (unit.size() > 1 && flag.ends_with(unit)) flag.resize(flag.size() - unit.size());
  return flag == "labels" ? "label" : flag;
}

/// The help with line breaks and runs of blanks as one blank.
std::string unwrapped(const std::string& text) {
  std::string flat;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c)))
      flat += c;
    else if (!flat.empty() && flat.back() != ' ')
      flat += ' ';
  return flat;
}

/// Whole numbers plainly, others in the shortest way.
std::string number(double value) {
  if (value == std::floor(value)) return std::to_string(static_cast<long long>(value));
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

template <class S>
void expectSettingsInHelp(const std::string& command, const std::string& prefix = {}) {
  const std::string help = unwrapped(falciform(call(command, "--help")).out);
  S settings;
  describe(settings, [&]<class T>(const FieldInfo& info, T&) {
    if (info.key == "seed") return;
    SCOPED_TRACE(command + " --help, " + std::string(info.key));
    const std::size_t at = help.find(prefix + expectedFlag(info) + " ");
    ASSERT_NE(at, std::string::npos);
    EXPECT_THAT(help, HasSubstr(std::string(info.help)));
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>) {
      const std::string unit = info.unit.empty() ? "" : std::string(info.unit) + "; ";
      EXPECT_THAT(help.substr(at),
                  HasSubstr("[" + unit + number(info.min) + " to " + number(info.max) + ";"));
    }
    if constexpr (NamedEnum<T>) {
      EXPECT_THAT(help, HasSubstr(listOfNames(enumNames(T{}))));
    }
  });
}

TEST(Help, EverySettingOfEveryCommandIsListed) {
  expectSettingsInHelp<LevelSetSettings>("segment");
  expectSettingsInHelp<SurfaceImportSettings>("import");
  expectSettingsInHelp<RegistrationSettings>("register");
  expectSettingsInHelp<DistanceSettings>("distance");
  expectSettingsInHelp<PermutationSettings>("cohort");
  expectSettingsInHelp<NormalisationSettings>("normalise");
  expectSettingsInHelp<TrialSettings>("trials");
  expectSettingsInHelp<MeshSettings>("atlas build");
  expectSettingsInHelp<MeshSettings>("mesh");
  expectSettingsInHelp<ScanVariation>("trials");
  expectSettingsInHelp<SyntheticLiverSettings>("synthesise");
  expectSettingsInHelp<VirtualScannerSettings>("synthesise");
  for (const char* command : {"run", "demo"}) {
    expectSettingsInHelp<SurfaceImportSettings>(command);
    expectSettingsInHelp<RegistrationSettings>(command);
    expectSettingsInHelp<DistanceSettings>(command);
    expectSettingsInHelp<MeshSettings>(command, "mesh-");
    expectSettingsInHelp<UpdateSettings>(command, "update-");
  }
}

TEST(Help, FlagsOfEveryCommandAreThereEverywhere) {
  for (const std::string& command : kCommands) {
    const Ran ran = falciform(call(command, "--help"));
    EXPECT_EQ(ran.exitCode, 0) << command;
    EXPECT_EQ(ran.err, "") << command;
    for (const char* flag : {"--report", "--seed", "--threads", "--quiet", "--force", "--help", "--xml"})
      EXPECT_THAT(ran.out, HasSubstr(std::string("  ") + flag)) << command;
  }
}

/// Parameters of all groups: name -> element.
std::map<std::string, vtkXMLDataElement*> parametersOf(vtkXMLDataElement* root) {
  std::map<std::string, vtkXMLDataElement*> found;
  for (int g = 0; g < root->GetNumberOfNestedElements(); ++g) {
    vtkXMLDataElement* group = root->GetNestedElement(g);
    if (std::string(group->GetName()) != "parameters") continue;
    for (int p = 0; p < group->GetNumberOfNestedElements(); ++p)
      if (vtkXMLDataElement* name = group->GetNestedElement(p)->FindNestedElementWithName("name")) {
        EXPECT_EQ(found.count(name->GetCharacterData()), 0u) << name->GetCharacterData() << " stands twice";
        found[name->GetCharacterData()] = group->GetNestedElement(p);
      }
  }
  return found;
}

TEST(SlicerDescription, EveryCommandPrintsWellFormedXmlAndNothingElse) {
  for (const std::string& command : kCommands) {
    SCOPED_TRACE(command);
    const Ran ran = falciform(call(command, "--xml"));
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_EQ(ran.err, "");
    ASSERT_THAT(ran.out, StartsWith("<?xml"));
    const auto root =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(ran.out.c_str()));
    ASSERT_NE(root, nullptr);
    EXPECT_STREQ(root->GetName(), "executable");
    for (const char* wanted : {"category", "title", "description"})
      EXPECT_NE(root->FindNestedElementWithName(wanted), nullptr) << wanted;
    EXPECT_FALSE(parametersOf(root).empty());
    for (const auto& [name, parameter] : parametersOf(root)) {
      EXPECT_NE(parameter->FindNestedElementWithName("label"), nullptr) << name;
      const bool output =
          parameter->FindNestedElementWithName("channel") &&
          std::string(parameter->FindNestedElementWithName("channel")->GetCharacterData()) == "output";
      EXPECT_TRUE(output || parameter->FindNestedElementWithName("longflag") ||
                  parameter->FindNestedElementWithName("index"))
          << name;
    }
  }
}

TEST(SlicerDescription, RegistrationSaysSurfacesTransformAndPointsInLps) {
  const Ran ran = falciform({"register", "--xml"});
  const auto root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(ran.out.c_str()));
  ASSERT_NE(root, nullptr);
  auto parameters = parametersOf(root);
  ASSERT_EQ(parameters.count("preop") + parameters.count("transformOut") + parameters.count("targets") +
                parameters.count("method"),
            4u);
  EXPECT_STREQ(parameters["preop"]->GetName(), "geometry");
  EXPECT_STREQ(parameters["preop"]->GetAttribute("fileExtensions"), ".vtp");
  EXPECT_STREQ(parameters["transformOut"]->GetAttribute("fileExtensions"), ".tfm");
  EXPECT_STREQ(parameters["targets"]->GetAttribute("fileExtensions"), ".mrk.json");
  EXPECT_STREQ(parameters["targets"]->GetAttribute("coordinateSystem"), "lps");
  EXPECT_STREQ(parameters["method"]->GetName(), "string-enumeration");
}

}  // namespace
}  // namespace falciform::test
