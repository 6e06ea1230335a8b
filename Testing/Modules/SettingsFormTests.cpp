#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>

#include "Logic/Deformation/DistanceMapping.h"
#include "Logic/Registration/RegistrationSettings.h"
#include "Logic/Segmentation/SurfaceImport.h"
#include "Testing/Modules/PanelFixture.h"
#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Forms/SettingsForm.h"

namespace falciform::test {
namespace {

TEST(SettingsForm, EveryDescribedFieldHasAControlWithItsKeyHelpUnitAndRange) {
  RegistrationSettings settings;
  SettingsForm form(settings, {"method"});
  describe(settings, [&]<class T>(const FieldInfo& info, T&) {
    const auto& control = child<QWidget>(form, std::string(info.key).c_str());
    const std::string tip = control.toolTip().toStdString();
    EXPECT_NE(tip.find(info.help), std::string::npos) << info.key;
    EXPECT_NE(tip.find("Default: "), std::string::npos) << info.key;
    if (!info.unit.empty()) {
      EXPECT_NE(tip.find("Unit: " + std::string(info.unit)), std::string::npos) << info.key;
    }
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>) {
      EXPECT_NE(tip.find("Range: "), std::string::npos) << info.key;
    }
  });
}

TEST(SettingsForm, NumberControlsHaveTheRangeAndUnitOfTheDescription) {
  DistanceSettings settings;
  SettingsForm form(settings);
  describe(settings, [&](const FieldInfo& info, double& value) {
    const auto& box = child<QDoubleSpinBox>(form, std::string(info.key).c_str());
    EXPECT_DOUBLE_EQ(box.minimum(), info.min);
    EXPECT_DOUBLE_EQ(box.maximum(), info.max);
    EXPECT_EQ(box.suffix().toStdString(), " " + std::string(info.unit));
    EXPECT_DOUBLE_EQ(box.value(), value);
  });
}

TEST(SettingsForm, ControlsWriteTheSettingsAndSayWhich) {
  RegistrationSettings settings;
  SettingsForm form(settings);
  QStringList edited;
  QObject::connect(&form, &SettingsForm::edited, [&](const QString& key) { edited << key; });
  child<QComboBox>(form, "method").setCurrentIndex(1);
  child<QDoubleSpinBox>(form, "relaxation").setValue(0.25);
  child<QSpinBox>(form, "maxIterations").setValue(77);
  EXPECT_EQ(settings.method, RegistrationMethod::Wgf);
  EXPECT_DOUBLE_EQ(settings.relaxation, 0.25);
  EXPECT_EQ(settings.maxIterations, 77);
  EXPECT_EQ(edited, QStringList({"method", "relaxation", "maxIterations"}));
}

TEST(SettingsForm, RefreshShowsChangedSettingsWithoutAnnouncing) {
  SurfaceImportSettings settings;
  SettingsForm form(settings);
  int edits = 0;
  QObject::connect(&form, &SettingsForm::edited, [&] { ++edits; });
  settings.edgeLengthMm = 3.5;
  settings.fillCavities = false;
  settings.labels = {3, 5};
  form.refresh();
  EXPECT_DOUBLE_EQ(child<QDoubleSpinBox>(form, "edgeLengthMm").value(), 3.5);
  EXPECT_FALSE(child<QCheckBox>(form, "fillCavities").isChecked());
  EXPECT_EQ(child<QLineEdit>(form, "labels").text(), "3, 5");
  EXPECT_EQ(edits, 0);
}

TEST(SettingsForm, ResetRestoresEveryDefault) {
  RegistrationSettings settings;
  settings.method = RegistrationMethod::Icp;
  settings.maxIterations = 3;
  settings.robustScaleMm = 9;
  settings.patches = {2};
  SettingsForm form(settings);
  click(form, "resetToDefaults");
  EXPECT_EQ(settingsToJson(settings), settingsToJson(RegistrationSettings{}));
  EXPECT_EQ(child<QSpinBox>(form, "maxIterations").value(), RegistrationSettings{}.maxIterations);
}

TEST(SettingsForm, AListTakesWholeNumbersInRangeAndNothingMeansAll) {
  RegistrationSettings settings;
  SettingsForm form(settings);
  auto& line = child<QLineEdit>(form, "patches");
  line.setText("1, 2 7,,999,0");
  EXPECT_EQ(settings.patches, (std::vector<int>{1, 2, 7})) << "999 and 0 lie outside [1, 255]";
  line.setText("");
  EXPECT_TRUE(settings.patches.empty());
  EXPECT_EQ(line.placeholderText(), "all");
}

TEST(SettingsForm, FieldsThatAreNotNamedFoldAway) {
  RegistrationSettings settings;
  SettingsForm form(settings, {"method"}, {"patches"});
  EXPECT_TRUE(isShown(form, "method"));
  EXPECT_FALSE(isShown(form, "relaxation"));
  EXPECT_EQ(form.findChild<QWidget*>("patches"), nullptr);
  form.setMoreShown(true);
  EXPECT_TRUE(isShown(form, "relaxation"));
}

TEST(NumberBox, KeepsAndShowsValuesOfAnyMagnitude) {
  NumberBox box;
  box.setRange(1e-9, 1e6);
  for (const double value : {1e-9, 1e-4, 0.05, 1.5, 25.0, 1e6}) {
    box.setValue(value);
    EXPECT_DOUBLE_EQ(box.value(), value);
    EXPECT_DOUBLE_EQ(box.valueFromText(box.textFromValue(value)), value);
  }
  box.setValue(0.05);
  EXPECT_EQ(box.text(), "0.05");
}

TEST(NumberBox, TakesExponentsAndRefusesLettersAndValuesOutOfRange) {
  NumberBox box;
  box.setRange(0, 100);
  box.setSuffix(" mm");
  int position = 0;
  const auto check = [&](QString text) { return box.validate(text, position); };
  EXPECT_EQ(check("2e1 mm"), QValidator::Acceptable);
  EXPECT_EQ(check("1e"), QValidator::Intermediate);
  EXPECT_EQ(check("101"), QValidator::Intermediate);
  EXPECT_EQ(check("abc"), QValidator::Invalid);
  EXPECT_DOUBLE_EQ(box.valueFromText("2e1 mm"), 20);
}

}  // namespace
}  // namespace falciform::test
