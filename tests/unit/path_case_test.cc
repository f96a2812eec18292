#include "apps/path_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "apps/errors.h"
#include "tests/unit/written_file.h"

namespace apps {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* pair_of_shells =
    "[contact]\n"
    "kind = \"pair\"\n"
    "radius = [\"4 mm\", \"2.5 mm\"]\n"
    "[binder]\n"
    "shell_thickness = \"0.5 mm\"\n"
    "shear_modulus = \"6.65 MPa\"\n"
    "alpha = [0.513, 0.487]\n"
    "tau = [\"94.8 ms\", \"105.9 s\"]\n"
    "bitumen_fraction = 0.43\n"
    "bond_energy = \"0.01 J/mm2\"\n"
    "[path]\n"
    "file = \"path.csv\"\n";
constexpr const char* header = "time_s,overlap_m,shear_m\n";

class PathCaseTest : public testing::Test {
 protected:
  PathCase read(const std::string& text, const std::string& rows = "0,0,0\n1,1e-4,0\n",
                const std::vector<std::string>& overrides = {}) {
    files_.write("path.csv", header + rows);
    return read_path_case(files_.write("case.toml", text), overrides);
  }

  std::vector<std::string> mistakes(const std::string& text, const std::string& rows,
                                    const std::vector<std::string>& overrides = {}) {
    try {
      read(text, rows, overrides);
    } catch (const InputError& error) {
      return error.mistakes;
    }
    return {};
  }

  tests::WrittenFiles files_;
};

TEST_F(PathCaseTest, a_case_is_read_in_si) {
  // From the promise: any unit of the right dimension.
  const PathCase read_case = read(pair_of_shells, "# comment\n0,0,0\n0.5, 1e-4 ,-2e-5\n");
  EXPECT_FALSE(read_case.at_wall());
  EXPECT_THAT(read_case.radius, ElementsAre(4e-3, 2.5e-3));
  ASSERT_TRUE(read_case.binder);
  EXPECT_DOUBLE_EQ(read_case.shell, 0.5e-3);
  EXPECT_DOUBLE_EQ(read_case.binder->shear_modulus, 6.65e6);
  EXPECT_DOUBLE_EQ(read_case.binder->tau[0], 0.0948);
  EXPECT_DOUBLE_EQ(read_case.binder->bond_energy, 1e4);
  EXPECT_FALSE(read_case.stone);
  ASSERT_EQ(read_case.path.size(), 2u);
  EXPECT_EQ(read_case.path[1].time, 0.5);
  EXPECT_EQ(read_case.path[1].overlap, 1e-4);
  EXPECT_EQ(read_case.path[1].shear, -2e-5);
}

TEST_F(PathCaseTest, sections_that_are_absent_are_not_modelled) {
  // From the promise.
  const PathCase dry = read(
      "[contact]\nkind = \"wall\"\nradius = [\"4 mm\"]\n[stone]\nyoung = \"70 GPa\"\n"
      "[stone.fracture]\nseed = 7\n[wall]\n[path]\nfile = \"path.csv\"\n");
  EXPECT_TRUE(dry.at_wall());
  EXPECT_FALSE(dry.binder);
  EXPECT_EQ(dry.shell, 0);
  EXPECT_DOUBLE_EQ(dry.stone->young, 70e9);
  EXPECT_TRUE(dry.stone->fracture);
  EXPECT_EQ(dry.seed, 7);
  EXPECT_TRUE(dry.wall);
}

TEST_F(PathCaseTest, all_mistakes_are_found_at_once_and_where_they_are) {
  // From the promise: file, line and column of each, and what to do.
  const auto found = mistakes(pair_of_shells, "0,0,0\n1,1e-4\n0.5,nan,0\n-1,0,0\n",
                              {"contact.radius=[\"4 mm\"]", "binder.tau=[\"1 s\"]"});
  ASSERT_EQ(found.size(), 5u);
  const auto somewhere = [&](const std::string& where, const std::string& what) {
    EXPECT_THAT(found, testing::Contains(testing::AllOf(HasSubstr(where), HasSubstr(what))));
  };
  somewhere("--set contact.radius", "two radii");
  somewhere("--set binder.tau", "one tau for each alpha");
  somewhere("path.csv:3:1", "three numbers");
  somewhere("path.csv:4:1", "three numbers");
  somewhere("path.csv:5:1", "a time not before");
}

TEST_F(PathCaseTest, a_contact_of_nothing_and_a_path_that_is_not_there_are_refused) {
  // From the promise.
  const auto found = mistakes(
      "[contact]\nkind = \"pair\"\nradius = [\"4 mm\", \"4 mm\"]\n[path]\nfile = \"none.csv\"\n",
      "");
  EXPECT_THAT(
      found, ElementsAre(HasSubstr("a section [binder] or [stone]"), HasSubstr("no file to read")));
}

TEST_F(PathCaseTest, what_is_outside_the_box_of_the_laws_is_refused) {
  // sections.h: the box in which the laws are proven.
  for (const char* option : {"binder.bond_energy=0.11 J/mm2", "binder.shear_modulus=2 GPa",
                             "binder.shell_thickness=3.2 mm"}) {
    const std::string key(option, std::string(option).find('='));
    EXPECT_THAT(mistakes(pair_of_shells, "0,0,0\n", {option}),
                ElementsAre(HasSubstr("--set " + key + ": expected")));
  }
  EXPECT_THAT(mistakes(pair_of_shells, "0,0,0\n", {"stone.friction=1.6"}),
              ElementsAre(HasSubstr("--set stone.friction: expected")));
}

TEST_F(PathCaseTest, films_are_even_unless_the_case_says_rings) {
  // From the promise.
  EXPECT_EQ(read(pair_of_shells).binder->film, "even");
  const PathCase rings = read(pair_of_shells, "0,0,0\n", {"binder.film=rings"});
  EXPECT_EQ(rings.binder->film, "rings");
  EXPECT_THAT(mistakes(pair_of_shells, "0,0,0\n", {"binder.film=odd"}),
              ElementsAre(HasSubstr("one of even, rings")));
}

TEST_F(PathCaseTest, films_in_rings_that_relax_in_more_than_two_terms_are_refused) {
  // apps/laws.h: there is no law for them.
  EXPECT_THAT(
      mistakes(pair_of_shells, "0,0,0\n",
               {"binder.film=rings", "binder.alpha=[0.7, 0.2, 0.1]", "binder.tau=[1, 2, 3]"}),
      ElementsAre(
          HasSubstr("--set binder.film: expected at most 2 Prony terms with rings, found 3")));
}

TEST_F(PathCaseTest, restitution_is_for_dry_stones_that_do_not_break) {
  // There is no law for anything else.
  EXPECT_THAT(mistakes(pair_of_shells, "0,0,0\n", {"stone.restitution=0.5"}),
              ElementsAre(HasSubstr("no restitution")));
}

TEST_F(PathCaseTest, an_overlap_beyond_the_smaller_radius_is_a_mistake) {
  // A table in um: 50 of them, read as metres.
  EXPECT_THAT(mistakes(pair_of_shells, "0,0,0\n1,50,0\n"),
              ElementsAre(HasSubstr(":12:8: expected for path.file overlaps of at most 0.003 m")));
}

}  // namespace
}  // namespace apps
