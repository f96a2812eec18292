#include <numbers>

#include "tests/unit/scene_fixture.h"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using tests::least;

using SceneGauges = tests::SceneTest;

constexpr const char* steel = "[mould.elastic]\nheight = \"100 mm\"\n";

TEST_F(SceneGauges, are_as_many_as_the_scene_names) {
  // TOML, array of tables; the definitions of the units.
  EXPECT_THAT(read(std::string(least) + steel).gauges, IsEmpty());
  const auto gauges = read(std::string(least) + steel +
                           "[[output.gauge]]\nangle = \"0 deg\"\nheight = \"20 mm\"\n"
                           "[[output.gauge]]\nangle = \"90 deg\"\nheight = \"5 cm\"\n"
                           "length = \"6 mm\"\n")
                          .gauges;
  ASSERT_EQ(gauges.size(), 2);
  EXPECT_EQ(gauges[0].angle, 0);
  EXPECT_DOUBLE_EQ(gauges[0].height, 0.02);
  EXPECT_DOUBLE_EQ(gauges[0].length, 0.01);
  EXPECT_DOUBLE_EQ(gauges[1].angle, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(gauges[1].height, 0.05);
  EXPECT_DOUBLE_EQ(gauges[1].length, 0.006);
}

TEST_F(SceneGauges, may_be_given_or_taken_away_by_an_option) {
  // TOML, inline tables.
  const std::string one =
      std::string(least) + steel + "[[output.gauge]]\nangle = 0\nheight = \"20 mm\"\n";
  EXPECT_THAT(read(one, {"output.gauge=none"}).gauges, IsEmpty());
  EXPECT_THAT(read(least, {"output.gauge=none"}).gauges, IsEmpty());
  EXPECT_EQ(
      read(one, {"output.gauge=[{angle=1, height=0.01}, {angle=2, height=0.02}]"}).gauges.size(),
      2);
}

TEST_F(SceneGauges, need_an_elastic_mould_and_a_place_on_it) {
  // Every mistake in one report, each at its place.
  const std::string gauge = "[[output.gauge]]\nangle = \"0 deg\"\nheight = \"120 mm\"\n";
  EXPECT_THAT(mistakes(std::string(least) + gauge),
              ElementsAre(at("10:1") +
                          "[mould.elastic], which a gauge is glued to, found a rigid mould; add "
                          "that section, or remove the gauge"));
  EXPECT_THAT(mistakes(std::string(least) + steel + gauge),
              ElementsAre(at("14:10") +
                          "for output.gauge[0].height a height below that of the mould, found "
                          "\"120 mm\"; lower it"));
  EXPECT_THAT(mistakes(std::string(least) + steel + "[[output.gauge]]\nheight = \"20 mm\"\n"),
              ElementsAre(at("12:1") + "the key output.gauge[0].angle, found none; add below "
                                       "[[output.gauge]] angle = \"0 deg\""));
}

using SceneModes = tests::SceneTest;

TEST_F(SceneModes, are_a_number_or_a_share) {
  // scene.h: below 1 a share of the compliance, else a whole number.
  const auto modes = [&](const std::string& value) {
    return read(std::string(least) + steel + "modes = " + value + '\n').mould.elastic->modes;
  };
  EXPECT_EQ(modes("30"), 30);
  EXPECT_EQ(modes("\"1e-3\""), 1e-3);
  EXPECT_THAT(
      mistakes(std::string(least) + steel + "modes = 20.5\n"),
      ElementsAre(at("12:9") + "for mould.elastic.modes a whole number, or a share below 1, found "
                               "20.5; write 20 or \"1e-3\""));
}

}  // namespace
