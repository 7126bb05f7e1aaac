// Tables of users as spreadsheets and people write them, and what is wrong with some.
#include "process/input/csv_file.h"

#include <gtest/gtest.h>

#include "process/input/scene_error.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

class CsvTable : public testing::Test {
 protected:
  CsvFile opened(const std::string& text) const {
    return {folder_.write("t.csv", text), {"table", "but a table is a CSV file", 1000}, "key: "};
  }
  /// Reads all numbers below the heading.
  std::vector<double> numbers(const std::string& text) const {
    CsvFile file = opened(text);
    std::vector<double> all;
    for (file.next(); file.next();)
      for (std::size_t k = 0; k < file.cells().size(); ++k) all.push_back(file.number(k));
    return all;
  }
  /// The message, after the folder's name.
  std::string complaint(const std::string& text) const {
    try {
      numbers(text);
    } catch (const SceneError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with("key: ")) << message;
      EXPECT_EQ(message.find("scene"), std::string::npos) << message;
      return message.substr(message.find("t.csv"));
    }
    return "no complaint";
  }

 private:
  support::TemporaryFolder folder_;
};

TEST_F(CsvTable, MayComeFromAnySpreadsheet) {
  const std::vector<double> all = {1, 2.5, -3, 4e-2};
  EXPECT_EQ(numbers("a,b\n1,2.5\n-3,4e-2\n"), all);
  EXPECT_EQ(numbers("\xEF\xBB\xBF# note\r\na , b\r\n\r\n 1, +2.5 \r\n\xE2\x88\x92"
                    "3,4e-2"),
            all);
  EXPECT_EQ(numbers("a;b\r1;2.5\r-3;4e-2\r"), all);
  EXPECT_EQ(numbers("\"a, all\",\"b\",,\n\"1\",\"2.5\",,\n,,,\n-3,4e-2,,\n"), all);
}

TEST_F(CsvTable, MayBeSeparatedByTabs) {
  const std::vector<double> all = {1, 2.5, -3, 4e-2};
  EXPECT_EQ(numbers("time s\tx mm\n1\t2.5\n-3\t4e-2\t\n"), all);
  EXPECT_EQ(numbers("a,\tb\n1,\t2.5\n-3,\t4e-2\n"), all) << "tabs as blanks";
  EXPECT_EQ(
      complaint("a\tb\n1\t2,5\n"),
      "t.csv:2:3: found \"2,5\", a number with a decimal comma; write a decimal point, such as \"2.5\"");
  EXPECT_EQ(complaint("a\tb\n2;3\n"),
            "t.csv:2: found 1 values, expected 2, one per column: the heading separates columns by tabs, "
            "this line has semicolons; use one of them throughout, and decimal points");
}

TEST_F(CsvTable, MayNameItsSeparatorAboveTheHeading) {
  const std::vector<double> all = {1, 2.5};
  EXPECT_EQ(numbers("sep=;\na;b\n1;2.5\n"), all);
  EXPECT_EQ(numbers("\xEF\xBB\xBFSep=,\r\na,b\r\n1,2.5\r\n"), all);
  EXPECT_EQ(numbers("sep=\t\na\tb\n1\t2.5\n"), all);
  EXPECT_EQ(numbers("\"sep=;\"\na;b\n1;2.5\n"), all);
  EXPECT_EQ(complaint("a;b\nsep=;\n1;2\n").substr(0, 8), "t.csv:2:");
}

TEST_F(CsvTable, HeadingsHaveNamesAndUnits) {
  for (const char* text : {"mass [g/s]", "mass (g/s)", "mass g/s"}) {
    EXPECT_EQ(csv_heading(text).name, "mass") << text;
    EXPECT_EQ(csv_heading(text).unit, "g/s") << text;
  }
  EXPECT_EQ(csv_heading("fill level [mm]").name, "fill level");
  EXPECT_EQ(csv_heading("mass").unit, "");
  for (const char* text : {"filled mass kg", "filled mass (kg)", "filled mass [kg]"}) {
    EXPECT_EQ(csv_heading(text).name, "filled mass") << text;
    EXPECT_EQ(csv_heading(text).unit, "kg") << text;
  }
  EXPECT_EQ(csv_heading("speed m / s").unit, "m / s");
  EXPECT_EQ(csv_heading("fraction (mean) [1]").name, "fraction (mean)");
}

TEST_F(CsvTable, FaultsOfNumbersAreNamedWithLineAndColumn) {
  EXPECT_EQ(complaint("a,b\n1, two\n"), "t.csv:2:4: found \"two\", expected a number with a decimal point");
  for (const char* word : {"nan", "inf", "0x10", "1e", "1 mm"})
    EXPECT_NE(complaint("a,b\n1," + std::string(word) + "\n").find("t.csv:2:3: found \""), std::string::npos);
  EXPECT_EQ(
      complaint("a,b\n1,1e999\n"),
      "t.csv:2:3: found \"1e999\", too large or too small; allowed: 0, and 1e-307 to 1e307 in magnitude");
  EXPECT_EQ(complaint("a,b\n1,\n"), "t.csv:2:3: found nothing; give a number or remove the line");
}

TEST_F(CsvTable, DecimalCommasAreNamed) {
  EXPECT_EQ(
      complaint("a;b\n1;2,5\n"),
      "t.csv:2:3: found \"2,5\", a number with a decimal comma; write a decimal point, such as \"2.5\"");
  EXPECT_EQ(complaint("a,b\n\"2,5\",1\n").substr(0, 25), "t.csv:2:1: found \"2,5\", a");
  EXPECT_EQ(complaint("a,b\n2,5,0,3\n"),
            "t.csv:2: found 4 values, expected 2, one per column; if these are decimal commas, write decimal "
            "points");
  // A comma that is none of a number, and one between thousands.
  EXPECT_EQ(complaint("a;b\n1;0.3,0.02\n"),
            "t.csv:2:3: found \"0.3,0.02\", expected one number with a decimal point and without commas, and "
            "semicolons between columns, as in the heading");
  EXPECT_NE(complaint("a;b\n1;1,234,5\n").find("without commas, and semicolons"), std::string::npos);
  EXPECT_EQ(complaint("a,b\n2;3\n"),
            "t.csv:2: found 1 values, expected 2, one per column: the heading separates columns by commas, "
            "this line has semicolons; use one of them throughout, and decimal points");
}

TEST_F(CsvTable, OtherEncodingsAreRefusedInOneLine) {
  EXPECT_EQ(complaint(std::string("\xFF\xFE"
                                  "a\0,\0",
                                  6)),
            "t.csv:1: found UTF-16 text, expected UTF-8; save the table as UTF-8 text");
  EXPECT_EQ(complaint("a,b\n1,\xE4\n"),
            "t.csv:2:3: found the byte 0xE4, which is not UTF-8; save the table as UTF-8 text");
  EXPECT_EQ(
      complaint(std::string("a,b\n1,\0", 7)),
      "t.csv:2:3: found the byte 0, which does not occur in a text file; give a CSV table saved as UTF-8");
}

TEST_F(CsvTable, ColumnsOfOneNameAreRefused) {
  CsvFile file = opened("a,b,a\n");
  ASSERT_TRUE(file.next());
  EXPECT_NO_THROW(file.refuse_twice({"a", "b", "c"}));
  EXPECT_THROW(file.refuse_twice({"a", "b", "a"}), SceneError);
}

}  // namespace
}  // namespace diefill::process
