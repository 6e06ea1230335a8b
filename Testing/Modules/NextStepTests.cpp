#include "Modules/NextStep.h"

#include <gtest/gtest.h>

#include "Modules/ModuleList.h"
#include "Testing/Modules/PanelFixture.h"

namespace falciform::test {
namespace {

struct NextStepTest : PanelTest {
  [[nodiscard]] std::string module() const { return nextStep(bench.document).module.toStdString(); }
  [[nodiscard]] bool says(const char* word) const { return nextStep(bench.document).words.contains(word); }
  static std::shared_ptr<const Surface> painted(Surface surface, const std::vector<int>& labels) {
    surface.patch.assign(static_cast<std::size_t>(surface.size()), patch::kNone);
    for (std::size_t i = 0; i < labels.size(); ++i) surface.patch[i] = labels[i];
    return std::make_shared<const Surface>(surface);
  }
};

TEST_F(NextStepTest, LeadsFromTheEmptyCaseToTheUpdatedModel) {
  Case& document = bench.document;
  EXPECT_EQ(module(), "SegmentationImport");
  EXPECT_TRUE(says("open"));
  LabelMap labels;
  labels.size = {1, 1, 1};
  labels.voxels = {1};
  document.setLabels(std::make_shared<const LabelMap>(labels));
  EXPECT_TRUE(says("tick"));
  document.setPreop(painted(sphere(50, 2), {}));
  EXPECT_TRUE(says("scan"));
  document.setScan(painted(sphere(50, 2), {}));
  EXPECT_EQ(module(), "PatchPainting");
  EXPECT_EQ(nextStep(document).target, PaintTarget::Preop);
  document.setPreop(painted(sphere(50, 2), {1, 1, 2}));
  EXPECT_EQ(module(), "PatchPainting");
  EXPECT_EQ(nextStep(document).target, PaintTarget::Scan);
  document.setScan(painted(sphere(50, 2), {1}));
  EXPECT_EQ(module(), "Registration");
  document.setRegistration(std::make_shared<const RegistrationResult>());
  EXPECT_EQ(module(), "DeformationAnalysis");
  document.setDistance(std::make_shared<const DistanceMap>());
  EXPECT_EQ(module(), "AtlasUpdate");
  KeptUpdate update;
  update.surface = document.preop();
  document.setUpdate(std::make_shared<const KeptUpdate>(update));
  EXPECT_TRUE(says("save"));
  document.setScan(painted(sphere(50, 2), {1, 2}));
  EXPECT_EQ(module(), "Registration");
  EXPECT_TRUE(says("again"));
}

TEST_F(NextStepTest, IsAlwaysAStepThatThereIs) {
  std::set<std::string> keys;
  for (const Module& one : moduleList()) keys.insert(one.key);
  const auto check = [&] { EXPECT_TRUE(keys.count(module())) << module(); };
  check();
  openPreopAndScan();
  check();
  bench.document.setPreop(nullptr);
  check();
}

}  // namespace
}  // namespace falciform::test
