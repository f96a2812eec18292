#include "apps/bed_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/written_file.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class BedFile : public testing::Test {
 protected:
  apps::BedFile read(const std::string& content) {
    return apps::read_bed_file(file_.write("bed.csv", content), mistakes_);
  }
  std::string at(const std::string& position) const {
    return file_.path("bed.csv") + ':' + position + ": expected ";
  }

  tests::WrittenFiles file_;
  apps::Mistakes mistakes_;
};

TEST_F(BedFile, holds_stones_and_the_radius_of_their_cylinder) {
  // The numbers as written: reading decimal text is correctly rounded (IEEE 754-2008, 5.12).
  const apps::BedFile bed = read(
      "# settled; n=2 cylinder_radius=0.050 E=1e9\n"
      "# x,y,z,radius (m)\n"
      "-0.04,0.01,3e-2,0.002\n\n 0.5, -6 ,7,0.125\r\n");
  EXPECT_TRUE(mistakes_.lines().empty());
  EXPECT_EQ(bed.cylinder_radius, 0.05);
  EXPECT_THAT(bed.radius, ElementsAre(0.002, 0.125));
  EXPECT_THAT(bed.line, ElementsAre(3, 5));
  ASSERT_EQ(bed.position.size(), 2u);
  EXPECT_EQ(bed.position[0].x, -0.04);
  EXPECT_EQ(bed.position[0].z, 0.03);
  EXPECT_EQ(bed.position[1].y, -6);
}

TEST_F(BedFile, need_not_name_its_cylinder) {
  // The comment is optional by definition of the format; the program asks for --radius then.
  EXPECT_FALSE(read("0,0,1,1\n").cylinder_radius);
  EXPECT_FALSE(mistakes_.any());
}

TEST_F(BedFile, may_begin_with_its_header_and_a_byte_order_mark) {
  // What a spreadsheet saves as "CSV UTF-8". Below the first row there is no header.
  const apps::BedFile bed = read("\xEF\xBB\xBF# settled\nx,y,z,radius\r\n0,0,1,1\r\n");
  EXPECT_THAT(mistakes_.lines(), ElementsAre());
  EXPECT_THAT(bed.line, ElementsAre(3));
  read("0,0,1,1\nx,y,z,radius\n");
  EXPECT_THAT(mistakes_.lines(), ElementsAre(StartsWith(at("2:1"))));
}

TEST_F(BedFile, names_every_row_that_is_no_stone) {
  // Line and column of the first character at fault, both from 1.
  read(
      "# cylinder_radius=wide\n"
      "0,0,1,1\n"
      "0,zero,1,1\n"
      "0,0,1\n"
      "0,0,1,1,1\n"
      "0,0,1,-1\n"
      "0,0,nan,1\n"
      "0,0,1,\n");
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(StartsWith(at("1:19")), StartsWith(at("3:3")), StartsWith(at("4:1")),
                          StartsWith(at("5:1")), StartsWith(at("6:1")), StartsWith(at("7:5")),
                          StartsWith(at("8:7"))));
}

TEST_F(BedFile, is_not_without_stones) {
  // There is nothing to time in an empty bed.
  read("# cylinder_radius=0.05\n");
  EXPECT_THAT(mistakes_.lines(), ElementsAre(StartsWith(at("1:1") + "one stone or more")));
}

TEST_F(BedFile, that_is_missing_is_named) {
  // The path alone: there is no line to point at.
  apps::read_bed_file(file_.path("none.csv"), mistakes_);
  EXPECT_THAT(mistakes_.lines(), ElementsAre(StartsWith(file_.path("none.csv") + ": expected")));
}

TEST_F(BedFile, names_the_deepest_overlap_of_stones_and_of_a_stone_with_the_cylinder) {
  // Overlap / smaller radius by hand: (2 + 1 - 2.25) / 1 = 0.75 and (2 + 1 - 2.4) / 1 = 0.6; at the
  // mantle (9.7 + 1 - 10) / 1 = 0.7, on the floor 1 - 0.35 = 0.65.
  const apps::BedFile bed = read(
      "0,0,5,2\n"
      "2.4,0,5,1\n"
      "0,2.25,5,1\n"
      "9.7,0,5,1\n"
      "-5,0,0.35,1\n");
  apps::check_overlaps(bed, 10, 0.5, mistakes_);
  EXPECT_THAT(mistakes_.lines(),
              ElementsAre(AllOf(StartsWith(at("3:1")), HasSubstr("0.75 with the stone of line 1")),
                          AllOf(StartsWith(at("4:1")), HasSubstr("0.7 with the cylinder"))));
}

TEST_F(BedFile, may_overlap_within_reason) {
  // The overlaps of the bed above, just below and on the limit.
  const apps::BedFile bed = read("0,0,5,2\n0,2.25,5,1\n-5,0,0.25,1\n");
  apps::check_overlaps(bed, 10, 0.75, mistakes_);
  EXPECT_THAT(mistakes_.lines(), ElementsAre());
}

}  // namespace
