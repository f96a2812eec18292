#include "apps/laws.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/scene_fixture.h"

namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using tests::least;

using LawBook = tests::SceneTest;

// What no law is there for, of a scene that can be read.
std::vector<std::string> lawless(const apps::GyratoryScene& scene, const apps::Mix& mix) {
  try {
    apps::LawBook(scene.stones, scene.binder, mix).check(scene.source);
  } catch (const apps::InputError& error) {
    return error.mistakes;
  }
  return {};
}

TEST_F(LawBook, refuses_shells_thicker_than_the_smallest_stone) {
  // sections.h; so much bitumen that spheres could not hold it.
  const apps::GyratoryScene scene = read(least, {"binder.content=60 %"});
  const apps::Mix mix = apps::prepare_mix(scene.stones, scene.binder, scene.run.seed);
  ASSERT_GT(mix.shell, apps::thickest_shell * mix.smallest_radius());
  EXPECT_THAT(lawless(scene, mix), ElementsAre(AllOf(StartsWith("--set binder.content: expected"),
                                                     HasSubstr("smallest stone"))));
}

TEST_F(LawBook, refuses_films_in_rings_that_relax_in_more_than_two_terms) {
  // apps/laws.h: there is no law for them.
  const auto scene = [&](const std::string& alpha, const std::string& tau) {
    return read(least, {"binder.temperature=none", "binder.shear_modulus=2 MPa",
                        "binder.film=rings", "binder.alpha=" + alpha, "binder.tau=" + tau});
  };
  const apps::GyratoryScene two = scene("[0.7, 0.3]", "[1, 2]");
  const apps::GyratoryScene three = scene("[0.7, 0.2, 0.1]", "[1, 2, 3]");
  const apps::Mix mix = apps::prepare_mix(two.stones, two.binder, two.run.seed);
  EXPECT_THAT(lawless(two, mix), IsEmpty());
  EXPECT_THAT(lawless(three, mix),
              ElementsAre(AllOf(StartsWith("--set binder.film: expected at most 2 Prony terms"),
                                HasSubstr("found 3"))));
}

}  // namespace
