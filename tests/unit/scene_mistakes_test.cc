#include "apps/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/scene_fixture.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::UnorderedElementsAre;
using tests::least;

using SceneMistakes = tests::SceneTest;

TEST_F(SceneMistakes, refuses_a_binder_told_twice_or_in_part) {
  // The temperature stands for the three others: one of the two ways, whole.
  EXPECT_THAT(mistakes(least, {"binder.alpha=[0.5]"}),
              ElementsAre(StartsWith("--set binder.alpha: expected either binder.temperature")));
  EXPECT_THAT(mistakes(least, {"binder.temperature=none", "binder.alpha=[0.5]"}),
              ElementsAre(AllOf(StartsWith(at("4:1")), HasSubstr("binder.shear_modulus")),
                          AllOf(StartsWith(at("4:1")), HasSubstr("binder.tau"))));
  EXPECT_THAT(mistakes(least, {"binder.temperature=130 degC"}),
              ElementsAre(AllOf(StartsWith("--set binder.temperature: expected"),
                                HasSubstr("110 degC or 150 degC"), HasSubstr("shear_modulus"))));
}

TEST_F(SceneMistakes, refuses_a_binder_outside_the_box_that_the_laws_are_proven_in) {
  // sections.h: 1 kPa to 1 GPa.
  for (const char* modulus : {"0.9 kPa", "1.1 GPa"})
    EXPECT_THAT(mistakes(least, {"binder.temperature=none", "binder.alpha=[0.5]", "binder.tau=[1]",
                                 std::string("binder.shear_modulus=") + modulus}),
                ElementsAre(StartsWith("--set binder.shear_modulus: expected")));
}

TEST_F(SceneMistakes, refuses_a_mix_of_fines_alone) {
  // All of it passes 8 mm, a sieve below the coarsest.
  const std::string table =
      files_.write("fines.csv", "sieve_mm,passing_percent\n2,30\n8,100\n11.2,100\n");
  EXPECT_THAT(mistakes(least, {"stones.gradation=" + table, "stones.smallest=8 mm"}),
              ElementsAre(StartsWith("--set stones.smallest: expected")));
  EXPECT_THAT(mistakes(least, {"stones.gradation=" + table, "stones.smallest=7.9 mm"}), IsEmpty());
}

TEST_F(SceneMistakes, refuses_a_binder_that_relaxes_more_than_it_has) {
  // G(t) > 0 asks for a sum of alpha of at most 1; Table 1 sums to 1 up to rounding.
  const std::vector<std::string> own = {"binder.temperature=none", "binder.shear_modulus=2 MPa"};
  auto options = own;
  options.insert(options.end(), {"binder.alpha=[0.6, 0.5]", "binder.tau=[1]"});
  EXPECT_THAT(
      mistakes(least, options),
      UnorderedElementsAre(AllOf(StartsWith("--set binder.tau"), HasSubstr("2 alpha")),
                           AllOf(StartsWith("--set binder.alpha"), HasSubstr("at most 1"))));
  options = own;
  options.insert(options.end(), {"binder.alpha=[0.7, 0.2, 0.1]", "binder.tau=[1, 2, 3]"});
  EXPECT_THAT(mistakes(least, options), IsEmpty());
}

TEST_F(SceneMistakes, reports_all_its_mistakes_at_once) {
  // Position of each: line and column of the value, or of the key where the key is the mistake.
  files_.write("sieves.csv", "sieve_mm,passing_percent\n2,25\n16,99\n");
  const auto found = mistakes(
      "[stones]\n"
      "cuont = 450\n"
      "gradation = \"sieves.csv\"\n"
      "young = \"74 GN\"\n"
      "poisson = 0.5\n"
      "friction = 0.7\n"
      "friction = 0.6\n"
      "[binder]\n"
      "content = \"6.6 %\"\n"
      "temperature = \"150 degC\"\n"
      "[mould]\n"
      "  diameter = \"50 mm\"\n"
      "  aspect_ratio = 1\n"
      "[gyration]\n"
      "pressure = 600 kPa\n"
      "speed = \"0.5 revs/s\"\n"
      "count = true\n"
      "[head.elastik]\n"
      "modes = 20\n");
  EXPECT_THAT(
      found,
      ElementsAre(AllOf(StartsWith(at("1:1")), HasSubstr("stones.count")),
                  AllOf(StartsWith(at("2:1")), HasSubstr("did you mean \"stones.count\"?")),
                  AllOf(StartsWith(at("4:9")), HasSubstr("GPa"), HasSubstr("74 GN")),
                  AllOf(StartsWith(at("5:11")), HasSubstr("below 0.5")),
                  AllOf(StartsWith(at("7:1")), HasSubstr("\"friction\" again")),
                  AllOf(StartsWith(at("13:3")), HasSubstr("both")),
                  AllOf(StartsWith(at("15:12")), HasSubstr("600 kPa"), HasSubstr("quotes")),
                  AllOf(StartsWith(at("16:9")), HasSubstr("unknown unit")),
                  AllOf(StartsWith(at("17:9")), HasSubstr("true")),
                  AllOf(StartsWith(at("18:1")), HasSubstr("did you mean \"head.elastic\"?")),
                  AllOf(StartsWith(files_.path("sieves.csv") + ":3:1"), HasSubstr("100 percent"))));
}

TEST_F(SceneMistakes, refuses_what_is_not_a_physical_value) {
  // Stability of an isotropic solid asks for 0 <= nu < 0.5 here; lengths, moduli, times are above
  // 0.
  for (const char* option : {"stones.poisson=-0.1",
                             "stones.poisson=0.5",
                             "stones.young=0",
                             "stones.density=-2650",
                             "stones.count=0",
                             "stones.count=4.5",
                             "stones.count=3000000000",
                             "stones.friction=-0.1",
                             "stones.restitution=1.1",
                             "fill.packing_density=0.6",
                             "fill.packing_density=0",
                             "binder.content=6.6",
                             "binder.bond_energy=-1",
                             "binder.bond_energy=0.11 J/mm2",
                             "binder.film=odd",
                             "stones.friction=1.6",
                             "mould.wall_friction=1.6",
                             "head.friction=1.6",
                             "stones.young=1e-4 GPa",
                             "stones.young=2 TPa",
                             "mould.diameter=0 mm",
                             "mould.diameter=-1",
                             "mould.diameter=10 mm",
                             "mould.elastic.height=250",  // metres, where mm were meant
                             "head.elastic.shaft_length=250",
                             "gyration.angle=1",
                             "gyration.pressure=0",
                             "gyration.ramp=0",
                             "gyration.count=inf",
                             "gyration.count=nan",
                             "stones.young=inf",
                             "gyration.speed=180 deg/s",
                             "gyration.angle=0.01745 m",
                             "numerics.safety=0",
                             "numerics.mass_scale=0.5",
                             "stones.smallest=0.01 mm",
                             "stones.smallest=16 mm",
                             "stones.distribution=normal",
                             "stones.distribution=5",
                             "gyration.spin=1",
                             "gyration.pressure=[600e3]",
                             "gyration.pressure=2020-01-01",
                             "gyration.angle=\"1\"",
                             "stones.gradation=missing.csv",
                             "stones.gradation=",
                             "run.seed=-1",
                             "output.history_interval=0",
                             "numerics.exchange_interval=0",
                             "stones.fracture.scale=0"}) {
    const std::string key(option, std::string(option).find('='));
    EXPECT_THAT(mistakes(least, {option}), ElementsAre(StartsWith("--set " + key + ": expected ")))
        << option;
  }
}

TEST_F(SceneMistakes, reports_the_mistakes_of_its_options) {
  // An option has no line: it is named by its key.
  EXPECT_THAT(
      mistakes(least, {"gyration.presure=1", "mould.elastc=none", "stones", "=1", "foo.bar=1",
                       "stones=5", "mould.diameter=5 kPa"}),
      UnorderedElementsAre(
          AllOf(StartsWith("--set gyration.presure: expected"), HasSubstr("\"gyration.pressure\"")),
          AllOf(StartsWith("--set mould.elastc: expected"), HasSubstr("\"mould.elastic\"")),
          StartsWith("--set stones: expected key=value"), StartsWith("--set : expected key=value"),
          StartsWith("--set foo.bar: expected a known section"),
          StartsWith("--set stones: expected a section [stones]"),
          StartsWith("--set stones: expected the key stones.count"),
          StartsWith("--set stones: expected the key stones.gradation"),
          AllOf(StartsWith("--set mould.diameter: expected"), HasSubstr("mm"))));
}

TEST_F(SceneMistakes, reports_letters_that_toml_does_not_know) {
  // TOML 1.0.0: bare keys and values are ASCII. toml++ 3.3 runs into undefined behaviour at "ö".
  EXPECT_THAT(
      mistakes(std::string(least) + "[gyration]  # Verdichtung mit ö\n"
                                    "kürze = 3\nspeed = 5 µm\ncount = -1\n"),
      ElementsAre(AllOf(StartsWith(at("11:2")), HasSubstr("`ü`")),
                  AllOf(StartsWith(at("12:11")), HasSubstr("`µ`")), StartsWith(at("13:9"))));
  EXPECT_THAT(mistakes(least, {"stones.distribution=größer", "stones.friction=ä"}),
              testing::SizeIs(2));
  files_.write("ö.csv", tests::sieves);
  EXPECT_THAT(mistakes(least, {"stones.gradation=ö.csv"}), IsEmpty());
}

TEST_F(SceneMistakes, reports_text_that_is_not_toml) {
  // TOML 1.0.0: what cannot be parsed is named by its place and the rest is still checked.
  EXPECT_THAT(mistakes("[stones\ncount = 1\n"), ElementsAre(StartsWith(at("1:8"))));
  EXPECT_THAT(mistakes(std::string(least) + "[mould]\n"), ElementsAre(StartsWith(at("10:1"))));
  EXPECT_THAT(mistakes(std::string(least) + "[gyration]\nramp =\nspeed = fast\n"),
              ElementsAre(StartsWith(at("11:6")), StartsWith(at("12:9"))));
  EXPECT_THAT(mistakes(std::string(least) + "[gyration]\nramp = [1,\nspeed = 2\n"),
              testing::Not(IsEmpty()));
  EXPECT_THAT(mistakes(std::string(least) + "[\\gyration]\nramp = 2\n"),
              ElementsAre(StartsWith(at("10:1"))));
  EXPECT_THAT(mistakes(least, {"gyration={\\ramp = 2}"}),
              ElementsAre(StartsWith("--set gyration: expected a section")));
  EXPECT_THAT(mistakes("\xff\xfe"), ElementsAre(HasSubstr("scene.toml:1:")));
}

TEST_F(SceneMistakes, hides_no_other_mistake_behind_a_header) {
  // TOML 1.0.0: each table is defined once. What stands below a repeated header is judged as if
  // it stood below the first; below one that cannot be read may be whatever is missing.
  EXPECT_THAT(
      mistakes(std::string(least) + "[mould]  # again = 1\nheight = 3\n[gyration]\nramp = -1\n"),
      ElementsAre(AllOf(StartsWith(at("10:1")), HasSubstr("[mould] again")),
                  AllOf(StartsWith(at("11:1")), HasSubstr("\"mould.height\"")),
                  StartsWith(at("13:8"))));
  EXPECT_THAT(mistakes("[stones]\ncount = 45\n[mould]\ndiameter = \"50 mm\"\n[stones]\n"),
              ElementsAre(HasSubstr("stones.gradation"), StartsWith(at("5:1"))));
  EXPECT_THAT(mistakes("[stones\ncount = 1\n[mould]\ndiameter = -1\n[gyration\n"),
              ElementsAre(AllOf(StartsWith(at("1:8")), HasSubstr("`[stones`")),
                          StartsWith(at("4:12")), StartsWith(at("5:10"))));
}

TEST_F(SceneMistakes, say_in_which_unit_a_bare_number_was_read) {
  // README: SI inside. One radian is no tilt of a head.
  EXPECT_THAT(mistakes(least, {"gyration.angle=1"}), ElementsAre(HasSubstr("found 1 rad;")));
  EXPECT_THAT(mistakes(least, {"gyration.count=-1"}), ElementsAre(HasSubstr("found -1;")));
}

TEST_F(SceneMistakes, name_the_limit_of_a_whole_number) {
  // The largest int, 2^31 - 1.
  for (const char* count : {"3000000000", "3e9", "inf"})
    EXPECT_THAT(mistakes(least, {std::string("stones.count=") + count}),
                ElementsAre(HasSubstr("a whole number of at most 2147483647, found")));
  EXPECT_THAT(mistakes(least, {"stones.count=-1e3"}),
              ElementsAre(HasSubstr("a whole number at least 1, found")));
}

TEST_F(SceneMistakes, compares_the_mould_with_the_first_sieve_that_all_stones_pass) {
  // Laboratory sheets go on to 63 mm.
  files_.write("sieves.csv", std::string(tests::sieves) + "22.4,100\n63,100\n");
  EXPECT_THAT(mistakes(least), IsEmpty());
  EXPECT_THAT(mistakes(least, {"mould.diameter=16 mm"}),
              ElementsAre(HasSubstr("more than the first sieve that all stones pass")));
}

TEST_F(SceneMistakes, are_told_once_however_many_checks_they_fail) {
  // A value that was refused is not compared with others, nor is its key missing.
  const std::string end = "[mould]\ndiameter = \"50 mm\"\n";
  for (const char* line :
       {"gradation =    sieves.csv", "gradation = \"\"", "gradation = 5",
        "gradation = \"sieves.csv\"\nsmallest =   2 mm", "gradation = \"sieves.csv\"\nsmallest = 0",
        "gradation = \"sieves.csv\"\n[binder]\ncontent = 0.06\ntemperature =   150 degC",
        "gradation = \"sieves.csv\"\n[binder]\ncontent = 0.06\ntemperature = \"150 kPa\"",
        "gradation = \"sieves.csv\"\n[head.elastic]\nshaft_diameter = true"})
    EXPECT_EQ(mistakes("[stones]\ncount = 450\n" + std::string(line) + '\n' + end).size(), 1u)
        << line;
}

TEST_F(SceneMistakes, suggest_the_section_of_a_misplaced_key) {
  // A name that is right but elsewhere is nearer than any misspelling.
  EXPECT_THAT(mistakes("seed = 1\n" + std::string(least)),
              ElementsAre(AllOf(StartsWith(at("1:1")), HasSubstr("\"run.seed\""))));
  EXPECT_THAT(mistakes(least, {"stones.bond_energy=1"}),
              ElementsAre(HasSubstr("\"binder.bond_energy\"")));
}

TEST_F(SceneMistakes, needs_its_file) {
  // A folder opens like a file but cannot be read.
  for (const std::string& path : {files_.path("none.toml"), files_.path(".")}) {
    try {
      apps::read_gyratory_scene(path, {});
      ADD_FAILURE() << path;
    } catch (const apps::InputError& error) {
      EXPECT_THAT(error.mistakes, ElementsAre(StartsWith(path + ": expected a scene file")));
    }
  }
}

TEST_F(SceneMistakes, that_is_empty_lacks_its_required_keys) {
  // scene.h: a mould and stones are the least there must be.
  EXPECT_THAT(mistakes(""), ElementsAre(HasSubstr("stones.count"), HasSubstr("stones.gradation"),
                                        HasSubstr("mould.diameter")));
}

TEST_F(SceneMistakes, refuses_keys_that_exclude_another) {
  // A rigid head is given its mass, an elastic one has that of its steel.
  EXPECT_THAT(mistakes(least, {"head.mass=3 kg", "head.elastic={}", "mould.diameter=150 mm"}),
              ElementsAre(StartsWith("--set head.mass: expected either")));
}

TEST_F(SceneMistakes, refuses_maps_that_would_not_end_with_a_gyration) {
  // A turn of two seconds is 200 rows of a hundredth, and no whole number of 0.3 s.
  EXPECT_THAT(mistakes(least, {"output.maps=true", "output.history_interval=10 ms"}), IsEmpty());
  EXPECT_THAT(mistakes(least, {"output.maps=true", "output.history_interval=0.3 s"}),
              ElementsAre(AllOf(StartsWith("--set output.history_interval: expected"),
                                HasSubstr("a whole number of rows"), HasSubstr("0.3 s"))));
  EXPECT_THAT(mistakes(least, {"output.history_interval=0.3 s"}), IsEmpty());
}

}  // namespace
