#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollBar>
#include <set>

#include "Modules/ModuleList.h"
#include "Modules/ModulePanel.h"
#include "Testing/Modules/PanelFixture.h"

namespace falciform::test {
namespace {

bool isControl(const QWidget* widget) {
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
         qobject_cast<const QAbstractItemView*>(widget);
}

/// Parts of a control (a spin box's line, a list's popup, a table's header) are Qt's.
bool isPartOfAControl(const QWidget* widget) {
  for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget())
    if (isControl(parent)) return true;
  return false;
}

struct EveryModule : PanelTest, testing::WithParamInterface<std::size_t> {
  std::unique_ptr<ModulePanel> panel{moduleList()[GetParam()].makePanel(bench, nullptr)};
};

TEST_P(EveryModule, HasANameAndATooltipOnEveryControl) {
  int controls = 0;
  for (const QWidget* widget : panel->findChildren<QWidget*>()) {
    if (!isControl(widget) || isPartOfAControl(widget)) continue;
    ++controls;
    EXPECT_FALSE(widget->objectName().isEmpty()) << widget->metaObject()->className();
    EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->objectName().toStdString();
  }
  EXPECT_GT(controls, 0);
}

TEST_P(EveryModule, SpinBoxesWithAUnitNameItInTheirTooltip) {
  for (const QAbstractSpinBox* box : panel->findChildren<QAbstractSpinBox*>()) {
    if (!box->text().endsWith(" mm")) continue;
    EXPECT_TRUE(box->toolTip().contains("Unit: mm")) << box->objectName().toStdString();
    EXPECT_TRUE(box->toolTip().contains("Range: ")) << box->objectName().toStdString();
  }
}

TEST_P(EveryModule, SurvivesEveryStateOfTheCase) {
  openPreopAndScan();
  bench.document.setRegistration(std::make_shared<const RegistrationResult>());
  panel->enter();
  bench.document.setScan(nullptr);
  bench.document.setPreop(nullptr);
  bench.document.clear();
  panel->leave();
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

INSTANTIATE_TEST_SUITE_P(Modules, EveryModule, testing::Range(std::size_t{0}, moduleList().size()),
                         [](const auto& of) { return std::string(moduleList()[of.param].key); });

TEST(ModuleList, StandsInTheOrderOfTheWork) {
  std::vector<std::string> keys;
  for (const Module& module : moduleList()) keys.emplace_back(module.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"SegmentationImport", "ScanPreparation", "PatchPainting",
                                            "Registration", "DeformationAnalysis", "AtlasUpdate"}));
}

}  // namespace
}  // namespace falciform::test
