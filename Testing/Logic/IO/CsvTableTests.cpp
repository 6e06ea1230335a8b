#include "Logic/IO/CsvTable.h"

#include <gmock/gmock.h>

#include "Logic/Core/Errors.h"
#include "Logic/IO/OutputFile.h"
#include "Testing/Support/TemporaryFolder.h"

namespace falciform {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CsvTable tableOf(const std::string& text) {
  const test::TemporaryFolder folder;
  writeTextFile(folder / "t.csv", Overwrite::Refuse, text);
  return readCsvTable(folder / "t.csv");
}

TEST(CsvTable, ReadsCellsLinesAndNumbers) {
  const CsvTable table = tableOf("\xEF\xBB\xBF# a remark\r\ncase, group\r\n\r\n7 , A\r\n8,\r\n");
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_THAT(table.rows[0].cells, ElementsAre("case", "group"));
  EXPECT_THAT(table.rows[1].cells, ElementsAre("7", "A"));
  EXPECT_THAT(table.rows[2].cells, ElementsAre("8", ""));
  EXPECT_EQ(table.rows[1].line, 4u);
  EXPECT_EQ(table.number("-0.5"), -0.5);
  for (const char* none : {"", "x", "1,5", "nan", "inf", "1 2"})
    EXPECT_FALSE(table.number(none).has_value()) << none;
}

TEST(CsvTable, KnowsSemicolonsWithDecimalCommasAndTabs) {
  const CsvTable table = tableOf("a;b\n1,5;-2\n");
  EXPECT_THAT(table.rows[1].cells, ElementsAre("1,5", "-2"));
  EXPECT_EQ(table.number("1,5"), 1.5);
  EXPECT_THAT(tableOf("a\tb,c\n1\t2\n").rows[0].cells, ElementsAre("a", "b,c"));
  EXPECT_THAT(tableOf("\"a;x\",b\n1,2\n").rows[0].cells, ElementsAre("a;x", "b"));
}

TEST(CsvTable, WhatIsWrittenAsACellIsReadAsIt) {
  for (const std::string text : {"plain", "a,b", "say \"so\"", "#7", "semi;colon", "\"", "", "tab\there"})
    EXPECT_EQ(tableOf("x,y\n" + csvCell(text) + ",1\n").rows[1].cells[0], text);
}

TEST(CsvTable, RefusesWhatIsNoTable) {
  const auto refused = [](const std::string& text, const std::string& mention) {
    try {
      (void)tableOf(text);
      FAIL() << "accepted: " << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(mention));
    }
  };
  refused("", "no table");
  refused("# only remarks\n\n", "no table");
  refused("a,b\n1,2,3\n", "line 2: has 3 cells where the head has 2");
  refused("a,b\n\"1,2\n", "line 2: a quote is not closed");
  EXPECT_THROW((void)readCsvTable("nowhere.csv"), InputError);
}

}  // namespace
}  // namespace falciform
