#include "Logic/Registration/Trials/TrialMethod.h"

#include <gmock/gmock.h>

namespace falciform {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusalOf(const std::string& text) {
  try {
    (void)parseTrialMethods(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TrialMethod, PresetMethodAndLabelsAreRead) {
  const auto methods = parseTrialMethods("icp,picp:1,picp:1+2,thesis-phantom/picp:1+12,thesis-clinical/icp");
  ASSERT_EQ(methods.size(), 5u);
  EXPECT_EQ(methods[0].settings.method, RegistrationMethod::Icp);
  EXPECT_THAT(methods[1].settings.patches, ElementsAre(1));
  EXPECT_THAT(methods[2].settings.patches, ElementsAre(1, 2));
  EXPECT_EQ(methods[2].name, "picp:1+2");
  RegistrationSettings phantom = registrationPreset("thesis-phantom");
  phantom.patches = {1, 12};
  EXPECT_EQ(settingsToJson(methods[3].settings), settingsToJson(phantom));
  EXPECT_EQ(methods[4].settings.weightMax, registrationPreset("thesis-clinical").weightMax);
}

TEST(TrialMethod, EveryMethodThatThereIsCanBeTried) {
  for (const std::string_view name : enumNames(RegistrationMethod{}))
    EXPECT_EQ(enumToString(parseTrialMethod(std::string(name)).settings.method), name);
}

TEST(TrialMethod, MistakesAreOneLineThatListsTheChoices) {
  EXPECT_THAT(refusalOf("magic"), HasSubstr(listOfNames(enumNames(RegistrationMethod{}))));
  EXPECT_THAT(refusalOf("thesis/icp"), HasSubstr("thesis-phantom"));
  EXPECT_THAT(refusalOf("icp,,picp"), HasSubstr("''"));
  EXPECT_THAT(refusalOf(""), HasSubstr("choose"));
  EXPECT_THAT(refusalOf("picp:1,picp:2,picp:1"), HasSubstr("'picp:1' stands twice"));
  for (const char* bad : {"picp:", "picp:0", "picp:256", "picp:1+", "picp:1+x", "picp:1 2"})
    EXPECT_THAT(refusalOf(bad), HasSubstr("from 1 to 255")) << bad;
  EXPECT_THAT(refusalOf("icp:1"), HasSubstr("icp uses none"));
}

}  // namespace
}  // namespace falciform
