// A scene that includes another: a study varies one file.
#include "tests/unit/scene_fixture.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using SceneInclude = tests::SceneTest;

constexpr const char* base_gyration = "[gyration]\npressure = \"300 kPa\"\ncount = 7\n";

TEST_F(SceneInclude, replaces_key_by_key_what_the_base_gives) {
  files_.write("base.toml", std::string(tests::least) + base_gyration);
  const auto scene = read("include = \"base.toml\"\n[gyration]\ncount = 9\n[stones.fracture]\n");
  EXPECT_EQ(scene.gyration.count, 9);
  EXPECT_NEAR(scene.gyration.pressure, 300e3, 1e-9);
  EXPECT_EQ(scene.stones.count, 450);
  EXPECT_TRUE(scene.stones.fracture);
}

TEST_F(SceneInclude, takes_away_keys_and_sections_with_none) {
  files_.write("base.toml", std::string(tests::least) +
                                "[mould.elastic]\nmodes = 5\n[stones.fracture]\nexponent = 4\n");
  const auto scene = read(
      "include = \"base.toml\"\n[mould]\nelastic = \"none\"\ndiameter = \"none\"\n"
      "aspect_ratio = 1.5\n");
  EXPECT_FALSE(scene.mould.elastic);
  EXPECT_FALSE(scene.mould.diameter);
  EXPECT_EQ(scene.mould.aspect_ratio, 1.5);
  EXPECT_TRUE(scene.stones.fracture);
}

TEST_F(SceneInclude, finds_each_path_from_the_file_it_is_written_in) {
  files_.write("common/sieves.csv", "sieve_mm,passing_percent\n2,20\n11.2,100\n");
  files_.write("common/base.toml", tests::least);
  EXPECT_EQ(read("include = \"common/base.toml\"\n").stones.sieves.sieve.back(), 11.2e-3);
  EXPECT_EQ(read("include = \"common/base.toml\"\n[stones]\ngradation = \"sieves.csv\"\n")
                .stones.sieves.sieve.back(),
            16e-3);
}

TEST_F(SceneInclude, goes_through_more_than_one_file_and_options_come_last) {
  files_.write("machine.toml", base_gyration);
  files_.write("base.toml", std::string("include = \"machine.toml\"\n") + tests::least +
                                "[gyration]\ncount = 8\n");
  const auto scene = read("include = \"base.toml\"\n", {"gyration.pressure=500 kPa"});
  EXPECT_EQ(scene.gyration.count, 8);
  EXPECT_NEAR(scene.gyration.pressure, 500e3, 1e-9);
}

TEST_F(SceneInclude, reports_mistakes_in_the_file_that_they_are_in) {
  files_.write("base.toml", std::string(tests::least) + "[gyration]\npresure = 1\n");
  EXPECT_THAT(mistakes("include = \"base.toml\"\n[gyration]\ncount = -1\nspin = \"none\"\n"
                       "turn = \"none\"\n"),
              testing::UnorderedElementsAre(
                  AllOf(StartsWith(files_.path("base.toml") + ":11:1: expected a known key"),
                        HasSubstr("gyration.pressure")),
                  StartsWith(at("3:9")), StartsWith(at("5:1"))));
}

TEST_F(SceneInclude, refuses_what_cannot_be_included) {
  EXPECT_THAT(mistakes(std::string("include = \"missing.toml\"\n") + tests::least),
              ElementsAre(AllOf(StartsWith(at("1:11")), HasSubstr("missing.toml"))));
  // Whatever is not said here may stand in the file that could not be read.
  EXPECT_THAT(mistakes("include = \"missing.toml\"\n[run]\nseed = -1\n"),
              ElementsAre(StartsWith(at("1:11")), StartsWith(at("3:8"))));
  EXPECT_THAT(mistakes(std::string("include = 3\n") + tests::least),
              ElementsAre(StartsWith(at("1:11"))));
  files_.write("base.toml", "include = \"scene.toml\"\n");
  EXPECT_THAT(mistakes(std::string("include = \"base.toml\"\n") + tests::least),
              ElementsAre(AllOf(StartsWith(files_.path("base.toml") + ":1:11"),
                                HasSubstr("does not include this one"))));
}

}  // namespace
