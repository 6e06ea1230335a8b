#include <gmock/gmock.h>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/UpdateFiles.h"
#include "Testing/Logic/IO/ResultSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;

KeptUpdate sampleUpdate() {
  KeptUpdate update;
  Surface surface = sphere(50, 2);
  surface.frame = "scanner";
  surface.arrays["expected_error_mm"] = VectorXd::LinSpaced(surface.size(), 0.5, 3.25);
  update.surface = std::make_shared<const Surface>(surface);
  update.structures["tumour / 1"] = std::make_shared<const Surface>(sphere(7, 1, {1, 2, 3}));
  update.targets = {{"t1", false, {1, 2, 3}, {4, 5, 6}, {7, 8, 9.125}, 1.5, 2.5, std::nullopt},
                    {"tumour / 1", true, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 0.25, std::nullopt, std::nullopt}};
  update.scanFromPreop = randomMotion(5);
  update.expectedErrorMeanMm = 1.75;
  update.rmsMm = 0.4;
  update.bendMm = 6.5;
  update.largestMm = 21;
  update.minDetJ = 0.83;
  update.effectiveParameters = 37.5;
  update.seconds = 1.25;
  update.iterations = 17;
  update.converged = true;
  update.stopReason = "the fitted surface has settled";
  update.warnings = {"a warning \"in quotes\""};
  return update;
}

void fill(Case& document) {
  document.setName("Updated");
  document.setPreop(std::make_shared<const Surface>(sphere(50, 2)));
  document.setScan(std::make_shared<const Surface>(sphere(48, 2)));
  document.setRegistration(std::make_shared<const RegistrationResult>(sampleRegistration()));
  document.setUpdate(std::make_shared<const KeptUpdate>(sampleUpdate()));
}

TEST(CaseUpdate, AModelUpdateComesBackWithTheCase) {
  const TemporaryFolder folder;
  Case saved, opened;
  fill(saved);
  saveCase(saved, folder.path(), Overwrite::Refuse);
  EXPECT_THAT(openCase(opened, folder.path()), IsEmpty());
  ASSERT_TRUE(opened.update());
  EXPECT_FALSE(opened.updateStale());
  const KeptUpdate &is = *opened.update(), &was = *saved.update();
  EXPECT_EQ(toJson(is), toJson(was));
  EXPECT_EQ(is.scanFromPreop.matrix(), was.scanFromPreop.matrix());
  EXPECT_EQ(is.surface->points, was.surface->points);
  EXPECT_EQ(is.surface->frame, "scanner");
  EXPECT_EQ(is.surface->arrays, was.surface->arrays);
  EXPECT_EQ(is.structures.at("tumour / 1")->points, was.structures.at("tumour / 1")->points);
  ASSERT_EQ(is.targets.size(), 2u);
  EXPECT_EQ(is.targets[0].now, Vector3d(7, 8, 9.125));
  EXPECT_EQ(is.targets[0].trueErrorMm, 2.5);
  EXPECT_EQ(is.targets[0].rigidErrorMm, std::nullopt);
  EXPECT_TRUE(is.targets[1].structure);
}

TEST(CaseUpdate, AStaleOneStaysStaleAndSavingAgainLeavesItOutWhenItIsGone) {
  const TemporaryFolder folder;
  Case saved, opened;
  fill(saved);
  saved.setScan(saved.scan());
  ASSERT_TRUE(saved.updateStale());
  saveCase(saved, folder.path(), Overwrite::Refuse);
  (void)openCase(opened, folder.path());
  EXPECT_TRUE(opened.updateStale());
  opened.setPreop(std::make_shared<const Surface>(sphere(49, 2)));
  EXPECT_EQ(opened.update(), nullptr) << "of another liver";
  saveCase(opened, folder.path(), Overwrite::Replace);
  EXPECT_EQ(readCaseDescription(folder.path()).update, "");
}

TEST(CaseUpdate, WhatDoesNotFitOrIsDamagedIsRefusedByItsKey) {
  const TemporaryFolder folder;
  Case saved, opened;
  fill(saved);
  saveCase(saved, folder.path(), Overwrite::Refuse);
  const nlohmann::json good = readJsonFile(folder / "update.json");
  const auto refusal = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json json = good;
    json[key] = value;
    put(folder / "update.json", json.dump());
    return refusalOf([&] { (void)openCase(opened, folder.path()); });
  };
  EXPECT_THAT(refusal("rms_mm", "wide"), HasSubstr("rms_mm"));
  EXPECT_THAT(refusal("iterations", 1.5), HasSubstr("iterations"));
  EXPECT_THAT(refusal("converged", 1), HasSubstr("converged"));
  EXPECT_THAT(refusal("scan_from_preop", {1, 2}), HasSubstr("scan_from_preop"));
  EXPECT_THAT(refusal("targets", 7), HasSubstr("targets"));
  EXPECT_THAT(refusal("targets", {{{"name", 3}}}), HasSubstr("name"));
  EXPECT_THAT(refusal("warnings", {1}), HasSubstr("warnings"));
  EXPECT_THAT(refusal("surface", nullptr), HasSubstr("surface"));
  EXPECT_THAT(refusal("surface", "scan_missing.vtp"), HasSubstr("scan_missing.vtp"));
  EXPECT_THAT(refusal("structures", {1}), HasSubstr("structures"));
  for (const auto& [key, value] : good.items()) {
    if (key == "stale" || key == "structures") continue;
    nlohmann::json json = good;
    json.erase(key);
    put(folder / "update.json", json.dump());
    EXPECT_THAT(refusalOf([&] { (void)openCase(opened, folder.path()); }), HasSubstr(key));
  }
  writeJsonFile(folder / "update.json", good, Overwrite::Replace);
  Case other;
  other.setName("Updated");
  EXPECT_EQ(opened.preop(), nullptr) << "nothing of it was opened";
}

TEST(CaseUpdate, TheViewIsKeptAsItIsAndASaveWithoutOneLeavesIt) {
  const TemporaryFolder folder;
  Case document;
  document.setName("x");
  const nlohmann::json view{{"camera", {1.5, 2, 3}}, {"parts", nlohmann::json::object()}};
  saveCase(document, folder.path(), Overwrite::Refuse, view);
  EXPECT_EQ(readCaseDescription(folder.path()).view, "view.json");
  EXPECT_EQ(readJsonFile(folder / "view.json"), view);
  saveCase(document, folder.path(), Overwrite::Replace);
  EXPECT_EQ(readCaseDescription(folder.path()).view, "view.json");
  EXPECT_EQ(readJsonFile(folder / "view.json"), view);
}

TEST(CaseAdoption, TakesEveryPartAndTellsOfEach) {
  Case from, to;
  fill(from);
  from.setScan(from.scan());  // registration and update are stale now
  std::set<Case::Part> heard;
  bool whole = true;
  const Connection watching = to.changed.connect([&](Case::Part part) {
    heard.insert(part);
    whole = whole && to.update() == from.update() && to.name() == from.name();
  });
  to.adopt(from);
  EXPECT_EQ(heard.size(), 14u);
  EXPECT_TRUE(whole) << "all is there when the first part is told of";
  EXPECT_EQ(to.preop(), from.preop());
  EXPECT_EQ(to.registration(), from.registration());
  EXPECT_TRUE(to.registrationStale() && to.updateStale() && to.modified());
  to.clear();
  EXPECT_FALSE(to.preop() || to.scan() || to.registration() || to.update() || to.modified());
  EXPECT_EQ(to.name(), "Untitled");
}

}  // namespace
}  // namespace falciform
