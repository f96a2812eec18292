#include "dem/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "dem/gradation.h"

namespace dem {
namespace {

// SMA 11 stones with a shell of 0.5 mm.
std::vector<double> outer_radii(int count) {
  const SieveTable sma = {{2e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3}, {0.25, 0.40, 0.575, 0.95, 1}};
  std::vector<double> radii = draw_diameters(log_linear(sma, 2e-3), count, 1);
  for (double& r : radii) r = r / 2 + 0.5e-3;
  return radii;
}

double volume(const std::vector<double>& radii) {
  double sum = 0;
  for (const double r : radii) sum += 4 * std::numbers::pi / 3 * r * r * r;
  return sum;
}

bool all_apart(const std::vector<double>& radii, const Gas& gas) {
  for (std::size_t i = 0; i < radii.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = norm(gas.position[i] - gas.position[j]);
      if (distance <= radii[i] + radii[j]) return false;
    }
  }
  return true;
}

TEST(packing, stones_touch_neither_each_other_nor_a_round_mould) {
  // From the definition, checked pair by pair.
  const std::vector<double> radii = outer_radii(5000);
  const double mould = 0.05;
  const Gas gas = pack_gas(radii, RoundMould{mould}, 0.30, 1);
  EXPECT_TRUE(all_apart(radii, gas));
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const Vec3d& p = gas.position[k];
    ASSERT_LE(std::hypot(p.x, p.y) + radii[k], mould * (1 + 1e-15));
    ASSERT_GE(p.z, radii[k]);
    ASSERT_LE(p.z + radii[k], gas.height * (1 + 1e-15));
  }
}

TEST(packing, stones_touch_neither_each_other_nor_a_box) {
  // From the definition, checked pair by pair.
  const std::vector<double> radii = outer_radii(3000);
  const Gas gas = pack_gas(radii, RectangularMould{0.15, 0.10}, 0.30, 1);
  EXPECT_TRUE(all_apart(radii, gas));
  for (std::size_t k = 0; k < radii.size(); ++k) {
    const Vec3d& p = gas.position[k];
    ASSERT_GE(std::min({p.x, p.y, p.z}), radii[k]);
    ASSERT_LE(p.x + radii[k], 0.15 * (1 + 1e-15));
    ASSERT_LE(p.y + radii[k], 0.10 * (1 + 1e-15));
    ASSERT_LE(p.z + radii[k], gas.height * (1 + 1e-15));
  }
}

TEST(packing, the_height_is_that_of_the_wanted_density) {
  // Closed form: height = volume of the outer spheres / (density x cross section).
  const std::vector<double> radii = outer_radii(5000);
  const double mould = 0.05;
  for (const double density : {0.01, 0.10, 0.30}) {
    const Gas gas = pack_gas(radii, RoundMould{mould}, density, 1);
    const double height = volume(radii) / (density * std::numbers::pi * mould * mould);
    EXPECT_NEAR(gas.height / height, 1, 1e-12);
  }
}

TEST(packing, a_thin_gas_fills_the_mould_evenly) {
  // Closed form: of places uniform in a cylinder, z / height and (r / R)^2 are uniform in (0, 1),
  // so that the means of 5000 scatter by 1 / sqrt(12 x 5000); x / 2R and y / 2R scatter less.
  const double mould = 0.05, radius = 0.5e-3;
  const Gas gas = pack_gas(std::vector<double>(5000, radius), RoundMould{mould}, 0.01, 1);
  const double width = mould - radius;
  Vec3d sum = {0, 0, 0};
  double squares = 0;
  for (const Vec3d& p : gas.position) {
    sum += p;
    squares += (p.x * p.x + p.y * p.y) / (width * width);
  }
  const double four_deviations = 4 / std::sqrt(12.0 * 5000);
  EXPECT_NEAR(sum.z / 5000 / gas.height, 0.5, four_deviations);
  EXPECT_NEAR(squares / 5000, 0.5, four_deviations);
  EXPECT_NEAR(sum.x / 5000 / (2 * width), 0, four_deviations);
  EXPECT_NEAR(sum.y / 5000 / (2 * width), 0, four_deviations);
}

TEST(packing, a_gas_too_dense_for_random_addition_grows_in_steps_of_five_percent) {
  // Equal spheres added at random jam at 38 % (Torquato, Uche, Stillinger (2006)).
  const std::vector<double> radii(1000, 2e-3);
  const Gas gas = pack_gas(radii, RectangularMould{0.06, 0.06}, 0.60, 1);
  EXPECT_TRUE(all_apart(radii, gas));
  const double growth = gas.height / (volume(radii) / (0.60 * 0.06 * 0.06));
  const double steps = std::log(growth) / std::log(1.05);
  EXPECT_NEAR(steps, std::round(steps), 1e-9);
  EXPECT_GT(growth, 0.60 / 0.385);
}

TEST(packing, the_seed_alone_decides_the_places) {
  // From the promise: same seed, same bits.
  const std::vector<double> radii = outer_radii(500);
  const Gas gas = pack_gas(radii, RoundMould{0.05}, 0.30, 1);
  const Gas same = pack_gas(radii, RoundMould{0.05}, 0.30, 1);
  const Gas other = pack_gas(radii, RoundMould{0.05}, 0.30, 2);
  for (std::size_t k = 0; k < radii.size(); ++k) {
    ASSERT_EQ(norm(gas.position[k] - same.position[k]), 0);
    ASSERT_NE(norm(gas.position[k] - other.position[k]), 0);
  }
}

TEST(packing, a_single_stone_gets_room_above_the_wanted_density) {
  // The limit of the definition: never lower than the largest stone.
  const Gas gas = pack_gas(std::vector<double>{0.01}, RoundMould{0.1}, 0.30, 1);
  EXPECT_EQ(gas.height, 0.02);
  EXPECT_NEAR(gas.position[0].z, 0.01, 1e-15);
}

TEST(packing, a_stone_wider_than_the_mould_is_refused) {
  // From the contract: it would never find a place.
  const std::vector<double> radii = {1e-3, 20e-3};
  EXPECT_THROW(pack_gas(radii, RoundMould{0.015}, 0.30, 1), std::invalid_argument);
  EXPECT_THROW(pack_gas(radii, RectangularMould{0.1, 0.03}, 0.30, 1), std::invalid_argument);
}

}  // namespace
}  // namespace dem
