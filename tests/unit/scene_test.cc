#include "apps/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "apps/laws.h"
#include "tests/unit/scene_fixture.h"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;
using tests::least;

using Scene = tests::SceneTest;

TEST_F(Scene, keeps_the_defaults_of_what_it_does_not_say) {
  // scene.h: the member's initial value is the default.
  const apps::GyratoryScene scene = read(least), defaults;
  EXPECT_EQ(scene.stones.count, 450);
  EXPECT_EQ(scene.stones.young, defaults.stones.young);
  EXPECT_EQ(scene.gyration.pressure, defaults.gyration.pressure);
  EXPECT_EQ(scene.binder->bond_energy, 1e4);
  EXPECT_FALSE(scene.stones.fracture);
  EXPECT_FALSE(scene.stones.restitution);
  EXPECT_FALSE(scene.mould.elastic);
  EXPECT_FALSE(scene.mould.aspect_ratio);
  EXPECT_FALSE(scene.head.elastic);
}

TEST_F(Scene, is_in_si_whatever_its_units) {
  // The definitions of the units; a conversion rounds a few units in the last place.
  const auto scene = read(std::string(least) +
                          "[gyration]\nangle = \"1 deg\"\nspeed = \"30 rev/min\"\n"
                          "pressure = \"0.6 N/mm2\"\nramp = 2\ncount = 8.5\nspin = true\n");
  EXPECT_NEAR(scene.gyration.angle, std::numbers::pi / 180, 1e-16);
  EXPECT_NEAR(scene.gyration.speed, 0.5, 1e-15);
  EXPECT_NEAR(scene.gyration.pressure, 600e3, 1e-9);
  EXPECT_EQ(scene.gyration.ramp, 2);
  EXPECT_EQ(scene.gyration.count, 8.5);
  EXPECT_TRUE(scene.gyration.spin);
  EXPECT_NEAR(scene.binder->content, 0.066, 1e-16);
  EXPECT_NEAR(*scene.mould.diameter, 0.05, 1e-16);
}

TEST_F(Scene, models_the_sections_that_are_there) {
  // scene.h: a section that is absent is not modelled.
  const auto scene =
      read(std::string(least) + "[stones.fracture]\n[mould.elastic]\nheight = \"100 mm\"\n");
  ASSERT_TRUE(scene.stones.fracture && scene.mould.elastic);
  EXPECT_EQ(scene.stones.fracture->scale, 386.5e6);
  EXPECT_DOUBLE_EQ(scene.mould.elastic->height, 0.1);
  EXPECT_EQ(scene.mould.elastic->wall_thickness, 7.5e-3);
  EXPECT_FALSE(scene.head.elastic);
  EXPECT_FALSE(
      read("[stones]\ncount = 1\ngradation = \"sieves.csv\"\n[mould]\naspect_ratio = 1\n").binder);
}

TEST_F(Scene, takes_a_row_of_the_binder_table_by_its_temperature) {
  // Olsson, Jelagin, Partl, Table 1.
  const auto hot = read(least);
  EXPECT_EQ(hot.binder->shear_modulus, 6.65e6);
  EXPECT_THAT(hot.binder->alpha, ElementsAre(0.513, 0.487));
  EXPECT_THAT(hot.binder->tau, ElementsAre(0.0948, 105.9));
  const auto warm = read(least, {"binder.temperature=383.15"});
  EXPECT_EQ(warm.binder->shear_modulus, 17.74e6);
  EXPECT_THAT(warm.binder->alpha, ElementsAre(0.684, 0.316));
  EXPECT_THAT(warm.binder->tau, ElementsAre(0.0703, 64.223));
}

TEST_F(Scene, takes_a_binder_of_its_own) {
  // 2 MPa, 100 ms: the definitions of the units.
  const auto scene =
      read(least, {"binder.temperature=none", "binder.shear_modulus=2 MPa",
                   "binder.alpha=[0.2, 0.3, 0.5]", "binder.tau=[\"100 ms\", 1, \"2 min\"]"});
  EXPECT_DOUBLE_EQ(scene.binder->shear_modulus, 2e6);
  EXPECT_THAT(scene.binder->alpha, ElementsAre(0.2, 0.3, 0.5));
  EXPECT_THAT(scene.binder->tau, ElementsAre(0.1, 1, 120));
}

TEST_F(Scene, takes_the_borders_of_its_bounds) {
  // "from" and "at most" include the border.
  for (const char* option :
       {"stones.poisson=0", "stones.restitution=1", "gyration.angle=0", "gyration.angle=5 deg",
        "binder.bond_energy=0", "numerics.mass_scale=1", "fill.packing_density=0.38",
        "stones.smallest=0.063 mm", "stones.friction=0", "output.picture_interval=0 s"})
    EXPECT_THAT(mistakes(least, {option}), IsEmpty()) << option;
}

TEST_F(Scene, takes_a_whole_number_however_it_is_written) {
  // TOML 1.0.0: what has an exponent or a point is a float.
  const auto scene = read(least, {"stones.count=5e3", "run.seed=1.0"});
  EXPECT_EQ(scene.stones.count, 5000);
  EXPECT_EQ(scene.run.seed, 1);
}

TEST_F(Scene, lays_options_over_the_file) {
  // The command line is the last word; a shell may have taken the quotes.
  const auto scene =
      read(least, {"gyration.pressure=\"300 kPa\"", " stones.count = 7", "gyration.ramp=2 s",
                   "stones.fracture.exponent=4", "mould.diameter=none", "mould.aspect_ratio=1.5",
                   "head.elastic={plate_thickness = \"15 mm\"}", "gyration.ramp=3 s"});
  EXPECT_DOUBLE_EQ(scene.gyration.pressure, 300e3);
  EXPECT_EQ(scene.stones.count, 7);
  EXPECT_DOUBLE_EQ(scene.gyration.ramp, 3);
  ASSERT_TRUE(scene.stones.fracture);
  EXPECT_EQ(scene.stones.fracture->exponent, 4);
  EXPECT_FALSE(scene.mould.diameter);
  EXPECT_EQ(scene.mould.aspect_ratio, 1.5);
  ASSERT_TRUE(scene.head.elastic);
  EXPECT_DOUBLE_EQ(scene.head.elastic->plate_thickness, 0.015);
}

TEST_F(Scene, lets_an_option_mend_what_the_file_has_wrong) {
  // The value of the file is not read where an option replaces it.
  const std::string wrong = std::string(least) + "[gyration]\npressure = \"600 kN\"\n";
  EXPECT_THAT(mistakes(wrong), ElementsAre(StartsWith(at("11:12"))));
  EXPECT_EQ(read(wrong, {"gyration.pressure=600e3"}).gyration.pressure, 600e3);
}

TEST_F(Scene, loses_the_section_that_an_option_removes) {
  // `none` is the absence of a section, and absent means not modelled.
  const std::string elastic =
      std::string(least) + "[mould.elastic]\nmodes = 5\n[stones.fracture]\n";
  const auto scene = read(elastic, {"mould.elastic=none", "binder=none"});
  EXPECT_FALSE(scene.mould.elastic);
  EXPECT_FALSE(scene.binder);
  EXPECT_TRUE(scene.stones.fracture);
  EXPECT_EQ(read(elastic, {"mould.elastic=none", "mould.elastic={}"}).mould.elastic->modes, 60);
}

TEST_F(Scene, remembers_where_it_was_written) {
  // Line and column of the value, of its section where the key is absent.
  const auto scene = read(least, {"gyration.pressure=300 kPa"});
  const std::string path = files_.path("scene.toml");
  EXPECT_EQ(scene.where("stones.count"), path + ":2:9");
  EXPECT_EQ(scene.where("stones.young"), path + ":1:1");
  EXPECT_EQ(scene.where("gyration.pressure"), "--set gyration.pressure");
  EXPECT_EQ(scene.where("output.history_interval"), path);
  EXPECT_EQ(scene.source.text, least);
  EXPECT_THAT(scene.source.overrides, ElementsAre("gyration.pressure=300 kPa"));
}

TEST_F(Scene, finds_its_sieve_table_beside_itself) {
  // A path is resolved from the folder of the scene, not from where the program was started.
  files_.write("tables/fine.csv", "sieve_mm,passing_percent\n2,30\n8,100\n");
  const auto scene = read(least, {"stones.gradation=tables/fine.csv"});
  EXPECT_EQ(scene.stones.gradation, files_.path("tables/fine.csv"));
  EXPECT_THAT(scene.stones.sieves.passing, ElementsAre(0.3, 1.0));
}

TEST_F(Scene, of_a_flow_test_has_a_box) {
  // Olsson, Jelagin, Partl, section 3.2: 150 x 100 x 100 mm, a strip of 50 mm, 15 mm/min.
  const std::string text = "[stones]\ncount = 600\ngradation = \"sieves.csv\"\n";
  const auto scene = apps::read_flow_scene(files_.write("flow.toml", text), {});
  EXPECT_EQ(scene.flow.length, 0.15);
  EXPECT_EQ(scene.flow.strip_length, 0.05);
  EXPECT_DOUBLE_EQ(scene.flow.speed, 0.25e-3);
  const std::string wrong =
      text + "[flow]\nlength = \"40 mm\"\ndisplacement = \"100 mm\"\n[mould]\n";
  try {
    apps::read_flow_scene(files_.write("flow.toml", wrong), {});
    ADD_FAILURE();
  } catch (const apps::InputError& error) {
    const std::string path = files_.path("flow.toml");
    EXPECT_THAT(error.mistakes,
                ElementsAre(StartsWith(path + ":4:1: expected for flow.strip_length"),
                            StartsWith(path + ":6:16: expected"),
                            StartsWith(path + ":7:1: expected a known section")));
  }
}

TEST(ShippedScene, of_gyratory_compaction_reads_without_a_mistake) {
  // The numbers are those of Olsson, Jelagin, Partl, sections 3.1 and 3.3.
  const std::string folder = SCENES_FOLDER;
  for (const char* name : {"gyratory_sma11_150C.toml", "gyratory_sma11_150C_paper.toml",
                           "gyratory_ac11_150C_paper.toml"}) {
    const auto scene = apps::read_gyratory_scene(folder + '/' + name, {});
    EXPECT_DOUBLE_EQ(scene.stones.young, 74e9) << name;
    EXPECT_DOUBLE_EQ(scene.gyration.pressure, 600e3) << name;
    EXPECT_DOUBLE_EQ(scene.gyration.speed, 0.5) << name;
    EXPECT_NEAR(scene.binder->bond_energy, 1e4, 1e-8) << name;
    EXPECT_EQ(scene.binder->shear_modulus, 6.65e6) << name;
    EXPECT_NEAR(scene.stones.fracture->reference_volume, 244e-9, 1e-20) << name;
    EXPECT_EQ(scene.stones.sieves.passing.back(), 1) << name;
    const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
    EXPECT_NO_THROW(apps::LawBook(scene.stones, scene.binder, mix).check(scene.source)) << name;
  }
  const auto sma = apps::read_gyratory_scene(folder + "/gyratory_sma11_150C_paper.toml", {});
  const auto ac = apps::read_gyratory_scene(folder + "/gyratory_ac11_150C_paper.toml", {});
  EXPECT_EQ(sma.stones.count, 5000);
  EXPECT_DOUBLE_EQ(sma.binder->content, 0.066);
  EXPECT_DOUBLE_EQ(ac.binder->content, 0.060);
}

TEST(ShippedScene, of_the_flow_test_reads_without_a_mistake) {
  // Olsson, Jelagin, Partl, section 3.2.
  const std::string folder = SCENES_FOLDER;
  const auto paper = apps::read_flow_scene(folder + "/flow_sma11_150C_paper.toml", {});
  EXPECT_DOUBLE_EQ(paper.flow.length, 0.15);
  EXPECT_DOUBLE_EQ(paper.flow.speed, 0.25e-3);
  const auto demo = apps::read_flow_scene(folder + "/flow_sma11_150C.toml", {});
  EXPECT_LT(demo.stones.count, paper.stones.count);
}

}  // namespace
