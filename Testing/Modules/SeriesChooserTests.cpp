#include <gmock/gmock.h>

#include <QApplication>
#include <QTableWidget>
#include <fstream>

#include "Modules/SegmentationImport/SegmentationImportPanel.h"
#include "Modules/SegmentationImport/SeriesChooser.h"
#include "Testing/Logic/IO/DicomBytes.h"
#include "Testing/Modules/PanelFixture.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform::test {
namespace {

struct SeriesChooserTest : PanelTest {
  SeriesChooserTest() {
    SlicePlan ct, liver, tumour;
    ct.description = "portal";
    liver.intercept = tumour.intercept = "0";
    liver.values = {9, 9, 9, 9, 9, 9, 0, 0, 0, 0, 0, 0};
    tumour.values = {0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
    liver.series = "2.2";
    liver.instance = "2.2.2";
    tumour.series = "3.3";
    tumour.instance = "3.3.3";
    writeSeries(folder / "a", ct, {0, 2, 4});
    writeSeries(folder / "liver", liver, {0, 2, 4});
    writeSeries(folder / "tumour", tumour, {0, 2, 4});
    writeSeries(folder / "one", {.series = "9", .instance = "9.9", .description = "scout"}, {0});
  }

  SeriesChooser& opened() {
    openDicom(bench, folder.path(), &window);
    return child<SeriesChooser>(window, "seriesChooser");
  }
  void select(QTableWidget& table, std::initializer_list<const char*> descriptions) {
    table.clearSelection();
    table.setSelectionMode(QAbstractItemView::MultiSelection);
    for (const char* wanted : descriptions)
      for (int r = 0; r < table.rowCount(); ++r)
        if (table.item(r, 2)->text() == wanted) table.selectRow(r);
  }

  TemporaryFolder folder;
  QWidget window;
};

TEST_F(SeriesChooserTest, ListsEverySeriesWithAPictureAndTheReasonWhereItCannotBeRead) {
  SeriesChooser& chooser = opened();
  auto& table = child<QTableWidget>(chooser, "seriesTable");
  ASSERT_EQ(table.rowCount(), 4);
  for (int r = 0; r < 4; ++r)
    EXPECT_FALSE(table.item(r, 0)->data(Qt::DecorationRole).isNull()) << "row " << r;
  EXPECT_EQ(table.item(0, 1)->text(), "CT");
  EXPECT_EQ(table.item(1, 1)->text(), "CT, mask");
  EXPECT_EQ(table.item(0, 3)->text(), QString::fromUtf8("4 × 3 × 3"));
  EXPECT_FALSE(table.item(2, 2)->flags() & Qt::ItemIsSelectable) << "a single slice";
  EXPECT_NE(words(chooser, "seriesNotes").find("single slice"), std::string::npos);
  EXPECT_FALSE(isEnabled(chooser, "openAsCt")) << "nothing is chosen yet";
  EXPECT_TRUE(errors.isEmpty());
}

TEST_F(SeriesChooserTest, TheChosenSeriesBecomesTheCt) {
  SeriesChooser& chooser = opened();
  select(child<QTableWidget>(chooser, "seriesTable"), {"portal"});
  click(chooser, "openAsCt");
  ASSERT_TRUE(bench.document.ct()) << errors.join(" ").toStdString();
  EXPECT_EQ(bench.document.ct()->at(1, 0, 0), 1 - 1024);
  EXPECT_FALSE(bench.document.labels());
}

TEST_F(SeriesChooserTest, SeveralMasksBecomeOneLabelMap) {
  SeriesChooser& chooser = opened();
  select(child<QTableWidget>(chooser, "seriesTable"), {"liver", "tumour"});
  EXPECT_FALSE(isEnabled(chooser, "openAsCt"));
  click(chooser, "openAsLabels");
  ASSERT_TRUE(bench.document.labels()) << errors.join(" ").toStdString();
  EXPECT_EQ(bench.document.labels()->at(0, 0, 0), 1);
  EXPECT_EQ(bench.document.labels()->at(2, 0, 0), 2);
  EXPECT_NE(logged.join(" ").indexOf("Label 2 is 'tumour'"), -1);
}

TEST_F(SeriesChooserTest, ACtIsNoLabelMapAndTheReasonIsSaid) {
  SeriesChooser& chooser = opened();
  select(child<QTableWidget>(chooser, "seriesTable"), {"portal"});
  click(chooser, "openAsLabels");
  EXPECT_FALSE(bench.document.labels());
  EXPECT_NE(errors.join(" ").indexOf("intensities"), -1);
}

TEST_F(SeriesChooserTest, NothingOnScreenOrInTheLogNamesThePatient) {
  SeriesChooser& chooser = opened();
  auto& table = child<QTableWidget>(chooser, "seriesTable");
  select(table, {"portal"});
  click(chooser, "openAsCt");
  std::string seen = logged.join(" ").toStdString() + words(chooser, "seriesNotes");
  for (int r = 0; r < table.rowCount(); ++r)
    for (int c = 0; c < table.columnCount(); ++c) seen += table.item(r, c)->text().toStdString();
  EXPECT_FALSE(tellsIdentity(seen)) << seen;
}

TEST_F(SeriesChooserTest, ASingleSeriesIsOpenedAsWhatItIsWithoutAQuestion) {
  openDicom(bench, folder / "liver", &window);
  QApplication::processEvents();
  EXPECT_EQ(window.findChild<SeriesChooser*>("seriesChooser"), nullptr);
  EXPECT_TRUE(bench.document.labels());
  openDicom(bench, folder / "a/slice_1", &window);
  QApplication::processEvents();
  EXPECT_TRUE(bench.document.ct()) << "a file stands for its series";
  EXPECT_TRUE(errors.isEmpty()) << errors.join(" ").toStdString();
}

TEST_F(SeriesChooserTest, AFolderWithoutDicomIsRefusedInTheLog) {
  const TemporaryFolder empty;
  openDicom(bench, empty.path(), &window);
  EXPECT_EQ(window.findChild<SeriesChooser*>("seriesChooser"), nullptr);
  EXPECT_NE(errors.join(" ").indexOf("no DICOM series"), -1);
}

}  // namespace
}  // namespace falciform::test
