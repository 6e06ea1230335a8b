#include <QtTest/QTest>
#include <cstdio>

#include "Logic/IO/VolumeFiles.h"
#include "Testing/Gui/ImportFixture.h"
#include "Testing/Support/RealData.h"

namespace falciform::test {
namespace {

TEST_F(ImportFixture, ARealCtFromItsDicomFolderBecomesALiverByThreeClicks) {
  FALCIFORM_NEEDS_DATA("ircad17/ct");
  FALCIFORM_NEEDS_DATA("ircad17/masks/liver");
  window->open({QString::fromStdString((realData() / "ircad17/ct").string())});
  waitUntil([&] { return bench->document.ct() != nullptr; }, "the CT", 120);
  waitIdle();
  handleEvents(200);
  // Right lobe, left lobe, the larger tumour (Docs/Segmentation.md).
  seed({{97, 154, 77}, {190, 74, 115}, {204, 126, 144}});
  isSmooth("segmenting a real CT", [&] {
    click("segment");
    waitIdle();
  });
  ASSERT_TRUE(bench->document.labels()) << errors.join(" ").toStdString();
  const LabelMap mask = readLabelMap(realData() / "ircad17/masks/liver").value;
  const double overlap = dice(*bench->document.labels(), mask);
  std::printf("Dice %.3f, %zu fronts seen\n", overlap, fronts.size());
  EXPECT_GT(overlap, 0.9);
  EXPECT_GT(fronts.size(), 3u) << "the front is seen to move";
  const double before = volumeMl();
  click("eraseLabel");
  SliceView& axial = slice("sliceAxial");
  const QPoint at = axial.rect().center();
  isSmooth("a stroke, 31 million voxels", [&] {
    dragIn(axial, Qt::LeftButton, {at, at + QPoint(10, 0), at + QPoint(20, 5)});
    EXPECT_LE(volumeMl(), before);
    click("undoSegmentation");
    EXPECT_NEAR(volumeMl(), before, 1e-6);
  });
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

}  // namespace
}  // namespace falciform::test
