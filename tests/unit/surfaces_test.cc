#include "dem/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dem/frame.h"

namespace dem {
namespace {

constexpr Block block = {{25e-3, 50e-3, 10e-3}};
constexpr Disc disc = {75e-3};
constexpr CylinderInside cylinder = {75e-3};

// Normal = gradient of the distance, of unit length, and the surface is that far away along it.
template <class Shape>
void expect_sound(const Shape& shape, const Vec3d& x) {
  const Nearest<double> at = shape.nearest(x);
  EXPECT_NEAR(norm(at.normal), 1, 1e-12);
  const double step = 1e-8;
  const auto slope = [&](const Vec3d& e) {
    return (shape.nearest(x + e * step).distance - shape.nearest(x - e * step).distance) /
           (2 * step);
  };
  // Central differences err by the curvature of edges, (1e-8 / 1e-3)^2, and by rounding over 1e-8.
  EXPECT_NEAR(slope({1, 0, 0}), at.normal.x, 1e-7);
  EXPECT_NEAR(slope({0, 1, 0}), at.normal.y, 1e-7);
  EXPECT_NEAR(slope({0, 0, 1}), at.normal.z, 1e-7);
  const Vec3d almost_there = x - at.normal * (0.999 * at.distance);
  EXPECT_NEAR(shape.nearest(almost_there).distance, 0.001 * at.distance, 1e-12);
}

template <class Shape, class Keep>
void expect_sound_around(const Shape& shape, Keep keep) {
  std::mt19937 engine(1);
  const auto any = [&] { return 0.2 * (engine() / 4294967295.0 - 0.5); };
  int kept = 0;
  while (kept < 500) {
    const Vec3d x = {any(), any(), any()};
    if (!keep(x)) continue;
    expect_sound(shape, x);
    ++kept;
  }
}

TEST(surfaces, distance_and_normal_belong_together) {
  // From the definition of a distance, on the side where stones are, away from edges' far fields
  // where the nearest point jumps.
  expect_sound_around(Plane{}, [](const Vec3d&) { return true; });
  expect_sound_around(cylinder, [](const Vec3d& x) { return std::hypot(x.x, x.y) > 1e-3; });
  expect_sound_around(disc, [](const Vec3d& x) {
    const double r = std::hypot(x.x, x.y);
    return std::abs(r - disc.radius) > 1e-6 && (x.z < -1e-3 || r > disc.radius + 1e-3);
  });
  expect_sound_around(block, [](const Vec3d& x) { return block.nearest(x).distance > 1e-3; });
}

TEST(surfaces, a_stone_under_a_disc_sees_its_face_and_beside_it_the_rim) {
  // Closed form: -z below the face, the distance from the rim circle beyond it, seamless between.
  EXPECT_NEAR(disc.nearest(Vec3d{10e-3, 20e-3, -5e-3}).distance, 5e-3, 1e-15);
  EXPECT_NEAR(disc.nearest(Vec3d{10e-3, 20e-3, -5e-3}).normal.z, -1, 1e-15);
  EXPECT_NEAR(disc.nearest(Vec3d{78e-3, 0, -4e-3}).distance, 5e-3, 1e-15);
  EXPECT_NEAR(disc.nearest(Vec3d{78e-3, 0, -4e-3}).normal.x, 0.6, 1e-12);
  EXPECT_NEAR(disc.nearest(Vec3d{75e-3 - 1e-9, 0, -4e-3}).distance,
              disc.nearest(Vec3d{75e-3 + 1e-9, 0, -4e-3}).distance, 1e-12);
  EXPECT_LT(disc.nearest(Vec3d{0, 0, 1e-3}).distance, 0);
}

TEST(surfaces, a_stone_near_a_block_sees_face_edge_or_corner) {
  // Closed form: distances in a rectangular block, and out through the lower face from inside.
  EXPECT_NEAR(block.nearest(Vec3d{0, 0, -14e-3}).distance, 4e-3, 1e-15);
  EXPECT_NEAR(block.nearest(Vec3d{28e-3, 0, -14e-3}).distance, 5e-3, 1e-15);
  EXPECT_NEAR(block.nearest(Vec3d{26e-3, 52e-3, -12e-3}).distance, 3e-3, 1e-15);
  EXPECT_NEAR(block.nearest(Vec3d{0, 0, -9e-3}).distance, -1e-3, 1e-15);
  EXPECT_EQ(block.nearest(Vec3d{0, 0, -9e-3}).normal.z, -1);
}

TEST(surfaces, the_cylinder_pushes_towards_its_axis) {
  // Closed form: distance R - r, normal -e_r; on the axis itself nothing is touched.
  const Nearest<double> at = cylinder.nearest(Vec3d{30e-3, 40e-3, 1});
  EXPECT_NEAR(at.distance, 25e-3, 1e-15);
  EXPECT_NEAR(at.normal.x, -0.6, 1e-12);
  EXPECT_EQ(cylinder.nearest(Vec3d{0, 0, 0}).distance, cylinder.radius);
}

TEST(surfaces, eight_points_are_answered_as_one_is) {
  // Reference: the same surface with T = double; fused operations cost the last place.
  std::mt19937 engine(4);
  const auto any = [&] { return 0.3 * (engine() / 4294967295.0 - 0.5); };
  const auto check = [&](const auto& shape) {
    Vec3<Pack> all;
    Vec3d one[lanes];
    for (int k = 0; k < lanes; ++k) {
      one[k] = {any(), any(), any()};
      set_lane(all.x, k, one[k].x);
      set_lane(all.y, k, one[k].y);
      set_lane(all.z, k, one[k].z);
    }
    const Nearest<Pack> together = shape.nearest(all);
    for (int k = 0; k < lanes; ++k) {
      const Nearest<double> alone = shape.nearest(one[k]);
      EXPECT_NEAR(together.distance[k], alone.distance, 1e-15);
      EXPECT_NEAR(together.normal.x[k], alone.normal.x, 1e-13);
      EXPECT_NEAR(together.normal.y[k], alone.normal.y, 1e-13);
      EXPECT_NEAR(together.normal.z[k], alone.normal.z, 1e-13);
    }
  };
  for (int n = 0; n < 50; ++n) {
    check(Plane{});
    check(cylinder);
    check(disc);
    check(block);
  }
}

TEST(surfaces, a_frame_takes_vectors_there_and_back_and_moves_as_a_rigid_body) {
  // Closed form: rotation and its transpose; v(x) = v0 + spin x (x - x0).
  Frame frame;
  frame.origin = {1, 0, 0};
  frame.ex = {0, 1, 0};
  frame.ey = {-1, 0, 0};
  frame.velocity = {0, 0, 2};
  frame.spin = {0, 0, 3};
  const Vec3d v = {0.1, -0.2, 0.3};
  EXPECT_NEAR(norm(frame.to_frame(frame.to_laboratory(v)) - v), 0, 1e-16);
  EXPECT_NEAR(norm(frame.to_laboratory(Vec3d{1, 0, 0}) - Vec3d{0, 1, 0}), 0, 1e-16);
  EXPECT_NEAR(norm(frame.velocity_at(Vec3d{2, 0, 5}) - Vec3d{0, 3, 2}), 0, 1e-15);
}

}  // namespace
}  // namespace dem
