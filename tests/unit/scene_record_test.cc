#include "apps/scene_record.h"

#include "tests/unit/scene_fixture.h"

namespace {

using testing::HasSubstr;
using testing::Not;
using SceneRecord = tests::SceneTest;
using tests::least;

TEST_F(SceneRecord, read_again_is_the_same_scene_to_the_last_bit) {
  // 0.1 deg and 1/3 m have no short decimals in SI: the record must carry all their digits.
  files_.write("gradation.csv", tests::sieves);
  const auto scene = read(least, {"gyration.angle=0.1 deg", "gyration.pressure=0.3333333333 MPa",
                                  "stones.fracture={}", "stones.restitution=0.3",
                                  "mould.elastic={}", "numerics.mass_scale=12345.678901234567"});
  const std::string record = apps::complete_scene(scene);
  const auto again = read(record);
  EXPECT_EQ(apps::complete_scene(again), record);
  EXPECT_EQ(again.gyration.angle, scene.gyration.angle);
  EXPECT_EQ(again.gyration.pressure, scene.gyration.pressure);
  EXPECT_EQ(again.numerics.mass_scale, scene.numerics.mass_scale);
  EXPECT_EQ(again.binder->alpha, scene.binder->alpha);
  EXPECT_EQ(again.stones.sieves.passing, scene.stones.sieves.passing);
  EXPECT_EQ(again.stones.restitution, scene.stones.restitution);
  EXPECT_TRUE(again.stones.fracture && again.mould.elastic);
  EXPECT_FALSE(again.head.elastic);
}

TEST_F(SceneRecord, of_a_binder_of_its_own_keeps_its_lists) {
  files_.write("gradation.csv", tests::sieves);
  const auto scene =
      read(least, {"binder.temperature=none", "binder.shear_modulus=2 MPa",
                   "binder.alpha=[0.2, 0.3, 0.5]", "binder.tau=[\"100 ms\", 1, \"2 min\"]"});
  const auto again = read(apps::complete_scene(scene));
  EXPECT_EQ(again.binder->tau, scene.binder->tau);
  EXPECT_EQ(again.binder->shear_modulus, scene.binder->shear_modulus);
}

TEST_F(SceneRecord, names_every_default_and_no_absent_section) {
  const std::string record = apps::complete_scene(read(least));
  EXPECT_THAT(record, HasSubstr("\nmass_scale = 1000\n"));
  EXPECT_THAT(record, HasSubstr("\ngradation = \"gradation.csv\"\n"));
  EXPECT_THAT(record, Not(HasSubstr("[mould.elastic]")));
  EXPECT_THAT(record, Not(HasSubstr("restitution")));
}

}  // namespace
