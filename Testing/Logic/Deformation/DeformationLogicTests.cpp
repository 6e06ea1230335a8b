#include "Logic/Deformation/DeformationLogic.h"

#include <gtest/gtest.h>

#include "Logic/Core/Errors.h"
#include "Testing/Support/SmallSurfaces.h"

namespace falciform {
namespace {

TEST(DeformationLogic, SaysWhatIsMissingUntilNothingIs) {
  Case document;
  DeformationLogic logic(document);
  EXPECT_EQ(logic.missingInput(), "Import or open the pre-operative surface first.");
  EXPECT_THROW((void)logic.prepare(), InputError);
  document.setPreop(std::make_shared<Surface>(test::sphere(50, 3)));
  EXPECT_EQ(logic.missingInput(), "Open a scan first.");
  document.setScan(std::make_shared<Surface>(test::sphere(53, 3)));
  EXPECT_EQ(logic.missingInput(), "Register the scan to the pre-operative surface first.");
  document.setRegistration(std::make_shared<RegistrationResult>());
  EXPECT_EQ(logic.missingInput(), "");
  EXPECT_NEAR(logic.run().preopAll.mean, 3, 0.02);  // mm: facets of 7 mm edges
  ASSERT_NE(document.distance(), nullptr);
  Surface cloud = *document.preop();
  cloud.triangles.resize(0, 3);
  document.setPreop(std::make_shared<Surface>(cloud));
  EXPECT_NE(logic.missingInput(), "");
}

TEST(DeformationLogic, RunsOnTheCaseAsItWasWhenPrepared) {
  Case document;
  document.setPreop(std::make_shared<Surface>(test::sphere(50, 3)));
  document.setScan(std::make_shared<Surface>(test::sphere(53, 3)));
  auto registration = std::make_shared<RegistrationResult>();
  registration->scanFromPreop.translation() = Vector3d(0, 0, 1);
  document.setRegistration(registration);
  DeformationLogic logic(document);
  logic.settings.reachMm = 5;
  const auto job = logic.prepare();
  logic.settings.reachMm = 0.1;
  document.clear();
  const DistanceMap map = job({});
  EXPECT_NEAR(map.preopAll.max, 4, 0.02);
  EXPECT_NEAR(map.preopAll.min, 2, 0.02);
}

}  // namespace
}  // namespace falciform
