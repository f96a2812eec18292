// Studies: how they are read, and what counts as an error.
#include "apps/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "apps/study_errors.h"
#include "tests/unit/recorder_fixture.h"
#include "tests/unit/written_file.h"

namespace apps {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* sound =
    "[study]\n"
    "program = \"gyratory\"\n"
    "scene = \"scene.toml\"\n"
    "seeds = [1, 2]\n"
    "reference = \"fine\"\n"
    "[base]\n"
    "gyration.count = 1\n"
    "[[setting]]\n"
    "name = \"fine\"\n"
    "[[setting]]\n"
    "name = \"rigid steel\"\n"
    "mould.elastic = \"none\"\n"
    "gyration.pressure = \"300 kPa\"\n";

class StudyTest : public testing::Test {
 protected:
  StudyTest() { files_.write("scene.toml", ""); }
  Study read(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return read_study(files_.write("study.toml", text), overrides);
  }
  std::vector<std::string> mistakes(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.mistakes;
    }
    return {};
  }
  tests::WrittenFiles files_;
};

TEST_F(StudyTest, lays_the_keys_of_a_setting_over_those_of_the_base) {
  const Study study = read(sound, {"base.gyration.count=3"});
  EXPECT_THAT(study.seeds, ElementsAre(1, 2));
  EXPECT_EQ(study.reference_setting().name, "fine");
  EXPECT_THAT(study.settings[0].overrides, ElementsAre("gyration.count=3"));
  EXPECT_EQ(study.settings[1].word, "rigid_steel");
  EXPECT_THAT(
      study.settings[1].overrides,
      ElementsAre("gyration.count=3", "gyration.pressure=\"300 kPa\"", "mould.elastic=none"));
}

TEST_F(StudyTest, reports_every_mistake_with_its_place) {
  const std::vector<std::string> found = mistakes(
      "[study]\n"
      "program = \"gyrator\"\n"
      "scene = \"nowhere.toml\"\n"
      "seeds = [1.5]\n"
      "reference = \"absent\"\n"
      "speed = 3\n"
      "[[setting]]\n"
      "name = \"a b\"\n"
      "[[setting]]\n"
      "name = \"a_b\"\n"
      "[[setting]]\n");
  EXPECT_THAT(found, ElementsAre(HasSubstr(":2:11: "), HasSubstr(":3:9: "), HasSubstr(":4:9: "),
                                 HasSubstr(":5:13: "), HasSubstr(":6:1: "), HasSubstr(":10:8: "),
                                 HasSubstr(":11:1: ")));
}

TEST(study_errors, are_differences_of_means_over_the_size_of_the_reference) {
  // Closed form: means 10 and 12, size 10: error 0.2; deviation sqrt(2), two runs each: noise
  // 2 sqrt(1/2 + 1/2) sqrt(2) / 10.
  const Judgement j = judge({{12}, {12}}, {{9}, {11}}, 0);
  EXPECT_TRUE(j.known);
  EXPECT_NEAR(j.error, 0.2, 1e-15);
  EXPECT_NEAR(j.noise, 2 * std::sqrt(2.0) / 10, 1e-15);
  EXPECT_EQ(j.sign, 1);
  EXPECT_FALSE(j.beyond());
  EXPECT_EQ(judge({{6}}, {{9}, {11}}, 0).sign, -1);
  EXPECT_TRUE(judge({{14}, {14}}, {{9}, {11}}, 0).beyond());
}

TEST(study_errors, of_curves_are_rms_over_their_points) {
  // Closed form: differences 3 and 4, reference 5 and 5.
  const Judgement j = judge({{8, 9}}, {{5, 5}, {5, 5}}, 0);
  EXPECT_NEAR(j.error, std::sqrt(12.5) / 5, 1e-15);
  EXPECT_EQ(j.noise, 0);
  EXPECT_EQ(j.sign, 0);
  EXPECT_TRUE(j.beyond());
}

TEST(study_errors, are_told_in_parts_of_the_least_size_where_the_reference_is_small) {
  // Two broken stones more than none are two, not infinitely many times more.
  EXPECT_EQ(judge({{2}}, {{0}, {0}}, 1).error, 2);
}

TEST(study_errors, are_unknown_without_scatter_or_result) {
  EXPECT_FALSE(judge({{1}}, {{1}}, 0).known);
  EXPECT_FALSE(judge({}, {{1}, {2}}, 0).known);
  EXPECT_FALSE(judge({{}}, {{1}, {2}}, 0).known);
}

class StudyResults : public tests::RecorderTest {};

TEST_F(StudyResults, have_the_slope_over_a_logarithm_beyond_the_first_half_unit) {
  // By construction: 3 per decade beyond 0.5, something else before.
  const Interest interest = {"gyration", {{"slope", "density", Quantity::per_decade, 1}}};
  Recorder recorder(file(), tests::provenance(), {{"gyration", "1"}, {"density", "1"}});
  for (int k = 0; k < 40; ++k) {
    const double gyration = 0.1 * k;
    recorder.append({{gyration, gyration > 0.5 ? 7 + 3 * std::log10(gyration) : -100}});
  }
  recorder.flush();
  const Found found = read_found(file(), interest);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].size(), 1u);
  EXPECT_NEAR(found[0][0], 3, 1e-9);
}

}  // namespace
}  // namespace apps
