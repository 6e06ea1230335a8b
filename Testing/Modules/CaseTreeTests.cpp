#include <gtest/gtest.h>

#include <QSpinBox>

#include "Testing/Modules/PanelFixture.h"
#include "Widgets/Views/CaseTree.h"

namespace falciform::test {
namespace {

struct CaseTreeTest : PanelTest {
  CaseTree tree{bench.document, bench.view};

  QTreeWidgetItem* row(const char* name) {
    const auto found = tree.findItems(name, Qt::MatchExactly);
    return found.isEmpty() ? nullptr : found.front();
  }
};

TEST_F(CaseTreeTest, AnEmptyCaseSaysHowToFillIt) {
  ASSERT_EQ(tree.topLevelItemCount(), 1);
  EXPECT_TRUE(tree.topLevelItem(0)->text(0).contains("drop a file"));
}

TEST_F(CaseTreeTest, EveryPartOfTheCaseHasARow) {
  openPreopAndScan();
  bench.document.setStructure("portal vein", std::make_shared<const Surface>(sphere(5, 1)));
  EXPECT_TRUE(row("Pre-op liver"));
  EXPECT_TRUE(row("Scan"));
  EXPECT_TRUE(row("portal vein"));
  EXPECT_EQ(tree.topLevelItemCount(), 3);
  bench.document.setStructure("portal vein", nullptr);
  EXPECT_FALSE(row("portal vein"));
}

TEST_F(CaseTreeTest, TheEyeHidesThePart) {
  openPreopAndScan();
  row("Scan")->setCheckState(CaseTree::kName, Qt::Unchecked);
  EXPECT_FALSE(bench.view.look(part::kScan).visible);
  EXPECT_TRUE(bench.view.look(part::kPreop).visible);
}

TEST_F(CaseTreeTest, OpacityIsTheViewsBothWays) {
  openPreopAndScan();
  auto& opacity = child<QSpinBox>(tree, "opacity_preop");
  opacity.setValue(40);
  EXPECT_DOUBLE_EQ(bench.view.look(part::kPreop).opacity, 0.4);
  PartLook look = bench.view.look(part::kPreop);
  look.opacity = 0.7;
  bench.view.setLook(part::kPreop, look);
  EXPECT_EQ(opacity.value(), 70);
}

TEST_F(CaseTreeTest, LooksOutliveAChangeOfTheSurface) {
  openPreopAndScan();
  child<QSpinBox>(tree, "opacity_preop").setValue(40);
  bench.document.setPreop(std::make_shared<const Surface>(*bench.document.preop()));
  EXPECT_EQ(child<QSpinBox>(tree, "opacity_preop").value(), 40);
}

TEST_F(CaseTreeTest, AStaleRegistrationIsMarked) {
  openPreopAndScan();
  bench.document.setRegistration(std::make_shared<const RegistrationResult>());
  EXPECT_TRUE(row("Registration"));
  bench.document.setPreop(std::make_shared<const Surface>(*bench.document.preop()));
  EXPECT_TRUE(row("Registration (out of date)"));
}

}  // namespace
}  // namespace falciform::test
