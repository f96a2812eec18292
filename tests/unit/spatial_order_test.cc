#include "dem/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "dem/random.h"

namespace dem {
namespace {

TEST(spatial_order, it_holds_every_stone_once_and_keeps_slabs_and_their_cells_together) {
  // From the definition: each eighth lies above the one before, and along it each cell, counted
  // from the lowest corner, is entered once.
  const Vec3d corner = {0, 0, 0};
  std::vector<Vec3d> position = {corner};
  const auto number = [](std::uint32_t id, std::uint32_t draw) {
    return 0.1 * uniform(1, Purpose::position, id, draw);
  };
  for (std::uint32_t k = 1; k < 2000; ++k)
    position.push_back({number(k, 0), number(k, 1), number(k, 2)});
  const std::vector<std::uint32_t> order = spatial_order(position, 8e-3);
  ASSERT_EQ(order.size(), 2000u);
  double floor = corner.z;
  for (int slab = 0; slab < 8; ++slab) {
    double top = floor;
    std::vector<std::array<double, 3>> entered;
    for (int n = 250 * slab; n < 250 * (slab + 1); ++n) {
      ASSERT_GE(position[order[n]].z, floor);
      top = std::max(top, position[order[n]].z);
      const Vec3d p = (position[order[n]] - corner) * (1 / 8e-3);
      const std::array cell = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
      if (entered.empty() || entered.back() != cell) entered.push_back(cell);
    }
    floor = top;
    std::ranges::sort(entered);
    EXPECT_TRUE(std::ranges::adjacent_find(entered) == entered.end());
  }
  std::vector<std::uint32_t> sorted = order;
  std::ranges::sort(sorted);
  for (std::uint32_t k = 0; k < 2000; ++k) ASSERT_EQ(sorted[k], k);
}

TEST(spatial_order, corners_of_a_slab_follow_the_z_curve) {
  // Morton (1966): x runs fastest, then y. Four corners at each of eight heights.
  std::vector<Vec3d> corners;
  std::vector<std::uint32_t> expected;
  for (int k = 31; k >= 0; --k) {
    corners.push_back({k & 1 ? 1.0 : 0, k & 2 ? 1.0 : 0, k / 4 * 1.0});
    expected.push_back(k);
  }
  EXPECT_EQ(spatial_order(corners, 0.7), expected);
}

}  // namespace
}  // namespace dem
