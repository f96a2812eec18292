#include "apps/checkpoint.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <random>

#include "apps/errors.h"
#include "apps/text.h"
#include "tests/unit/written_file.h"

namespace {

using apps::Archive;
using apps::Checkpoints;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// One of every kind of item.
struct Thing {
  double number = 0;
  std::vector<double> list;
  std::vector<std::vector<double>> rows;
  std::string text;
  std::optional<double> perhaps;
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(3);

  void visit_state(Archive& item) {
    item("number", number);
    item("list", list);
    item("rows", rows);
    item("text", text);
    item("perhaps", perhaps);
    item("vector", vector);
  }
};

Thing thing(double number) {
  return {number, {1, -0.0, 3e300}, {{1, 2}, {3, 4}}, "stone 3", 0.1, Eigen::Vector3d(1, 2, 3)};
}

Archive archive_of(Thing it) {
  Archive archive;
  it.visit_state(archive);
  return archive;
}

class CheckpointTest : public testing::Test {
 protected:
  CheckpointTest() { files_.write("run/lock", ""); }

  std::string newest_file() const { return files_.path("run/checkpoint"); }
  std::string older_file() const { return files_.path("run/checkpoint.older"); }
  static std::string content(const std::string& path) { return apps::read_text(path).value(); }

  // The number in the newest checkpoint that is taken, 0 without one; what was told is in told_.
  double taken(const Checkpoints& checkpoints) {
    told_.clear();
    auto archive = checkpoints.newest([&](const std::string& line) { told_.push_back(line); });
    if (!archive) return 0;
    Thing it;
    it.visit_state(*archive);
    return it.number;
  }

  tests::WrittenFiles files_;
  Checkpoints checkpoints_{files_.path("run"), {"[run]\nseed = 1\n", "2,25\n"}};
  std::vector<std::string> told_;
};

TEST_F(CheckpointTest, gives_back_every_item_bit_by_bit) {
  // In and out are inverse, whatever the kind of item.
  checkpoints_.write(archive_of(thing(7)));
  auto archive = checkpoints_.newest([](const std::string&) { FAIL(); });
  ASSERT_TRUE(archive);
  Thing it;
  it.visit_state(*archive);
  EXPECT_EQ(archive_of(it).bytes(), archive_of(thing(7)).bytes());
  EXPECT_EQ(it.rows, thing(7).rows);
  EXPECT_TRUE(std::signbit(it.list[1]));
}

TEST_F(CheckpointTest, keeps_two_generations) {
  EXPECT_EQ(taken(checkpoints_), 0);
  for (double number : {1, 2, 3}) checkpoints_.write(archive_of(thing(number)));
  EXPECT_EQ(taken(checkpoints_), 3);
  std::filesystem::remove(newest_file());
  EXPECT_EQ(taken(checkpoints_), 2);
  EXPECT_THAT(told_, IsEmpty());
}

TEST_F(CheckpointTest, any_flipped_bit_is_noticed_and_the_older_one_taken) {
  // Every step of FNV-1a is one to one, so that no single wrong byte goes unseen.
  checkpoints_.write(archive_of(thing(1)));
  checkpoints_.write(archive_of(thing(2)));
  const std::string sound = content(newest_file());
  for (std::size_t bit = 0; bit < 8 * sound.size(); ++bit) {
    std::string damaged = sound;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    files_.write("run/checkpoint", damaged);
    ASSERT_EQ(taken(checkpoints_), 1) << "bit " << bit;
    ASSERT_THAT(told_, ElementsAre(HasSubstr("checkpoint: not taken, it "))) << "bit " << bit;
  }
}

TEST_F(CheckpointTest, any_shorter_file_is_noticed_and_the_older_one_taken) {
  checkpoints_.write(archive_of(thing(1)));
  checkpoints_.write(archive_of(thing(2)));
  const std::string sound = content(newest_file());
  for (std::size_t size = 0; size < sound.size(); ++size) {
    files_.write("run/checkpoint", sound.substr(0, size));
    ASSERT_EQ(taken(checkpoints_), 1) << size << " bytes";
  }
}

TEST_F(CheckpointTest, a_damaged_one_never_takes_the_place_of_a_sound_one) {
  checkpoints_.write(archive_of(thing(1)));
  checkpoints_.write(archive_of(thing(2)));
  files_.write("run/checkpoint", "rubbish");
  EXPECT_EQ(taken(checkpoints_), 1);
  checkpoints_.write(archive_of(thing(3)));
  std::filesystem::remove(newest_file());
  EXPECT_EQ(taken(checkpoints_), 1);
}

TEST_F(CheckpointTest, of_another_scene_is_refused_with_the_line_that_differs) {
  Checkpoints other(files_.path("run"), {"[run]\nseed = 2\n", "2,25\n"});
  other.write(archive_of(thing(1)));
  EXPECT_THROW(taken(checkpoints_), apps::OutputError);
  EXPECT_THAT(told_, ElementsAre(HasSubstr("of another scene, with \"seed = 2\"")));
  EXPECT_EQ(taken(other), 1);
}

TEST_F(CheckpointTest, a_full_disk_keeps_what_is_there) {
  // setrlimit(2): writing beyond the limit fails as it does without space.
  checkpoints_.write(archive_of(thing(1)));
  checkpoints_.write(archive_of(thing(2)));
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit full{100, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(checkpoints_.write(archive_of(thing(3))), apps::OutputError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(taken(checkpoints_), 2);
  std::filesystem::remove(newest_file());
  EXPECT_EQ(taken(checkpoints_), 1);
}

TEST_F(CheckpointTest, that_does_not_fit_the_run_says_which_item) {
  checkpoints_.write(archive_of(thing(1)));
  auto archive = checkpoints_.newest([](const std::string&) { FAIL(); });
  double unknown = 0;
  float number = 0;
  try {
    (*archive)("unknown", unknown);
    FAIL();
  } catch (const apps::Unfit& reason) {
    EXPECT_STREQ(reason.what(), "it holds no \"unknown\"");
  }
  EXPECT_THROW((*archive)("number", number), apps::Unfit);
}

}  // namespace
