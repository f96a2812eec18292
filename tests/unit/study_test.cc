#include "apps/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/study_runs.h"
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

}  // namespace
}  // namespace apps
