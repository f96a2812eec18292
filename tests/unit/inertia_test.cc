// Inertia given to those stones only that need it.
#include <gtest/gtest.h>

#include <numeric>

#include "apps/bed.h"

namespace {

using Law = dem::Mindlin<>;
constexpr Law law = {{3.8e10}, 8e9, 0.7};

dem::ParticleStore stones(double scale) {
  return dem::make_stones({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {1e-3, 2e-3, 8e-3}, 2650, 0, scale);
}

TEST(selective_mass, leaves_every_stone_what_the_common_step_needs) {
  // From dt = sqrt(m / k) with k ~ R at equal overlap / R, dt ~ R without scaling: inertia ~ R.
  dem::ParticleStore uniform = stones(1e4), selective = stones(1e4);
  apps::select_inertia(law, selective);
  const double step = apps::largest_step(law, uniform, 0.2);
  EXPECT_NEAR(apps::largest_step(law, selective, 0.2), step, 1e-12 * step);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(selective.inertia[k] / selective.inertia[0], selective.radius[k] / 1e-3, 1e-9);
  // Masses 1, 8, 512, of which inertia 1, 2, 8 is left.
  EXPECT_NEAR(dem::mean_inertia_scale(selective) / dem::mean_inertia_scale(uniform), 11.0 / 521,
              1e-9);
}

TEST(selective_mass, never_takes_true_mass) {
  // By definition. Scaled by 9 the stone of 1 mm allows three times its own step, less than that
  // of 8 mm has by itself.
  dem::ParticleStore few = stones(9);
  apps::select_inertia(law, few);
  EXPECT_NEAR(few.inertia[0], 9 * few.mass[0], 1e-12 * few.inertia[0]);
  EXPECT_NEAR(few.inertia[1], 2.25 * few.mass[1], 1e-9 * few.inertia[1]);
  EXPECT_EQ(few.inertia[2], few.mass[2]);
}

}  // namespace
