// Sets of fidelity and faster processes.
#include "apps/fidelity.h"

#include "tests/unit/scene_fixture.h"

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Fidelity = tests::SceneTest;

TEST_F(Fidelity, gives_defaults_and_the_keys_of_the_scene_hold) {
  const std::string least = tests::least;
  const auto standard = read(least), named = read(least + "[run]\nfidelity = \"standard\"\n");
  const auto draft = read(least + "[run]\nfidelity = \"draft\"\n[numerics]\nsafety = 0.15\n");
  const auto reference = read(least + "[run]\nfidelity = \"reference\"\n[mould.elastic]\n");
  EXPECT_EQ(named.numerics.mass_scale, standard.numerics.mass_scale);
  EXPECT_GT(read(least + "[run]\nfidelity = \"draft\"\n").numerics.safety,
            standard.numerics.safety);
  EXPECT_EQ(draft.numerics.safety, 0.15);
  EXPECT_FALSE(draft.mould.elastic);
  EXPECT_TRUE(standard.numerics.selective_mass);
  EXPECT_FALSE(draft.numerics.selective_mass);
  EXPECT_GT(draft.numerics.mass_scale, standard.numerics.mass_scale);
  EXPECT_LT(reference.numerics.mass_scale, standard.numerics.mass_scale);
  EXPECT_FALSE(reference.numerics.selective_mass);
  EXPECT_FALSE(apps::FlowTestScene{}.numerics.selective_mass);
  EXPECT_GT(apps::FlowTestScene{}.numerics.mass_scale, standard.numerics.mass_scale);
  ASSERT_TRUE(reference.mould.elastic);
  EXPECT_GT(reference.mould.elastic->modes, apps::ElasticMouldScene{}.modes);
  EXPECT_FALSE(reference.head.elastic);
}

TEST_F(Fidelity, that_nobody_knows_is_a_mistake) {
  EXPECT_THAT(mistakes(std::string(tests::least) + "[run]\nfidelity = \"best\"\n"),
              ElementsAre(HasSubstr(":11:12: expected")));
}

TEST_F(Fidelity, of_compressed_time_runs_machine_and_binder_faster) {
  // By definition: k times the speed, 1 / k of every time.
  const auto asked =
      read(std::string(tests::least) +
           "[numerics]\ntime_compression = 4\n[output]\npicture_interval = \"2 s\"\n");
  const apps::GyratoryScene faster = apps::compressed(asked);
  EXPECT_EQ(faster.gyration.speed, 4 * asked.gyration.speed);
  EXPECT_EQ(faster.gyration.ramp, asked.gyration.ramp / 4);
  EXPECT_EQ(faster.output.history_interval, asked.output.history_interval / 4);
  EXPECT_EQ(faster.output.picture_interval, 0.5);
  ASSERT_EQ(faster.binder->tau.size(), asked.binder->tau.size());
  for (std::size_t i = 0; i < faster.binder->tau.size(); ++i)
    EXPECT_EQ(faster.binder->tau[i], asked.binder->tau[i] / 4);
  EXPECT_EQ(faster.binder->shear_modulus, asked.binder->shear_modulus);
}

}  // namespace
