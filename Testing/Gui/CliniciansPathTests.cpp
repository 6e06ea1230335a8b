#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QtTest/QTest>
#include <algorithm>
#include <set>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/IO/SurfaceFiles.h"
#include "Logic/IO/VolumeFiles.h"
#include "Logic/Patches/PatchTransfer.h"
#include "Testing/Gui/WindowFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

/// A built-in liver as files: what a clinician would bring from the scanner and the operating room.
struct CliniciansPath : WindowTest {
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    SyntheticLiverSettings settings;
    settings.edgeLengthMm = 4;  // coarse: the whole path in seconds
    settings.voxelMm = 3;
    liver = makeSyntheticLiver(settings);
    writeLabelMap(labelMap(), makeSyntheticLabelMap(settings), Overwrite::Refuse);
    VirtualScannerSettings scanner;
    scanner.stride = 6;
    virtualScan = scanSurface(liver.surface, scanner);
    writeSurface(scan(), virtualScan.scan, Overwrite::Refuse);
  }
  std::filesystem::path labelMap() { return folder / "segmentation.nii.gz"; }
  std::filesystem::path scan() { return folder / "scan.vtp"; }

  /// Canvas positions along the true patch as seen now, from one end to the other.
  std::vector<QPoint> wayAlong(int label, int sortAxis, int stops) {
    std::vector<Vector3d> points;
    for (const int id : pointsOfPatch(liver.surface, label))
      points.emplace_back(liver.surface.points.row(id).transpose());
    std::sort(points.begin(), points.end(),
              [&](const Vector3d& a, const Vector3d& b) { return a[sortAxis] < b[sortAxis]; });
    std::vector<QPoint> way;
    for (int i = 0; i < stops; ++i) {
      // The mean of a slice, so that the way runs along the middle of the band.
      const std::size_t begin = points.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(stops);
      const std::size_t end =
          points.size() * static_cast<std::size_t>(i + 1) / static_cast<std::size_t>(stops);
      Vector3d mean = Vector3d::Zero();
      for (std::size_t k = begin; k < end; ++k) mean += points[k] / static_cast<double>(end - begin);
      way.push_back(window->view()->canvasPosition(mean));
    }
    return way;
  }

  TemporaryFolder folder;
  SyntheticLiver liver;
  VirtualScan virtualScan;
};

TEST_F(CliniciansPath, FromLabelMapToDistanceMapByMouseAndKeyboard) {
  // 1. Label map -> surface.
  chooseInNextDialog(QString::fromStdString(labelMap().string()));
  click("openLabelMap");
  waitIdle();
  ASSERT_TRUE(bench->document.labels()) << errors.join(" ").toStdString();
  type("edgeLengthMm", "4");
  click("import");
  waitIdle();
  ASSERT_TRUE(bench->document.preop()) << errors.join(" ").toStdString();
  handleEvents(200);

  // 2. Paint the falciform groove from the front and the ridge from below, by the mouse.
  click("nextModule");  // past the scan's preparation: there is none yet
  click("nextModule");
  click("paint");
  drag(wayAlong(patch::kFalciform, 2, 12));
  press(Qt::Key_2);
  QTest::keyClick(window->view()->canvas(), 'I', Qt::ShiftModifier);
  handleEvents(200);
  drag(wayAlong(patch::kInferiorRidge, 0, 24));
  press(Qt::Key_Escape);
  const Surface& painted = *bench->document.preop();
  const std::vector<int> truth = transferPatches(liver.surface, painted, 8);
  for (const int label : {patch::kFalciform, patch::kInferiorRidge}) {
    const std::vector<int> ids = pointsOfPatch(painted, label);
    ASSERT_GT(ids.size(), 40u) << patchName(painted, label);
    const auto good = std::count_if(ids.begin(), ids.end(),
                                    [&](int id) { return truth[static_cast<std::size_t>(id)] == label; });
    // Most of the stroke lies within 8 mm (brush radius and a little) of the true feature.
    EXPECT_GT(static_cast<double>(good), 0.6 * static_cast<double>(ids.size())) << patchName(painted, label);
  }

  // 3. The scan is dropped on the window, and registered.
  drop({QString::fromStdString(scan().string())});
  waitUntil([&] { return bench->document.scan() != nullptr; }, "the scan");
  waitIdle();
  click("nextModule");
  click("register");
  waitIdle();
  ASSERT_TRUE(bench->document.registration()) << errors.join(" ").toStdString();
  double worst = 0;
  for (const Landmark& target : liver.targets.points)
    worst = std::max(worst, (bench->document.registration()->scanFromPreop * target.position -
                             virtualScan.scanFromPreop * target.position)
                                .norm());
  EXPECT_LT(worst, 5) << "mm, the thesis's measure of success (Table III.2)";

  // 4. Distance map.
  click("nextModule");
  click("compute");
  waitIdle();
  ASSERT_TRUE(bench->document.distance()) << errors.join(" ").toStdString();
  // mm: rigid truth, 0.5 mm noise, two meshes of 4 mm edges of one body.
  EXPECT_LT(std::abs(bench->document.distance()->scanAll.median), 1);
  EXPECT_LT(bench->document.distance()->scanAll.p95Absolute, 4);

  // 5. Save, reopen in a new window: the same.
  const auto preop = bench->document.preop();
  const Isometry3d pose = bench->document.registration()->scanFromPreop;
  chooseInNextDialog(QString::fromStdString((folder / "saved").string()));
  trigger("saveCase");
  waitIdle();
  EXPECT_FALSE(window->isWindowModified()) << errors.join(" ").toStdString();

  // 6. A picture of the view.
  const std::filesystem::path picture = folder / "view.png";
  chooseInNextDialog(QString::fromStdString(picture.string()));
  trigger("exportPicture");
  waitIdle();
  const QImage image(QString::fromStdString(picture.string()));
  ASSERT_FALSE(image.isNull());
  EXPECT_GE(image.width(), 320);
  std::set<QRgb> colours;
  for (int y = 0; y < image.height(); y += 3)
    for (int x = 0; x < image.width(); x += 3) colours.insert(image.pixel(x, y));
  EXPECT_GT(colours.size(), 200u) << "a shaded, coloured map and its bar";
  keepPicture("clinicians_path");

  openWindow();
  window->open({QString::fromStdString((folder / "saved").string())});
  waitUntil([&] { return bench->document.preop() != nullptr; }, "the saved case");
  waitIdle();
  EXPECT_EQ(bench->document.preop()->points, preop->points);
  EXPECT_EQ(bench->document.preop()->patch, preop->patch);
  ASSERT_TRUE(bench->document.registration());
  EXPECT_TRUE(bench->document.registration()->scanFromPreop.isApprox(pose, 1e-9));
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

}  // namespace
}  // namespace falciform::test
