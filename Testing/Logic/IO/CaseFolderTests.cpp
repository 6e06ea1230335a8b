#include <gmock/gmock.h>

#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/JsonFile.h"
#include "Logic/IO/MarkupFiles.h"
#include "Logic/IO/ResultFiles.h"
#include "Logic/IO/SupportFiles.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/TransformFiles.h"
#include "Testing/Logic/IO/ResultSamples.h"
#include "Testing/Logic/IO/SurfaceSamples.h"
#include "Testing/Support/SmallSurfaces.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

void fillCase(Case& document) {
  LabelMap labels;
  labels.size = {4, 3, 2};
  labels.worldFromIndex.diagonal() << 0.5, 0.75, 2, 1;
  labels.worldFromIndex.topRightCorner<3, 1>() << -10, 20, 30;
  labels.voxels.assign(24, 0);
  labels.at(1, 2, 1) = 5;
  Surface scan = fullSurface();
  scan.triangles.resize(0, 3);
  scan.frame = "scanner";
  document.setName("Liver one");
  document.setLabels(std::make_shared<const LabelMap>(labels));
  document.setPreop(std::make_shared<const Surface>(fullSurface()));
  document.setScan(std::make_shared<const Surface>(scan));
  document.setStructure("portal vein / left", std::make_shared<const Surface>(sphere(5, 1)));
  document.setStructure("portal vein . left", std::make_shared<const Surface>(sphere(6, 1)));
  document.setPreopLandmarks({{{"a", {1, 2, 3}}}, "LPS"});
  document.setScanLandmarks({{{"a", {4, 5, 6}}}, "scanner"});
  document.setRegistration(std::make_shared<const RegistrationResult>(sampleRegistration()));
  document.setDistance(std::make_shared<const DistanceMap>(sampleDistance()));
  Image ct;
  ct.size = {3, 2, 2};
  ct.worldFromIndex.diagonal() << 0.5, 0.5, 2, 1;
  ct.voxels = {-1000, -50, 0, 40.5F, 60, 120, 300, 1500, -3, 7, 8, 9};
  document.setCt(std::make_shared<const Image>(ct));
  document.setTargets({{{"tumour 1", {7, 8, 9}}}, "LPS"});
  document.setTruthTargets({{{"tumour 1", {-7, -8, -9}}}, "scanner"});
}

TEST(CaseFolder, AWholeCaseComesBack) {
  const TemporaryFolder folder;
  Case saved, opened;
  fillCase(saved);
  saveCase(saved, folder / "case", Overwrite::Refuse);
  EXPECT_THAT(openCase(opened, folder / "case"), IsEmpty());
  EXPECT_EQ(opened.name(), "Liver one");
  EXPECT_EQ(opened.labels()->voxels, saved.labels()->voxels);
  EXPECT_LT((opened.labels()->worldFromIndex - saved.labels()->worldFromIndex).cwiseAbs().maxCoeff(),
            1e-6);  // floats in NIfTI
  EXPECT_EQ(opened.preop()->points, saved.preop()->points);
  EXPECT_EQ(opened.preop()->patch, saved.preop()->patch);
  EXPECT_EQ(opened.preop()->patchNames, saved.preop()->patchNames);
  EXPECT_EQ(opened.scan()->frame, "scanner");
  ASSERT_EQ(opened.structures().size(), 2u);  // names that make the same file name stay two
  EXPECT_EQ(opened.structures().at("portal vein / left")->points,
            saved.structures().at("portal vein / left")->points);
  EXPECT_EQ(opened.structures().at("portal vein . left")->points,
            saved.structures().at("portal vein . left")->points);
  EXPECT_EQ(opened.preopLandmarks().points.at(0).position, Vector3d(1, 2, 3));
  EXPECT_EQ(opened.scanLandmarks().frame, "scanner");
  ASSERT_TRUE(opened.ct());
  EXPECT_EQ(opened.ct()->voxels, saved.ct()->voxels);
  EXPECT_EQ(opened.targets().points.at(0).position, Vector3d(7, 8, 9));
  EXPECT_EQ(opened.truthTargets().points.at(0).position, Vector3d(-7, -8, -9));
  EXPECT_EQ(opened.truthTargets().frame, "scanner");
  EXPECT_EQ(toJson(*opened.registration()), toJson(*saved.registration()));
  EXPECT_FALSE(opened.registrationStale());
  EXPECT_EQ(toJson(*opened.distance()), toJson(*saved.distance()));
  EXPECT_TRUE(std::isnan(opened.distance()->preop.arrays.at(kSignedDistance)[0]));
  EXPECT_FALSE(opened.modified());
}

TEST(CaseFolder, PaintedSupportsComeBack) {
  const TemporaryFolder folder;
  Case saved, opened;
  fillCase(saved);
  SupportPainting painting = emptySupportPainting(saved.preop()->size());
  painting.labels.front() = support_label::kVenaCava;
  painting.labels.back() = 7;
  painting.regions[7] = {"Rückenlage, \"links\"", SupportRegionKind::Pushed, -3.25};
  painting.turnDeg = 12.5;
  saved.setSupports(std::make_shared<const SupportPainting>(painting));
  saveCase(saved, folder.path(), Overwrite::Refuse);
  EXPECT_THAT(openCase(opened, folder.path()), IsEmpty());
  ASSERT_NE(opened.supports(), nullptr);
  EXPECT_EQ(*opened.supports(), painting);
}

TEST(CaseFolder, RefusesSupportsThatDoNotFitTheSurface) {
  const TemporaryFolder folder;
  Case saved, opened;
  fillCase(saved);
  const Index points = saved.preop()->size();
  saved.setSupports(std::make_shared<const SupportPainting>(emptySupportPainting(points)));
  saveCase(saved, folder.path(), Overwrite::Refuse);
  const auto refusal = [&](const char* key, const nlohmann::json& value) {
    nlohmann::json json = toJson(*saved.supports());
    json[key] = value;
    put(folder / "supports.json", json.dump());
    return refusalOf([&] { (void)openCase(opened, folder.path()); });
  };
  EXPECT_THAT(refusal("label_runs", {0, points + 1}), HasSubstr("label_runs"));
  EXPECT_THAT(refusal("label_runs", {0, points - 1}), HasSubstr("labels"));
  EXPECT_THAT(refusal("label_runs", {9, points}), HasSubstr("label 9"));
  EXPECT_THAT(refusal("label_runs", {0, -1, 0, 1e15}), HasSubstr("label_runs"));
  EXPECT_THAT(refusal("label_runs", "none"), HasSubstr("label_runs"));
  EXPECT_THAT(refusal("turn_deg", 1000), HasSubstr("turn"));
  EXPECT_THAT(refusal("regions", {1, 2}), HasSubstr("regions"));
  EXPECT_THAT(refusal("schema", 2), HasSubstr("later version"));
  EXPECT_EQ(opened.preop(), nullptr) << "nothing of it was opened";
}

TEST(CaseFolder, AStaleRegistrationStaysStale) {
  const TemporaryFolder folder;
  Case saved, opened;
  fillCase(saved);
  saved.setScan(saved.scan());
  ASSERT_TRUE(saved.registrationStale());
  saveCase(saved, folder.path(), Overwrite::Refuse);
  (void)openCase(opened, folder.path());
  EXPECT_TRUE(opened.registrationStale());
  EXPECT_EQ(opened.distance(), nullptr);
}

TEST(CaseFolder, CanBeMovedSinceItsPathsAreRelative) {
  const TemporaryFolder folder;
  Case saved, opened;
  fillCase(saved);
  saveCase(saved, folder / "here", Overwrite::Refuse);
  EXPECT_THAT(readTextFile(folder / "here" / "case.json"), testing::Not(HasSubstr(folder.path().string())));
  fs::rename(folder / "here", folder / "there");
  EXPECT_THAT(openCase(opened, folder / "there" / "case.json"), IsEmpty());
  EXPECT_NE(opened.preop(), nullptr);
}

TEST(CaseFolder, IsNotReplacedUnasked) {
  const TemporaryFolder folder;
  Case document;
  document.setName("first");
  saveCase(document, folder.path(), Overwrite::Refuse);
  document.setName("second");
  EXPECT_THAT(refusalOf([&] { saveCase(document, folder.path(), Overwrite::Refuse); }), HasSubstr("--force"));
  EXPECT_EQ(readCaseDescription(folder.path()).name, "first");
  saveCase(document, folder.path(), Overwrite::Replace);
  EXPECT_EQ(readCaseDescription(folder.path()).name, "second");
}

TEST(CaseFolder, SavingKeepsWhatTheUserWroteAndTheDocumentDoesNotHold) {
  const TemporaryFolder folder;
  put(folder / "case.json",
      R"({"name": "x", "settings": {"registration": {"method": "icp"}}, "targets": "t.mrk.json"})");
  saveCase(Case(), folder.path(), Overwrite::Replace);
  const CaseDescription kept = readCaseDescription(folder.path());
  EXPECT_EQ(kept.settings["registration"]["method"], "icp");
  EXPECT_EQ(kept.targets, "t.mrk.json");
}

TEST(CaseFolder, ADamagedFileLeavesTheOpenCaseAsItWas) {
  const TemporaryFolder folder;
  Case saved, opened;
  fillCase(saved);
  saveCase(saved, folder.path(), Overwrite::Refuse);
  const std::string scan = readTextFile(folder / "scan.vtp");
  put(folder / "scan.vtp", scan.substr(0, scan.size() / 2));
  opened.setName("before");
  EXPECT_THAT(refusalOf([&] { (void)openCase(opened, folder.path()); }), HasSubstr("scan.vtp"));
  EXPECT_EQ(opened.name(), "before");
  EXPECT_EQ(opened.preop(), nullptr);
}

TEST(CaseFolder, AHandWrittenCaseWithATransformOpens) {
  const TemporaryFolder folder;
  writeSurface(folder / "liver.ply", sphere(50, 2), Overwrite::Refuse);
  writeTransform(folder / "pose.tfm", randomMotion(9), "maps pre-op to scan", Overwrite::Refuse);
  put(folder / "case.json", R"({"name": "by hand", "preop": ")" + (folder / "liver.ply").string() +
                                R"(", "registration": "pose.tfm"})");
  Case opened;
  EXPECT_THAT(openCase(opened, folder.path()), IsEmpty());  // absolute paths are allowed
  EXPECT_EQ(opened.preop()->size(), 162);
  EXPECT_LT((opened.registration()->scanFromPreop.matrix() - randomMotion(9).matrix()).norm(), 1e-12);
}

TEST(CaseDescriptions, ComeBackAndMakeAbsolutePathsRelative) {
  const TemporaryFolder folder;
  CaseDescription written;
  written.folder = folder.path();
  written.name = "x";
  written.labelMap = "ct/labels.nrrd";
  written.labels = {1, 5};
  written.preopPatches = "painted.vtp";
  written.scan = (folder / "scan.ply").string();
  written.structures = {{"tumour", "t.vtp"}};
  written.settings = {{"import", {{"closeMm", 2}}}};
  written.truthTargets = "u.json";
  writeCaseDescription(written, Overwrite::Refuse);
  const CaseDescription read = readCaseDescription(folder.path());
  EXPECT_EQ(read.scan, "scan.ply");
  EXPECT_EQ(read.labels, written.labels);
  EXPECT_EQ(read.structures, written.structures);
  EXPECT_EQ(read.preopPatches, "painted.vtp");
  EXPECT_EQ(read.truthTargets, "u.json");
  EXPECT_EQ(read.settings, written.settings);
  EXPECT_EQ(read.folder, folder.path());
}

TEST(CaseDescriptions, NameTheKeyThatIsWrong) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    put(folder / "case.json", text);
    return refusalOf([&] { (void)readCaseDescription(folder.path()); });
  };
  EXPECT_THAT(refusal(R"({"name": "x", "labelmap": "l.nii"})"),
              testing::AllOf(HasSubstr("'labelmap'"), HasSubstr("labelMap")));
  EXPECT_THAT(refusal(R"({"name": "x", "scan": 3})"), HasSubstr("'scan'"));
  EXPECT_THAT(refusal(R"({"name": "x", "labels": [1, "2"]})"), HasSubstr("'labels'"));
  EXPECT_THAT(refusal(R"({"name": "x", "labels": [70000]})"), HasSubstr("'labels'"));
  EXPECT_THAT(refusal(R"({"name": "x", "structures": {"tumour": null}})"), HasSubstr("structures.tumour"));
  EXPECT_THAT(refusal(R"({"name": "x", "settings": []})"), HasSubstr("'settings'"));
  EXPECT_THAT(refusal(R"({"scan": "s.ply"})"), HasSubstr("'name'"));
  EXPECT_THAT(refusal("[]"), HasSubstr("object"));
  EXPECT_THAT(refusal("{\"name\": "), HasSubstr("no sound JSON"));
  EXPECT_THAT(refusalOf([&] { (void)readCaseDescription(folder / "no"); }), HasSubstr("no such file"));
}

}  // namespace
}  // namespace falciform
