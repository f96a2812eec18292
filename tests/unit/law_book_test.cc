#include "apps/laws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "apps/bed.h"
#include "tests/physics/one_contact.h"
#include "tests/unit/scene_fixture.h"

namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using tests::least;

constexpr double endless = std::numeric_limits<double>::infinity();

// Plain numbers are in SI.
constexpr const char* round_numbers =
    "[stones]\n"
    "count = 450\n"
    "gradation = \"sieves.csv\"\n"
    "young = 60e9\n"
    "poisson = 0.25\n"
    "[binder]\n"
    "content = \"6.6 %\"\n"
    "shear_modulus = 2e6\n"
    "alpha = [0.5, 0.25]\n"
    "tau = [0.5, 20.0]\n"
    "bond_energy = 2e4\n"
    "[mould]\n"
    "diameter = \"50 mm\"\n";
constexpr double shell = 0.5e-3, bitumen_fraction = 0.25;  // [m], [-]

// Compliances of such a stone and of steel, normal and in shear [1/Pa]: (1 - nu^2) / E (Hertz
// 1882), (2 - nu) / G with G = E / 2(1 + nu) (Mindlin 1949).
struct Compliance {
  double normal, shear;
};
constexpr Compliance of_stone = {(1 - 0.25 * 0.25) / 60e9, (2 - 0.25) * 2 * (1 + 0.25) / 60e9};
constexpr Compliance of_steel = {(1 - 0.3 * 0.3) / 210e9, (2 - 0.3) * 2 * (1 + 0.3) / 210e9};

const apps::Counterpart stone = {std::nullopt, 0.6}, rigid_wall = {apps::rigid, 0.3},
                        endless_wall = {dem::Material{endless, 0.3}, 0.3},
                        steel_wall = {dem::Material{210e9, 0.3}, 0.3};

class LawBook : public tests::SceneTest {
 protected:
  apps::LawBook book(const std::vector<std::string>& options = {}) {
    const apps::GyratoryScene scene = read(round_numbers, options);
    apps::Mix mix;
    mix.shell = shell;
    mix.bitumen_fraction = bitumen_fraction;
    return {scene.stones, scene.binder, mix};
  }
};

// The stones' part of every law.
std::vector<apps::Dry> stone_laws(const apps::LawBook& book, const apps::Counterpart& other) {
  return {book.law<apps::Dry>(other, true), book.law<apps::BreakingDry>(other, true).stone,
          book.law<apps::Asphalt<2>>(other, true).a,
          book.law<apps::BreakingAsphalt<2>>(other, true).a.stone};
}

// The shells' part of every law.
std::vector<dem::Binder<2>> shell_laws(const apps::LawBook& book, const apps::Counterpart& other,
                                       bool bonds = true) {
  return {book.law<apps::Asphalt<2>>(other, bonds).b,
          book.law<apps::BreakingAsphalt<2>>(other, bonds).b};
}

std::vector<double> bond_energies(const apps::LawBook& book, const apps::Counterpart& other,
                                  bool bonds) {
  std::vector<double> energies;
  for (const auto& law : shell_laws(book, other, bonds)) energies.push_back(law.bond.energy);
  return energies;
}

// What no law is there for, of a scene that can be read.
std::vector<std::string> lawless(const apps::GyratoryScene& scene, const apps::Mix& mix) {
  try {
    apps::LawBook(scene.stones, scene.binder, mix).check(scene.source);
  } catch (const apps::InputError& error) {
    return error.mistakes;
  }
  return {};
}

TEST_F(LawBook, refuses_shells_thicker_than_the_smallest_stone) {
  // sections.h; so much bitumen that spheres could not hold it.
  const apps::GyratoryScene scene = read(least, {"binder.content=60 %"});
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  ASSERT_GT(mix.shell, apps::thickest_shell * mix.smallest_radius());
  EXPECT_THAT(lawless(scene, mix), ElementsAre(AllOf(StartsWith("--set binder.content: expected"),
                                                     HasSubstr("smallest stone"))));
}

TEST_F(LawBook, refuses_films_in_rings_that_relax_in_more_than_two_terms) {
  // apps/laws.h: there is no law for them.
  const auto scene = [&](const std::string& alpha, const std::string& tau) {
    return read(least, {"binder.temperature=none", "binder.shear_modulus=2 MPa",
                        "binder.film=rings", "binder.alpha=" + alpha, "binder.tau=" + tau});
  };
  const apps::GyratoryScene two = scene("[0.7, 0.3]", "[1, 2]");
  const apps::GyratoryScene three = scene("[0.7, 0.2, 0.1]", "[1, 2, 3]");
  const apps::Mix mix = apps::prepare_mix(two.stones, two.binder, two.run.seed);
  EXPECT_THAT(lawless(two, mix), IsEmpty());
  EXPECT_THAT(lawless(three, mix),
              ElementsAre(AllOf(StartsWith("--set binder.film: expected at most 2 Prony terms"),
                                HasSubstr("found 3"))));
}

TEST_F(LawBook, stone_and_counterpart_yield_by_the_sum_of_their_compliances) {
  // Closed form: 1 / E0 and 1 / G* are the sums over both bodies; walls that do not yield add none.
  struct Row {
    apps::Counterpart other;
    Compliance its;
  };
  for (const auto& [other, its] : {Row{stone, of_stone}, Row{steel_wall, of_steel},
                                   Row{rigid_wall, {0, 0}}, Row{endless_wall, {0, 0}}})
    for (const apps::Dry& law : stone_laws(book(), other)) {
      EXPECT_DOUBLE_EQ(law.normal.modulus, 1 / (of_stone.normal + its.normal));
      EXPECT_DOUBLE_EQ(law.shear_modulus, 1 / (of_stone.shear + its.shear));
    }
}

TEST_F(LawBook, two_shells_lie_between_stones_and_one_before_a_wall) {
  // model.md: stones touch at h = 2t, the film is as thick; t at a wall.
  for (const apps::Dry& law : stone_laws(book(), stone)) EXPECT_EQ(law.cover, 2 * shell);
  for (const auto& law : shell_laws(book(), stone)) EXPECT_EQ(law.film, 2 * shell);
  for (const apps::Counterpart& wall : {rigid_wall, steel_wall}) {
    for (const apps::Dry& law : stone_laws(book(), wall)) EXPECT_EQ(law.cover, shell);
    for (const auto& law : shell_laws(book(), wall)) EXPECT_EQ(law.film, shell);
  }
}

TEST_F(LawBook, stones_without_binder_touch_as_soon_as_they_meet) {
  // README.md: a section that is absent is not modelled.
  const apps::GyratoryScene scene = read(round_numbers, {"binder=none"});
  const apps::LawBook dry(scene.stones, scene.binder, apps::Mix{});
  for (const apps::Counterpart& other : {stone, rigid_wall, steel_wall}) {
    EXPECT_EQ(dry.law<apps::Dry>(other, true).cover, 0);
    EXPECT_EQ(dry.law<apps::BreakingDry>(other, true).stone.cover, 0);
  }
}

TEST_F(LawBook, shells_push_at_a_wall_by_twice_the_factor_of_a_pair) {
  // model.md, Lee & Radok (1960): 8/3, at a wall 16/3.
  for (const auto& law : shell_laws(book(), stone)) EXPECT_DOUBLE_EQ(law.normal_factor, 8.0 / 3);
  for (const apps::Counterpart& wall : {rigid_wall, steel_wall})
    for (const auto& law : shell_laws(book(), wall)) EXPECT_DOUBLE_EQ(law.normal_factor, 16.0 / 3);
}

TEST_F(LawBook, only_the_bitumen_of_the_shells_relaxes) {
  // model.md: A_i = alpha_i V_bitumen / (V_bitumen + V_fines).
  for (const apps::Counterpart& other : {stone, rigid_wall, steel_wall})
    for (const auto& law : shell_laws(book(), other)) {
      EXPECT_EQ(law.modulus, 2e6);
      EXPECT_THAT(law.weight, ElementsAre(0.125, 0.0625));
      EXPECT_THAT(law.time, ElementsAre(0.5, 20));
    }
}

TEST_F(LawBook, terms_that_a_scene_does_not_name_relax_nothing) {
  const auto law = book().law<apps::Asphalt<apps::most_prony_terms>>(stone, true).b;
  EXPECT_THAT(law.weight, ElementsAre(0.125, 0.0625, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(law.time, Each(Gt(0)));  // or the decay is not a number
  for (const auto& one : shell_laws(book({"binder.alpha=[0.5]", "binder.tau=[0.5]"}), stone)) {
    EXPECT_THAT(one.weight, ElementsAre(0.125, 0));
    EXPECT_THAT(one.time, Each(Gt(0)));
  }
}

TEST_F(LawBook, stones_bond_once_they_may) {
  for (const char* wall_bonds : {"binder.wall_bonds=false", "binder.wall_bonds=true"}) {
    EXPECT_THAT(bond_energies(book({wall_bonds}), stone, true), Each(2e4));
    EXPECT_THAT(bond_energies(book({wall_bonds}), stone, false), Each(0));
  }
}

TEST_F(LawBook, shells_bond_to_walls_only_where_the_scene_says_so) {
  // README.md, "The model": hot, oiled steel is the default.
  for (const apps::Counterpart& wall : {rigid_wall, steel_wall}) {
    EXPECT_THAT(bond_energies(book(), wall, true), Each(0));
    EXPECT_THAT(bond_energies(book({"binder.wall_bonds=true"}), wall, true), Each(2e4));
    EXPECT_THAT(bond_energies(book({"binder.wall_bonds=true"}), wall, false), Each(0));
  }
}

TEST_F(LawBook, stones_rub_on_stones_and_walls_but_films_slip_on_walls_alone) {
  // model.md: films stick between stones; on walls they slip at friction x F, bonded or not.
  for (const apps::Dry& law : stone_laws(book(), stone)) EXPECT_EQ(law.friction, 0.6);
  for (const auto& law : shell_laws(book(), stone))
    EXPECT_EQ(law.friction, std::numeric_limits<double>::max());
  for (const apps::Counterpart& wall : {rigid_wall, steel_wall}) {
    for (const apps::Dry& law : stone_laws(book(), wall)) EXPECT_EQ(law.friction, 0.3);
    for (const char* wall_bonds : {"binder.wall_bonds=false", "binder.wall_bonds=true"})
      for (const auto& law : shell_laws(book({wall_bonds}), wall)) EXPECT_EQ(law.friction, 0.3);
  }
}

TEST_F(LawBook, a_stone_that_breaks_softens_its_own_share_of_a_contact) {
  // Closed form: its compliance / that of the contact; a pair has the mean softness of its stones.
  const auto shares = [&](const apps::Counterpart& other) {
    return std::vector<double>{book().law<apps::BreakingDry>(other, true).stone_share,
                               book().law<apps::BreakingAsphalt<2>>(other, true).a.stone_share};
  };
  for (const apps::Counterpart& other : {stone, rigid_wall, endless_wall})
    EXPECT_THAT(shares(other), Each(1));
  EXPECT_THAT(shares(steel_wall),
              Each(DoubleEq(of_stone.normal / (of_stone.normal + of_steel.normal))));
}

TEST_F(LawBook, a_stone_meets_a_rigid_wall_as_it_meets_its_mirror_image) {
  // By symmetry: the plane between two equal stones that are pressed together and slid past each
  // other stays where it is, a rigid wall to each, of half the overlap and half the sliding.
  using Law = apps::Asphalt<2>;
  constexpr double radius = 4e-3;  // of the bare stone [m]
  const apps::Counterpart wall = {apps::rigid, stone.friction};
  dem::OneContact<Law> of_wall(book().law<Law>(wall, true), radius + shell, radius);
  dem::OneContact<Law> of_pair(book().law<Law>(stone, true), (radius + shell) / 2, radius / 2);
  for (int n = 1; n <= 20; ++n) {  // from n = 17 on stones touch, too
    const double overlap = 0.06 * n * shell;
    const dem::Vec3d slid = {0, 1e-3 * shell, 0};  // sticks
    const auto at_wall = of_wall.move(overlap, 0.01, slid);
    const auto at_pair = of_pair.move(2 * overlap, 0.01, 2.0 * slid);
    EXPECT_NEAR(at_wall.push / at_pair.push, 1, 1e-12);
    EXPECT_NEAR(at_wall.shear.y / at_pair.shear.y, 1, 1e-12);
    EXPECT_NEAR(at_wall.stiffness / at_pair.stiffness, 2, 1e-12);
    EXPECT_EQ(at_wall.stone > 0, n >= 17);
    EXPECT_EQ(at_pair.stone > 0, n >= 17);
  }
}

}  // namespace
