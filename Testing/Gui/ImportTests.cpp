#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <QWheelEvent>
#include <QtTest/QTest>
#include <cstdio>
#include <random>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Geometry/Topology.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/Gui/ImportFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// The built-in liver's labels and a CT of them in a portal-venous phase, with noise; made once.
struct Scanned {
  LabelMap labels;
  Image ct;
};
const Scanned& scanned() {
  static const Scanned made = [] {
    Scanned all;
    all.labels = makeSyntheticLabelMap({});
    all.ct.size = all.labels.size;
    all.ct.worldFromIndex = all.labels.worldFromIndex;
    std::mt19937_64 generator(11);
    std::normal_distribution<float> noise(0, 15);
    for (const std::uint16_t label : all.labels.voxels)
      all.ct.voxels.push_back((label == synthetic::kLiver    ? 110.F
                               : label == synthetic::kTumour ? 60.F
                               : label > 0                   ? 190.F
                                                             : -90.F) +
                              noise(generator));
    return all;
  }();
  return made;
}

/// Both lobes and the tip of the left one.
const std::vector<Vector3d> kPlaces{{-103, -23, -29}, {11, -45, 10}, {39, -17, 33}};

struct ImportTest : ImportFixture {
  void openCt() {
    const TemporaryFolder folder;
    writeImage(folder / "ct.nii.gz", scanned().ct, Overwrite::Refuse);
    chooseInNextDialog(QString::fromStdString((folder / "ct.nii.gz").string()));
    click("openCt");
    waitUntil([&] { return bench->document.ct() != nullptr; }, "the CT");
    waitIdle();
    handleEvents(100);
  }
};

TEST_F(ImportTest, ThreeClicksBecomeALiverASurfaceAndAReport) {
  openCt();
  seed(kPlaces);
  EXPECT_NEAR(control<QTableWidget>("seedTable").item(0, 3)->text().toDouble(), 110, 75)
      << "HU, within five standard deviations of the noise";
  keepPicture("import_seeds");
  isSmooth("segmenting", [&] {
    click("segment");
    waitUntil([&] { return !fronts.empty(); }, "the front to be seen");
    waitIdle();
  });
  ASSERT_TRUE(bench->document.labels()) << errors.join(" ").toStdString();
  const double overlap = dice(*bench->document.labels(), scanned().labels);
  std::printf("Dice %.3f, %zu fronts seen\n", overlap, fronts.size());
  EXPECT_GT(overlap, 0.95) << "even tissue with noise: the voxels at the border remain";
  EXPECT_EQ(bench->view.options().liveLabels, nullptr) << "the front gives way to the labels";

  EXPECT_EQ(control<QTableWidget>("seedTable").rowCount(), 3) << "no autosave may take them";
  keepPicture("import_segmented");
  isSmooth("the surface", [&] {
    click("previewSurface");
    waitIdle();
  });
  EXPECT_FALSE(bench->document.preop()) << "a preview is not in the case";
  ASSERT_TRUE(bench->view.options().previewSurface);
  EXPECT_EQ(quality("Closed"), "yes");
  EXPECT_EQ(quality("Genus"), "0");
  EXPECT_NEAR(quality("Volume, ml").toDouble(), volumeMl(), 0.02 * volumeMl());
  EXPECT_LT(quality("To the mask: 95 %").toDouble(), 1.5) << "mm: a voxel";
  EXPECT_GT(quality("To the mask: mean").toDouble(), 0);
  keepPicture("import_preview");
  const auto previewed = bench->view.options().previewSurface;
  click("import");
  waitIdle();
  ASSERT_TRUE(bench->document.preop());
  EXPECT_TRUE(bench->document.preop()->points == previewed->points) << "what was looked at is taken in";
  EXPECT_EQ(bench->view.options().previewSurface, nullptr);
  keepPicture("import_done");
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(ImportTest, StopKeepsTheFrontAndContinueFinishes) {
  openCt();
  seed(kPlaces);
  click("segment");
  waitUntil([&] { return !fronts.empty(); }, "the front to be seen");
  click("stopSegmentation");
  waitIdle();
  ASSERT_TRUE(bench->document.labels());
  EXPECT_TRUE(control<QLabel>("segmentWarnings").text().contains("stopped before the end"));
  const double stopped = dice(*bench->document.labels(), scanned().labels);
  click("continueSegmentation");
  waitIdle();
  const double whole = dice(*bench->document.labels(), scanned().labels);
  std::printf("Dice %.3f when stopped, %.3f continued\n", stopped, whole);
  EXPECT_GT(stopped, 0.5);
  EXPECT_GT(whole, 0.95);
  click("undoSegmentation");
  EXPECT_NEAR(dice(*bench->document.labels(), scanned().labels), stopped, 1e-9);
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(ImportTest, TheBrushMendsInSlicesAndWhatIsErasedStaysOut) {
  openCt();
  seed(kPlaces);
  click("segment");
  waitIdle();
  const double before = volumeMl();
  const Vector3d bite(-103, -23, -29);
  ASSERT_TRUE(isLabelled(bite));
  goTo(bite);
  click("eraseLabel");
  SliceView& axial = slice("sliceAxial");
  const QPoint from = axial.positionOf(bite).toPoint();
  std::vector<QPoint> way;
  for (int i = 0; i <= 10; ++i) way.push_back(from + QPoint(2 * i, 0));
  isSmooth("a stroke", [&] { dragIn(axial, Qt::LeftButton, way); });
  EXPECT_FALSE(isLabelled(bite));
  const double erased = volumeMl();
  EXPECT_LT(erased, before - 2) << "ml: a ball of 8 mm";
  keepPicture("import_erased");
  // The wheel with Shift makes the brush larger.
  QWheelEvent wheel(from, axial.mapToGlobal(from), {}, QPoint(0, 120), Qt::NoButton, Qt::ShiftModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&axial, &wheel);
  EXPECT_NEAR(bench->view.options().sliceBrushMm, 1.2 * 8, 1e-9);

  click("undoSegmentation");
  EXPECT_NEAR(volumeMl(), before, 1e-9);
  click("redoSegmentation");
  EXPECT_NEAR(volumeMl(), erased, 1e-9);
  click("continueSegmentation");
  waitIdle();
  EXPECT_FALSE(isLabelled(bite)) << "the front was kept out";
  // Esc lays the tool down, painting puts the piece back.
  click("paintLabel");
  goTo(bite);
  dragIn(axial, Qt::LeftButton, way);
  EXPECT_TRUE(isLabelled(bite));
  axial.setFocus();
  QTest::keyClick(&axial, Qt::Key_Escape);
  EXPECT_EQ(bench->view.options().sliceTool, SliceTool::Look);
  const double painted = volumeMl();
  dragIn(axial, Qt::LeftButton, way);
  EXPECT_EQ(volumeMl(), painted);
}

TEST_F(ImportTest, ARightDragChangesTheGreyWindowAndTheReadoutTellsWhatIsThere) {
  openCt();
  SliceView& axial = slice("sliceAxial");
  goTo(kPlaces[0]);
  const auto brightness = [&] {
    const QImage image = axial.grab().toImage();
    double sum = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    return sum / image.width() / image.height();
  };
  const double before = brightness();
  const QPoint at = axial.rect().center();
  isSmooth("window and level", [&] {
    dragIn(axial, Qt::RightButton, {at, at + QPoint(0, 30)});
    dragIn(axial, Qt::RightButton, {at, at - QPoint(0, 30)});
  });
  dragIn(axial, Qt::RightButton, {at, at + QPoint(0, 60)});
  EXPECT_GT(brightness(), before + 10) << "of 255: a lower level is brighter";
  EXPECT_NEAR(bench->view.options().greyWindow.level, 80 - 60 / 200.0 * 400, 1);
  auto& preset = control<QComboBox>("windowPreset");
  EXPECT_EQ(preset.currentText(), "By hand");
  preset.setCurrentIndex(0);
  Q_EMIT preset.activated(0);
  handleEvents();
  EXPECT_NEAR(brightness(), before, 1);
  QTest::mouseMove(&axial, axial.positionOf(kPlaces[0]).toPoint());
  waitUntil([&] { return control<QLabel>("sliceReadout").text().startsWith("(-10"); }, "the readout", 5);
  const QString text = control<QLabel>("sliceReadout").text();
  EXPECT_TRUE(text.contains("mm LPS")) << text.toStdString();
  // "(x, y, z) mm LPS · 108 HU"
  const double hu = text.section(QString::fromUtf8(" · "), 1, 1).section(' ', 0, 0).toDouble();
  EXPECT_NEAR(hu, 110, 75) << text.toStdString();
}

TEST_F(ImportTest, LabelsGetNamesVolumesAndComeInAsVesselsAndTumours) {
  bench->document.setLabels(std::make_shared<const LabelMap>(scanned().labels));
  auto& table = control<QTableWidget>("labelTable");
  waitUntil([&] { return table.rowCount() == 4; }, "the labels to be counted");
  const auto role = [&](int label, int index) {
    control<QComboBox>(qPrintable(QString("labelRole%1").arg(label))).setCurrentIndex(index);
  };
  role(synthetic::kTumour, 2);
  role(synthetic::kPortalVein, 1);
  table.item(2, 1)->setText("portal vein");
  keepPicture("import_labels");
  type("edgeLengthMm", "4");
  click("import");
  waitUntil([&] { return bench->document.structures().size() == 2; }, "the structures");
  waitIdle();
  EXPECT_TRUE(bench->document.structures().count("tumour 2"));
  ASSERT_TRUE(bench->document.structures().count("portal vein"));
  EXPECT_TRUE(inspectTopology(*bench->document.structures().at("portal vein")).closedManifold());
  keepPicture("import_structures");
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(ImportTest, LeavingTheStepPutsTheSlicesAway) {
  openCt();
  seed({kPlaces[0]});
  EXPECT_TRUE(bench->view.options().slicesLarge);
  window->showModule("Registration");
  handleEvents(100);
  EXPECT_FALSE(bench->view.options().slicesShown);
  EXPECT_EQ(bench->view.options().sliceTool, SliceTool::Look);
  EXPECT_EQ(bench->view.options().seeds, nullptr);
  window->showModule("SegmentationImport");
  handleEvents(100);
  EXPECT_TRUE(bench->view.options().seeds) << "they are still there";
}

}  // namespace
}  // namespace falciform::test
