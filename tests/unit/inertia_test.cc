// Inertia given to those stones only that need it.
#include <gtest/gtest.h>

#include <numeric>

#include "apps/bed.h"

namespace {

using Law = dem::Mindlin<>;
constexpr Law law = {{3.8e10}, 8e9, 0.7};

dem::ParticleStore stones(double scale) {
  return dem::make_stones({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {1e-3, 2e-3, 8e-3}, {2650}, scale);
}

TEST(selective_mass, leaves_every_stone_what_the_common_step_needs) {
  // Against one like itself k ~ R at equal overlap / R, so inertia ~ R would do; of stones of 1 mm
  // ((1 mm + R) / 2 mm)^2 times as many find room around one of R, which asks for more.
  dem::ParticleStore uniform = stones(1e4), selective = stones(1e4);
  selective.inertia = apps::selected_inertia(law, selective);
  const double step = apps::largest_step(law, uniform, 0.2);
  EXPECT_NEAR(apps::largest_step(law, selective, 0.2), step, 1e-12 * step);
  EXPECT_NEAR(selective.inertia[1] / selective.inertia[0], 2.25, 1e-9);
  EXPECT_NEAR(selective.inertia[2] / selective.inertia[0], 20.25, 1e-9);
  // Masses 1, 8, 512, of which inertia 1, 2.25, 20.25 is left.
  EXPECT_NEAR(dem::mean_inertia_scale(selective) / dem::mean_inertia_scale(uniform), 23.5 / 521,
              1e-9);
}

TEST(selective_mass, never_takes_true_mass) {
  // By definition. Scaled by 9 the stone of 1 mm has the inertia of nine; around that of 8 mm 20
  // times as many find room, 182 of its 512 masses.
  dem::ParticleStore few = stones(9);
  few.inertia = apps::selected_inertia(law, few);
  EXPECT_NEAR(few.inertia[0], 9 * few.mass[0], 1e-12 * few.inertia[0]);
  EXPECT_NEAR(few.inertia[1], 2.25 * few.inertia[0], 1e-9 * few.inertia[1]);
  EXPECT_EQ(few.inertia[2], few.mass[2]);
}

}  // namespace
