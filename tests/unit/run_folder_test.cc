#include "apps/run_folder.h"

#include "apps/scene_record.h"
#include "apps/text.h"
#include "tests/unit/scene_fixture.h"

namespace {

using testing::HasSubstr;

constexpr const char* somebodys = "somebody's";

class RunFolderTest : public tests::SceneTest {
 protected:
  // What the folder `name` is refused with; empty where a run begins in it.
  std::string refusal(const std::string& name, bool overwrite) const {
    try {
      const apps::RunFolder begun(files_.path(name), scene_, overwrite);
    } catch (const apps::OutputError& error) {
      return error.what();
    }
    return "";
  }

  std::string content(const std::string& name) const {
    return apps::read_text(files_.path(name)).value_or("none");
  }

  const apps::StoredScene scene_ = {apps::complete_scene(read(tests::least)), tests::sieves};
};

TEST_F(RunFolderTest, a_run_is_known_by_any_of_its_files_and_replaced_only_when_asked) {
  for (const std::string name :
       {"results.h5", "summary.json", "checkpoint", "checkpoint.older", "scene.toml"}) {
    const std::string folder = "of_" + name;
    const bool is_scene = name == apps::stored_scene_file;
    files_.write(folder + '/' + name, is_scene ? scene_.text + "# older\n" : "older");
    files_.write(folder + "/gradation.csv", "older");
    files_.write(folder + "/notes.txt", somebodys);
    EXPECT_THAT(refusal(folder, false), HasSubstr("without a run, found one")) << name;
    EXPECT_EQ(content(folder + "/gradation.csv"), "older") << name;
    EXPECT_EQ(refusal(folder, true), "") << name;
    EXPECT_EQ(content(folder + '/' + name), is_scene ? scene_.text : "none") << name;
    EXPECT_EQ(content(folder + "/gradation.csv"), scene_.gradation) << name;
    EXPECT_EQ(content(folder + "/notes.txt"), somebodys) << name;
  }
}

TEST_F(RunFolderTest, a_scene_or_a_table_of_somebody_else_is_never_replaced) {
  files_.write("beside/results.h5", "of a run");
  for (const std::string file : {"own/scene.toml", "beside/scene.toml", "table/gradation.csv"}) {
    files_.write(file, somebodys);
    const auto slash = file.find('/');
    for (const bool overwrite : {false, true}) {
      EXPECT_THAT(refusal(file.substr(0, slash), overwrite),
                  HasSubstr("without a " + file.substr(slash + 1) + " that is not of a run"));
      EXPECT_EQ(content(file), somebodys);
    }
  }
  EXPECT_EQ(content("beside/results.h5"), "of a run");
}

TEST_F(RunFolderTest, a_run_begins_again_where_it_was_killed_before_it_had_its_scene) {
  files_.write("run/gradation.csv", scene_.gradation);
  EXPECT_EQ(refusal("run", false), "");
  EXPECT_EQ(content("run/scene.toml"), scene_.text);
}

}  // namespace
