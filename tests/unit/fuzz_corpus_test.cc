// What the fuzzers have found worth keeping, and the scenes of the house, read once more.
#include <gtest/gtest.h>

#include "apps/text.h"
#include "tests/fuzz/readers.h"

namespace {

using Feed = void (*)(std::string_view, const tests::Place&);

int fed(const std::string& folder, Feed feed) {
  const tests::Place place;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    feed(apps::read_text(entry.path().string()).value(), place);
    ++count;
  }
  return count;
}

TEST(fuzz_corpus, of_scenes_is_taken_or_refused_with_its_mistakes) {
  EXPECT_GT(fed(FUZZ_CORPUS "/scene", tests::feed_scene), 0);
  EXPECT_GT(fed(SCENES_FOLDER, tests::feed_scene), 0);
}

TEST(fuzz_corpus, of_options_is_taken_or_refused_with_its_mistakes) {
  EXPECT_GT(fed(FUZZ_CORPUS "/option", tests::feed_option), 0);
}

TEST(fuzz_corpus, of_gradations_is_taken_or_refused_with_its_mistakes) {
  EXPECT_GT(fed(FUZZ_CORPUS "/gradation", tests::feed_gradation), 0);
  EXPECT_GT(fed(SCENES_FOLDER "/gradations", tests::feed_gradation), 0);
}

TEST(fuzz_corpus, of_paths_is_taken_or_refused_with_its_mistakes) {
  EXPECT_GT(fed(FUZZ_CORPUS "/path", tests::feed_path), 0);
  EXPECT_GT(fed(SCENES_FOLDER "/paths", tests::feed_path), 0);
}

}  // namespace
