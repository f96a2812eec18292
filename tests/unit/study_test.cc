// Studies: how they are read, and what counts as an error.
#include "apps/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "apps/study_errors.h"
#include "apps/study_runs.h"
#include "tests/unit/recorder_fixture.h"
#include "tests/unit/written_file.h"

namespace apps {
namespace {

using testing::Contains;
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
  std::vector<std::string> mistakes(const std::string& text,
                                    const std::vector<std::string>& overrides = {}) {
    try {
      read(text, overrides);
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
  EXPECT_THAT(mistakes("[study]\nprogram = \"gyratory\"\nscene = \"scene.toml\"\n"
                       "seeds = [3, 3]\nreference = \"a\"\n[[setting]]\nname = \"a\"\n"),
              ElementsAre(HasSubstr(":4:9: expected for study.seeds no number twice")));
}

TEST_F(StudyTest, knows_where_the_keys_of_its_settings_stand) {
  const Study study = read(std::string(sound) + "gyration.count = 2\n", {"base.stones.count=9"});
  const auto &fine = study.settings[0].places, &rigid = study.settings[1].places;
  EXPECT_EQ(fine.at("gyration.count").text(), study.path + ":7:10");
  EXPECT_EQ(rigid.at("gyration.count").text(), study.path + ":14:10");
  EXPECT_EQ(rigid.at("stones.count").text(), "--set base.stones.count");
  const std::string mistake = ": expected a known key, found \"a: b\"; remove it";
  EXPECT_EQ(placed_in_study("--set gyration.count" + mistake, rigid),
            study.path + ":14:10" + mistake);
  EXPECT_EQ(placed_in_study("scene.toml:3:1" + mistake, rigid), "scene.toml:3:1" + mistake);
  EXPECT_EQ(placed_in_study("--set run.seed" + mistake, rigid), "--set run.seed" + mistake);
}

TEST_F(StudyTest, takes_keys_away_by_an_option_as_in_its_file) {
  const Study study = read(sound, {"base.gyration.count=none", "setting[0].stones.count=none"});
  EXPECT_THAT(study.settings[0].overrides, ElementsAre("gyration.count=none", "stones.count=none"));
}

TEST_F(StudyTest, offers_the_sections_that_it_knows) {
  const std::string study = sound;
  EXPECT_THAT(mistakes(study + "[bas]\nstones.count = 3\n[[settings]]\nname = \"a\"\n"),
              ElementsAre(HasSubstr(":14:1: expected one of the sections [study], [base] and "
                                    "[[setting]], found [bas]; did you mean [base]?"),
                          HasSubstr(":16:1: expected one of the sections [study], [base] and "
                                    "[[setting]], found [[settings]]; did you mean [[setting]]?")));
  EXPECT_THAT(mistakes(study.substr(0, study.find("[[")) + "[setting]\nname = \"fine\"\n"),
              Contains(HasSubstr(":8:1: expected one of the sections [study], [base] and "
                                 "[[setting]], found [setting]; did you mean [[setting]]?")));
  EXPECT_THAT(mistakes("base = 3\n" + study),
              Contains(HasSubstr(":1:8: expected a section [base], found one value, 3")));
  EXPECT_THAT(mistakes(study, {"setting[3].stones.count=3"}),
              ElementsAre(HasSubstr("--set setting[3].stones.count: expected one of the settings, "
                                    "counted from setting[0], found setting[3]")));
}

TEST_F(StudyTest, has_seeds_that_a_scene_can_have) {
  const std::string study = sound;
  const auto with = [&](const std::string& seeds) {
    return mistakes(std::string(study).replace(study.find("[1, 2]"), 6, seeds));
  };
  for (const std::string seeds : {"[1.5, -2]", "[3000000000]", "[1e300]", "[-1]"})
    EXPECT_THAT(with(seeds), ElementsAre(HasSubstr(":4:9: expected for study.seeds whole numbers "
                                                   "from 0 to 2147483647, found ")))
        << seeds;
  EXPECT_THAT(with("3"), ElementsAre(HasSubstr(":4:9: expected for study.seeds a list of numbers, "
                                               "found 3; write for example seeds = [1, 2, 3]")));
  EXPECT_THAT(with("[]"), ElementsAre(HasSubstr("a list of numbers, found []")));
  EXPECT_THAT(with("[0, 2147483647]"), ElementsAre());
}

TEST_F(StudyTest, has_its_seeds_in_one_place) {
  EXPECT_THAT(
      mistakes(std::string(sound) + "run.seed = 7\n", {"base.run.seed=3"}),
      ElementsAre("--set base.run.seed: expected all seeds in study.seeds, found run.seed = "
                  "3; remove it, every setting runs with the same seeds",
                  HasSubstr(":14:5: expected all seeds in study.seeds, found run.seed = 7")));
}

TEST_F(StudyTest, has_a_folder_of_its_own_for_every_setting) {
  const std::string study = sound;
  for (const std::string name : {".", "..", ","})
    EXPECT_THAT(mistakes(study + "[[setting]]\nname = \"" + name + "\"\n"),
                ElementsAre(HasSubstr(":15:8: expected a name that a folder can have")))
        << name;
  EXPECT_THAT(
      mistakes(study + "[[setting]]\nname = \"rigid,/steel\"\n"),
      ElementsAre(HasSubstr(":15:8: expected a name whose folder, rigid_steel, none above")));
}

TEST_F(StudyTest, knows_a_run_by_all_of_its_scene) {
  const std::string base = files_.write("base.toml", "[stones]\ngradation = \"sieves.csv\"\n");
  const std::string scene =
      files_.write("whole.toml", "include = \"base.toml\"\n[run]\nseed = 1\n");
  files_.write("sieves.csv", "11.2, 100\n");
  const std::string before = all_of_scene(scene, {});
  EXPECT_EQ(all_of_scene(scene, {}), before);
  EXPECT_NE(all_of_scene(scene, {"run.seed=2"}), before);
  EXPECT_NE(all_of_scene(scene, {"mould.elastic={}"}), before);
  files_.write("whole.toml", "include = \"base.toml\"\n[run]\nseed = 1\n[mould.elastic]\n");
  EXPECT_NE(all_of_scene(scene, {}), before);
  files_.write("whole.toml", "include = \"base.toml\"\n[run]\nseed = 1\n");
  EXPECT_EQ(all_of_scene(scene, {}), before);
  files_.write("sieves.csv", "11.2, 95\n");
  EXPECT_NE(all_of_scene(scene, {}), before);
  files_.write("sieves.csv", "11.2, 100\n");
  files_.write("base.toml", "[stones]\ngradation = \"sieves.csv\"\nyoung = \"1 GPa\"\n");
  EXPECT_NE(all_of_scene(scene, {}), before);
}

TEST(study_errors, are_means_of_pairs_over_the_size_of_the_reference) {
  // Closed form: differences 3 and 1, size 10: error 0.2; deviation sqrt(2), noise t / sqrt(2) of
  // it, with t of one degree of freedom from a table.
  const BySeed reference = {{1, {9}}, {2, {11}}};
  const Judgement j = judge({{1, {12}}, {2, {12}}}, reference, 0);
  EXPECT_TRUE(j.known);
  EXPECT_NEAR(j.error, 0.2, 1e-15);
  EXPECT_NEAR(j.noise, 12.7062 / 10, 1e-5);
  EXPECT_EQ(j.sign, 1);
  EXPECT_FALSE(j.beyond());
  EXPECT_EQ(judge({{1, {5}}, {2, {6}}}, reference, 0).sign, -1);
}

TEST(study_errors, that_all_seeds_share_are_told_however_these_scatter) {
  const Judgement j = judge({{1, {1.5}}, {2, {20.5}}}, {{1, {1}}, {2, {20}}}, 0);
  EXPECT_EQ(j.noise, 0);
  EXPECT_TRUE(j.beyond());
  EXPECT_GT(scatter({{1, {1}}, {2, {20}}}, 0).noise, 1);
}

TEST(study_errors, count_the_seeds_that_both_have) {
  // By definition: the third seed of the reference has no partner, nor the fourth of the setting.
  const BySeed reference = {{1, {10}}, {2, {10}}, {3, {1000}}};
  EXPECT_NEAR(judge({{1, {11}}, {2, {11}}, {4, {0}}}, reference, 0).error, 0.1, 1e-15);
  EXPECT_FALSE(judge({{1, {11}}, {4, {0}}}, reference, 0).known);
}

TEST(study_errors, do_not_lie_in_one_seed) {
  // One stone that breaks in one of six runs is chance, though it breaks in none of the reference.
  BySeed none, one;
  for (int seed = 1; seed <= 6; ++seed) none[seed] = one[seed] = {0};
  one[3] = {1};
  EXPECT_NEAR(judge(one, none, 1).error, 1.0 / 6, 1e-15);
  EXPECT_FALSE(judge(one, none, 1).beyond());
}

TEST(study_errors, of_what_no_run_has_are_at_most_three_per_run_over_their_number) {
  // Poisson: what happens 3 / n times in a run stays away from n runs in exp(-3) of the cases.
  BySeed none, one;
  for (int seed = 1; seed <= 6; ++seed) none[seed] = one[seed] = {0};
  one[3] = {1};
  for (const Judgement& j : {judge(none, none, 2), scatter(none, 2)}) {
    EXPECT_EQ(j.none_in, 6);
    EXPECT_NEAR(j.noise, 3.0 / 6 / 2, 1e-15);
    EXPECT_FALSE(j.beyond());
  }
  EXPECT_EQ(judge(one, none, 1).none_in, 0);
  EXPECT_EQ(judge(one, one, 1).none_in, 0);
  EXPECT_EQ(scatter(one, 1).none_in, 0);
}

TEST(study_errors, of_chance_alone_stay_inside_the_noise_in_19_of_20_cases) {
  // 4000 studies of five seeds of normal numbers; the share scatters by 0.0034.
  std::mt19937 random(7);
  std::normal_distribution<double> normal(10, 1);
  const auto runs = [&] {
    BySeed found;
    for (int seed = 1; seed <= 5; ++seed) found[seed] = {normal(random)};
    return found;
  };
  int beyond = 0;
  for (int k = 0; k < 4000; ++k) beyond += judge(runs(), runs(), 0).beyond();
  EXPECT_NEAR(beyond / 4000.0, 0.05, 0.012);
}

TEST(study_errors, of_chance_alone_scatter_as_the_reference_says) {
  // Closed form: t of ten degrees of freedom x sqrt(2 / 6) x the deviation 1, over the mean 10.
  BySeed reference;
  for (int seed = 1; seed <= 6; ++seed)
    reference[seed] = {10 + std::sqrt(5.0 / 6) * (seed % 2 ? 1 : -1)};
  EXPECT_NEAR(scatter(reference, 0).noise, 2.22814 * std::sqrt(2.0 / 6) / 10, 1e-6);
}

TEST(study_errors, of_curves_are_rms_over_their_points) {
  // Closed form: differences 3 and 4, reference 5 and 5.
  const Judgement j = judge({{1, {8, 9}}, {2, {8, 9}}}, {{1, {5, 5}}, {2, {5, 5}}}, 0);
  EXPECT_NEAR(j.error, std::sqrt(12.5) / 5, 1e-15);
  EXPECT_EQ(j.noise, 0);
  EXPECT_EQ(j.sign, 0);
  EXPECT_TRUE(j.beyond());
}

TEST(study_errors, are_told_in_parts_of_the_least_size_where_the_reference_is_small) {
  // Two broken stones more than none are two, not infinitely many times more.
  EXPECT_EQ(judge({{1, {2}}, {2, {2}}}, {{1, {0}}, {2, {0}}}, 1).error, 2);
}

TEST(study_errors, are_unknown_without_scatter_or_result) {
  EXPECT_FALSE(judge({{1, {1}}}, {{1, {1}}}, 0).known);
  EXPECT_FALSE(judge({}, {{1, {1}}, {2, {2}}}, 0).known);
  EXPECT_FALSE(judge({{1, {}}, {2, {}}}, {{1, {1}}, {2, {2}}}, 0).known);
  EXPECT_FALSE(judge({{1, {}}, {2, {}}}, {{1, {}}, {2, {}}}, 0).known);
  EXPECT_FALSE(judge({{1, {1}}, {2, {2}}, {3, {}}}, {{1, {1}}, {2, {2}}, {3, {3}}}, 0).known);
  EXPECT_FALSE(scatter({{1, {1}}}, 0).known);
}

class StudyResults : public tests::RecorderTest {};

TEST_F(StudyResults, have_the_slope_over_a_logarithm_beyond_the_first_half_unit) {
  // By construction: 3 per decade beyond 0.5, something else before; 1e-4 for the straight lines
  // between rows.
  const Interest interest = {"gyration", {{"slope", "density", Quantity::per_decade, 1}}};
  Recorder recorder(file(), tests::provenance(), {{"gyration", "1"}, {"density", "1"}});
  for (int k = 0; k < 400; ++k) {
    const double gyration = 0.01 * k;
    recorder.append({{gyration, gyration > 0.5 ? 7 + 3 * std::log10(gyration) : -100}});
  }
  recorder.flush();
  const Found found = read_found(file(), interest);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].size(), 1u);
  EXPECT_NEAR(found[0][0], 3, 1e-4);
}

TEST_F(StudyResults, weigh_every_part_of_a_decade_alike) {
  // By construction: a curve through (1, 0), (10, 1), (100, 4), straight between them over the
  // logarithm, has by least squares over its decades the slope 2; by rows, of which nine tenths lie
  // in its second decade, one near 3.
  const Interest interest = {"gyration", {{"slope", "density", Quantity::per_decade, 1}}};
  Recorder recorder(file(), tests::provenance(), {{"gyration", "1"}, {"density", "1"}});
  for (int k = 100; k <= 10000; ++k) {
    const double decades = std::log10(0.01 * k);
    recorder.append({{0.01 * k, decades < 1 ? decades : 3 * decades - 2}});
  }
  recorder.flush();
  EXPECT_NEAR(read_found(file(), interest)[0][0], 2, 1e-3);
}

}  // namespace
}  // namespace apps
