#include <gmock/gmock.h>

#include <QCheckBox>
#include <QTableWidget>

#include "Logic/Core/Errors.h"
#include "Logic/IO/CaseFolder.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Modules/DeformationAnalysis/CaseMaps.h"
#include "Modules/DeformationAnalysis/ComparedCases.h"
#include "Modules/DeformationAnalysis/DeformationAnalysisPanel.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/MappedSpheres.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// Cases whose scans lie 1, 2, 10 mm outside; the map of none is computed yet.
struct CaseMapsTest : PanelTest {
  void save(const std::string& name, double gapMm, const std::function<void(Case&)>& change = {}) {
    Case document;
    fillSpheres(document, gapMm, scanFromPreop);
    document.setName(name);
    if (change) change(document);
    saveCase(document, folder / name, Overwrite::Refuse);
  }
  [[nodiscard]] QString path(const char* name) const {
    return QString::fromStdString((folder / name).string());
  }

  TemporaryFolder folder;
};

TEST_F(CaseMapsTest, AFolderOfCasesIsReadInTheOrderOfItsNumbersAndMissingMapsAreComputed) {
  save("case 10", 3);
  save("case 2", 2);
  save("case 1", 1);
  const CaseMaps maps = loadCaseMaps(mapSourcesIn(folder.path()), {});
  ASSERT_EQ(maps.cases.size(), 3u);
  EXPECT_EQ(maps.cases[0].name, "case 1");
  EXPECT_EQ(maps.cases[1].name, "case 2");
  EXPECT_EQ(maps.cases[2].name, "case 10");
  for (int i = 0; i < 3; ++i)  // mm; two icospheres of flat triangles
    EXPECT_NEAR(maps.cases[static_cast<std::size_t>(i)].map->preopAll.mean, i + 1, 0.05);
  EXPECT_TRUE(Isometry3d(maps.cases[0].lpsFromMap).isApprox(scanFromPreop.inverse(), 1e-9));
}

TEST_F(CaseMapsTest, ASavedMapIsTakenAsItIs) {
  save("saved", 2, [](Case& document) {
    DistanceMap map =
        mapDistances(*document.preop(), *document.scan(), document.registration()->scanFromPreop);
    map.preop.arrays[kSignedDistance].setConstant(7);  // not what would be computed anew
    document.setDistance(std::make_shared<const DistanceMap>(std::move(map)));
  });
  const CaseMaps maps = loadCaseMaps(mapSourcesIn(folder / "saved"), {});
  ASSERT_EQ(maps.cases.size(), 1u);
  EXPECT_EQ(valuesOf(*maps.cases[0].map, kSignedDistance, false).minCoeff(), 7);
}

TEST_F(CaseMapsTest, OneUnreadableCaseOfManyIsLeftOutWithAWarning) {
  save("good", 2);
  save("unregistered", 2, [](Case& document) { document.setRegistration(nullptr); });
  const CaseMaps maps = loadCaseMaps(mapSourcesIn(folder.path()), {});
  ASSERT_EQ(maps.cases.size(), 1u);
  EXPECT_EQ(maps.cases[0].name, "good");
  EXPECT_THAT(maps.warnings, testing::Contains(testing::HasSubstr("unregistered is left out")));
  EXPECT_THROW(static_cast<void>(loadCaseMaps(mapSourcesIn(folder / "unregistered"), {})), InputError);
}

TEST_F(CaseMapsTest, SurfacesWithValuesAreMapsAndAFolderWithoutAnyIsRefused) {
  EXPECT_THROW(static_cast<void>(mapSourcesIn(folder.path())), InputError);
  EXPECT_THROW(static_cast<void>(mapSourcesIn(folder / "missing")), InputError);
  Surface map = sphere(50, 2);
  map.arrays[kSignedDistance] = VectorXd::Constant(map.size(), 1.5);
  writeSurface(folder / "target.vtp", map, Overwrite::Refuse);
  const CaseMaps maps = loadCaseMaps(mapSourcesIn(folder.path()), {});
  ASSERT_EQ(maps.cases.size(), 1u);
  EXPECT_EQ(maps.cases[0].name, "target");
  EXPECT_NEAR(maps.cases[0].map->preopAll.mean, 1.5, 1e-9);  // mm; a sum of 162 shares
  // What `falciform cohort` writes has its cases in a folder of their own, beside the target.
  std::filesystem::create_directory(folder / "cases");
  writeSurface(folder / "cases" / "patient 1.vtp", map, Overwrite::Refuse);
  EXPECT_EQ(mapSourcesIn(folder.path()),
            std::vector<std::filesystem::path>{folder / "cases" / "patient 1.vtp"});
}

TEST_F(CaseMapsTest, ComparedCasesShareOneRangeAndTheTableHasARowEach) {
  save("other", 6);
  DeformationAnalysisPanel panel(bench);
  panel.enter();
  fillSpheres(bench.document, 1, scanFromPreop);
  click(panel, "compute");
  const double alone = bench.view.options().distanceColours.high;
  EXPECT_FALSE(isEnabled(panel, "sideBySide")) << "nothing to compare yet";
  panel.compared().open(path("other"));
  const ViewOptions& options = bench.view.options();
  EXPECT_TRUE(options.galleryShown);
  ASSERT_EQ(options.mappedCases.size(), 2u) << errors.join(" ").toStdString();
  EXPECT_LT(alone, 2);
  EXPECT_GE(options.distanceColours.high, 6) << "holds the other's values too";
  auto& table = child<QTableWidget>(panel, "distanceStatistics");
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_NEAR(table.item(0, 3)->text().toDouble(), 1, 0.05);
  EXPECT_NEAR(table.item(1, 3)->text().toDouble(), 6, 0.1);

  bench.view.edit([](ViewOptions& change) { change.enlargedCase = 1; });
  EXPECT_EQ(table.item(0, 0)->text(), "all") << "the regions of the one shown large";
  EXPECT_NEAR(table.item(1, 3)->text().toDouble(), 6, 0.1) << "its patch";
  child<QCheckBox>(panel, "sideBySide").setChecked(false);
  EXPECT_FALSE(bench.view.options().galleryShown);
  EXPECT_EQ(bench.view.options().distanceColours.high, alone);
  child<QCheckBox>(panel, "sideBySide").setChecked(true);
  panel.leave();
  EXPECT_FALSE(bench.view.options().galleryShown) << "other steps show their own case";
  panel.enter();
  EXPECT_TRUE(bench.view.options().galleryShown);
  click(panel, "clearCompared");
  EXPECT_EQ(bench.view.options().mappedCases.size(), 1u);
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(CaseMapsTest, AFolderThatIsNoCaseIsSaidSo) {
  DeformationAnalysisPanel panel(bench);
  panel.compared().open(path("nowhere"));
  ASSERT_FALSE(errors.isEmpty());
  EXPECT_TRUE(errors.first().contains("nowhere"));
}

}  // namespace
}  // namespace falciform::test
