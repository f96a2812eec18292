#include "dem/integrator.h"

#include <gtest/gtest.h>

#include <limits>

#include "dem/trouble.h"

namespace dem {
namespace {

TEST(trouble, the_first_stone_that_is_nowhere_is_named) {
  // By definition, for position, velocity and spin.
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto stones = [] {
    return make_stones({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {0.1, 0.1, 0.1}, {2650}, 1);
  };
  EXPECT_NO_THROW(stop_at_first_not_finite(stones(), 0));
  const auto stone_named = [](const ParticleStore& stones) {
    try {
      stop_at_first_not_finite(stones, 1.5);
    } catch (const NumericalTrouble& trouble) {
      EXPECT_EQ(trouble.time, 1.5);
      return static_cast<int>(trouble.stone);
    }
    return -1;
  };
  ParticleStore lost = stones();
  lost.spin[2].y = nan;
  EXPECT_EQ(stone_named(lost), 2);
  lost.velocity[1].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(stone_named(lost), 1);
  lost.position[0].z = nan;
  EXPECT_EQ(stone_named(lost), 0);
}

}  // namespace
}  // namespace dem
