#include <gtest/gtest.h>

#include "Logic/IO/SurfaceFiles.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

struct CaseFilesTest : PanelTest {
  TemporaryFolder folder;
};

TEST_F(CaseFilesTest, SavingAndOpeningRestoresTheWholeCase) {
  openPreopAndScan();
  bench.document.setName("Phantom 3");
  bench.document.setStructure("tumour", std::make_shared<const Surface>(sphere(8, 2)));
  bench.document.setPreopLandmarks({{{"A", {1, 2, 3}}}, "LPS"});
  auto registration = std::make_shared<RegistrationResult>();
  registration->scanFromPreop = scanFromPreop;
  bench.document.setRegistration(registration);
  EXPECT_TRUE(bench.document.modified());
  ASSERT_TRUE(bench.files.save(folder / "case"));
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
  EXPECT_FALSE(bench.document.modified());

  Workbench other(JobRunner::Mode::Inline);
  ASSERT_TRUE(other.files.open(folder / "case", FileRole::Case));
  ASSERT_TRUE(other.document.preop() && other.document.scan() && other.document.registration());
  EXPECT_EQ(other.document.name(), "Phantom 3");
  EXPECT_EQ(other.document.preop()->points, bench.document.preop()->points);
  EXPECT_EQ(other.document.preop()->patch, bench.document.preop()->patch);
  EXPECT_EQ(other.document.scan()->points, bench.document.scan()->points);
  EXPECT_EQ(other.document.structures().count("tumour"), 1u);
  EXPECT_EQ(other.document.preopLandmarks().points.size(), 1u);
  // Twelve significant digits or more in the JSON.
  EXPECT_TRUE(other.document.registration()->scanFromPreop.isApprox(scanFromPreop, 1e-10));
  EXPECT_FALSE(other.document.registrationStale());
  EXPECT_FALSE(other.document.modified());
}

TEST_F(CaseFilesTest, ASurfaceGoesToThePlaceOfItsRole) {
  writeSurface(folder / "a.vtp", sphere(50, 2), Overwrite::Refuse);
  bench.files.open(folder / "a.vtp", FileRole::Preop);
  EXPECT_TRUE(bench.document.preop());
  EXPECT_FALSE(bench.document.scan());
  bench.files.open(folder / "a.vtp", FileRole::Scan);
  EXPECT_TRUE(bench.document.scan());
  bench.files.open(folder / "a.vtp", FileRole::Structure);
  EXPECT_EQ(bench.document.structures().count("a"), 1u);
}

TEST_F(CaseFilesTest, AFileThatCannotBeReadLeavesTheCaseAsItWas) {
  openPreopAndScan();
  const auto before = bench.document.preop();
  bench.files.open(folder / "missing.vtp", FileRole::Preop);
  EXPECT_EQ(bench.document.preop(), before);
  ASSERT_FALSE(errors.isEmpty());
  EXPECT_TRUE(errors.front().contains("missing.vtp"));
}

TEST_F(CaseFilesTest, WhatTheReaderWarnsOfIsLogged) {
  writeSurface(folder / "metres.stl", sphere(0.05, 2), Overwrite::Refuse);  // a liver of 0.1 units
  bench.files.open(folder / "metres.stl", FileRole::Preop);
  EXPECT_TRUE(logged.join(" ").contains("metres")) << logged.join(" | ").toStdString();
}

}  // namespace
}  // namespace falciform::test
