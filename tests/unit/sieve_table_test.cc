#include "apps/sieve_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/written_file.h"

namespace {

using apps::Mistakes;
using apps::Place;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class SieveTable : public testing::Test {
 protected:
  dem::SieveTable read(const std::string& content) {
    return apps::read_sieve_table(file_.write("sieves.csv", content), Place{"scene.toml", 3, 13},
                                  mistakes_);
  }
  std::string at(const std::string& position) const {
    return file_.path("sieves.csv") + ':' + position + ": expected ";
  }

  tests::WrittenFiles file_;
  Mistakes mistakes_;
};

TEST_F(SieveTable, holds_metres_and_fractions) {
  // The units that the header names: 1 mm = 1e-3 m, 1 percent = 0.01.
  const auto table = read("# a comment\nsieve_mm,passing_percent\n\n0.063,10\n 2, 25 \n16,100\n");
  EXPECT_TRUE(mistakes_.lines().empty());
  ASSERT_EQ(table.sieve.size(), 3u);
  EXPECT_DOUBLE_EQ(table.sieve[0], 0.063e-3);
  EXPECT_DOUBLE_EQ(table.sieve[1], 2e-3);
  EXPECT_DOUBLE_EQ(table.passing[1], 0.25);
  EXPECT_DOUBLE_EQ(table.passing[2], 1.0);
}

TEST_F(SieveTable, may_end_its_lines_as_a_spreadsheet_does) {
  // RFC 4180: lines of CSV end in CR LF.
  const auto table = read("sieve_mm,passing_percent\r\n2,25\r\n16,100\r\n");
  EXPECT_TRUE(mistakes_.lines().empty());
  EXPECT_THAT(table.passing, ElementsAre(0.25, 1.0));
}

TEST_F(SieveTable, may_begin_with_a_byte_order_mark) {
  // Excel puts EF BB BF before what it saves as "CSV UTF-8".
  const auto table = read("\xEF\xBB\xBFsieve_mm,passing_percent\r\n2,25\r\n16,100\r\n");
  EXPECT_THAT(mistakes_.lines(), ElementsAre());
  EXPECT_THAT(table.passing, ElementsAre(0.25, 1.0));
}

TEST_F(SieveTable, has_commas_between_its_columns) {
  // A German Excel writes semicolons, and commas into the numbers: told once, not once a row.
  read("sieve_mm;passing_percent\n5,6;40\n11,2;95\n16;100\n");
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(AllOf(StartsWith(at("1:1") + "the header"), HasSubstr("semicolons"),
                                HasSubstr("commas between the columns"))));
}

TEST_F(SieveTable, names_every_faulty_field) {
  // Position of each field: its line and the column of its first character, both from 1.
  read(
      "sieve_mm,passing_percent\n"
      "2,25\n"
      "x,30\n"
      "4, 120\n"
      "3;40\n"
      "8,57.5\n"
      "5.6,60\n"
      "11.2,50\n");
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(StartsWith(at("3:1")), StartsWith(at("4:4")), StartsWith(at("5:1")),
                          StartsWith(at("7:1")), StartsWith(at("8:1")), StartsWith(at("8:6"))));
}

TEST_F(SieveTable, needs_its_header) {
  // A table without units could be in inches.
  read("2,25\n16,100\n");
  EXPECT_THAT(mistakes_.lines(), ElementsAre(StartsWith(at("1:1") + "the header")));
}

TEST_F(SieveTable, does_not_read_numbers_from_another_header) {
  // What is wrong with the line is told once: it is a header, and not the one that is asked for.
  read("sieve,passing\n2,25\n16,100\n");
  EXPECT_THAT(mistakes_.lines(), ElementsAre(StartsWith(at("1:1") + "the header")));
}

TEST_F(SieveTable, does_not_take_infinity_for_a_sieve) {
  // from_chars reads the words inf and nan as numbers.
  read("sieve_mm,passing_percent\n2,25\nnan,30\n4,nan\ninf,100\n16,100\n");
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(StartsWith(at("3:1")), StartsWith(at("4:3")), StartsWith(at("5:1"))));
}

TEST_F(SieveTable, is_not_empty) {
  // Two sieves are the least that hold a distribution.
  read("");
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(StartsWith(at("1:1") + "the header"), StartsWith(at("1:1") + "two")));
}

TEST_F(SieveTable, that_is_missing_is_a_mistake_of_the_scene) {
  // The user mends the path in the scene, so that is the place to name.
  apps::read_sieve_table(file_.path("none.csv"), Place{"scene.toml", 3, 13}, mistakes_);
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(StartsWith("scene.toml:3:13: expected a sieve table")));
  EXPECT_THAT(mistakes_.lines().front(), HasSubstr("none.csv"));
}

}  // namespace
