#include "dem/surface_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace dem {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 75e-3, height = 0.2;  // [m]
constexpr int sectors = 24;

SurfaceField disc() {
  return SurfaceField(DiscGrid{radius, 6, sectors});
}
SurfaceField cylinder() {
  return SurfaceField(CylinderGrid{radius, height, 8, sectors});
}

// Points all over the disc: centre, rim, between rim and chord, along and beside sector borders.
std::vector<Vec3d> disc_points() {
  std::vector<Vec3d> points = {{0, 0, 0}, {radius, 0, 0}, {-radius, 0, 0}, {1e-12, -1e-12, 0}};
  std::mt19937 engine(1);
  for (int k = 0; k < 2000; ++k) {
    const double r = k % 7 == 0 ? radius : radius * std::sqrt(engine() / 4294967295.0);
    const double angle = k % 5 == 0 ? 2 * pi / sectors * (k % sectors) : 1e-9 * engine();
    points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
  }
  return points;
}

std::vector<Vec3d> cylinder_points() {
  std::vector<Vec3d> points;
  std::mt19937 engine(2);
  for (int k = 0; k < 2000; ++k) {
    const double angle = k % 5 == 0 ? 2 * pi / sectors * (k % sectors) : 1e-9 * engine();
    const double z = k % 7 == 0 ? 0 : k % 11 == 0 ? height : height * (engine() / 4294967295.0);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return points;
}

double sum_of_weights(const Stencil& s) {
  return s.weight[0] + s.weight[1] + s.weight[2] + s.weight[3];
}

TEST(surface_field, weights_add_up_to_one_everywhere) {
  // By definition, to rounding.
  const SurfaceField on_disc = disc(), on_cylinder = cylinder();
  for (const Vec3d& x : disc_points()) EXPECT_NEAR(sum_of_weights(on_disc.stencil(x)), 1, 1e-12);
  for (const Vec3d& x : cylinder_points())
    EXPECT_NEAR(sum_of_weights(on_cylinder.stencil(x)), 1, 1e-12);
}

TEST(surface_field, a_disc_carries_linear_fields_without_error) {
  // By construction, to rounding, over the whole disc and not only its polygon.
  SurfaceField field = disc();
  const auto tilt = [](const Vec3d& x) {
    return Vec3d{0.3 + 2 * x.x - 5 * x.y, x.y, -1 + 7 * x.x};
  };
  for (std::size_t n = 0; n < field.size(); ++n) field.displacement[n] = tilt(field.node[n]);
  for (const Vec3d& x : disc_points())
    EXPECT_NEAR(norm(field.displacement_at(field.stencil(x)) - tilt(x)), 0, 1e-12);
}

// Force and moment about the origin of what the letterbox holds.
struct Resultant {
  Vec3d force = {0, 0, 0}, moment = {0, 0, 0};
};
Resultant resultant(const SurfaceField& field) {
  Resultant sum;
  for (std::size_t n = 0; n < field.size(); ++n) {
    sum.force += field.impulse[n];
    sum.moment += cross(field.node[n], field.impulse[n]);
  }
  return sum;
}

TEST(surface_field, a_disc_passes_on_force_and_moment_without_loss) {
  // Follows from linear reproduction: sum of w x = x for every point; to rounding.
  for (const Vec3d& x : disc_points()) {
    SurfaceField field = disc();
    const Vec3d force = {30, -20, 100};
    field.add_impulse(field.stencil(x), force);
    const Resultant sum = resultant(field);
    EXPECT_NEAR(norm(sum.force - force), 0, 1e-12 * norm(force));
    EXPECT_NEAR(norm(sum.moment - cross(x, force)), 0, 1e-12 * norm(force) * radius);
  }
}

TEST(surface_field, a_cylinder_passes_on_force_and_almost_all_of_the_moment) {
  // Closed form: the point sits on a chord instead of its arc, which is R (1 - cos(pi / sectors))
  // away at most; along the axis there is no error.
  const double bound = radius * (1 - std::cos(pi / sectors));
  double worst = 0;
  for (const Vec3d& x : cylinder_points()) {
    SurfaceField field = cylinder();
    const Vec3d force = {30, -20, 100};
    field.add_impulse(field.stencil(x), force);
    const Resultant sum = resultant(field);
    EXPECT_NEAR(norm(sum.force - force), 0, 1e-12 * norm(force));
    const double lost = norm(sum.moment - cross(x, force)) / norm(force);
    EXPECT_LE(lost, bound * (1 + 1e-3));  // the chord runs ahead of the angle by a third order
    worst = std::max(worst, lost);
  }
  EXPECT_GT(worst, 0.5 * bound);
}

TEST(surface_field, what_is_read_and_what_is_written_are_transposes) {
  // Virtual work: force . interpolated velocity = sum of nodal impulses . nodal velocities.
  std::mt19937 engine(3);
  const auto any = [&] { return engine() / 4294967295.0 - 0.5; };
  const auto check = [&](SurfaceField field, const std::vector<Vec3d>& points) {
    for (Vec3d& v : field.velocity) v = {any(), any(), any()};
    double outside = 0;
    for (const Vec3d& x : points) {
      const Stencil s = field.stencil(x);
      const Vec3d force = {any(), any(), any()};
      outside += dot(force, field.velocity_at(s));
      field.add_impulse(s, force);
    }
    double inside = 0;
    for (std::size_t n = 0; n < field.size(); ++n)
      inside += dot(field.impulse[n], field.velocity[n]);
    EXPECT_NEAR(inside, outside, 1e-12 * static_cast<double>(points.size()));
  };
  check(disc(), disc_points());
  check(cylinder(), cylinder_points());
}

TEST(surface_field, a_node_is_its_own_stencil) {
  // By definition: all of the weight at the node itself.
  for (const SurfaceField& field : {disc(), cylinder()})
    for (std::size_t n = 0; n < field.size(); ++n) {
      const Stencil s = field.stencil(field.node[n]);
      double own = 0;
      for (int k = 0; k < 4; ++k)
        if (s.node[k] == static_cast<int>(n)) own += s.weight[k];
      EXPECT_NEAR(own, 1, 1e-12);
    }
}

TEST(surface_field, nodal_areas_add_up_to_the_face_and_balance) {
  // Closed form: pi R^2 and 2 pi R H; their first moments vanish about the axis.
  const auto check = [](const SurfaceField& field, double whole, double middle) {
    double area = 0;
    Vec3d moment = {0, 0, 0};
    for (std::size_t n = 0; n < field.size(); ++n) {
      EXPECT_GT(field.area[n], 0);
      area += field.area[n];
      moment += field.node[n] * field.area[n];
    }
    EXPECT_NEAR(area / whole, 1, 1e-12);
    EXPECT_NEAR(norm(moment * (1 / whole) - Vec3d{0, 0, middle}), 0, 1e-12);
  };
  check(disc(), pi * radius * radius, 0);
  check(cylinder(), 2 * pi * radius * height, height / 2);
}

TEST(surface_field, nodes_drift_with_their_velocity) {
  // By definition.
  SurfaceField field = disc();
  field.velocity[5] = {1, 2, 3};
  field.drift(0.25);
  field.drift(0.25);
  EXPECT_EQ(field.displacement[5].z, 1.5);
  EXPECT_EQ(field.displacement[4].z, 0);
}

}  // namespace
}  // namespace dem
