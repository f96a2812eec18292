#include "dem/wall_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dem {
namespace {

constexpr double pi = std::numbers::pi;

Ram ram(bool spin) {
  Ram made;
  made.inertia = 3;
  made.weight = 29.43;
  made.force = 10603;
  made.ramp_start = 0.5;
  made.ramp = 1;
  made.angle = 1.16 * pi / 180;
  made.speed = 0.5;
  made.spin = spin;
  return made;
}

Frame oriented(const Ram& ram, double time) {
  Frame frame;
  orient(ram, frame, time);
  return frame;
}

TEST(motion, a_fixed_wall_stays) {
  // By definition.
  Frame frame;
  frame.origin = {1, 2, 3};
  advance(Fixed{}, frame, {10, 10, 10}, 0, {0.1, 0.1});
  EXPECT_EQ(frame.origin.z, 3);
  EXPECT_EQ(norm(frame.velocity), 0);
}

TEST(motion, a_wall_that_is_stopped_stays_where_it_is) {
  // By definition, however it was driven and turned before.
  Frame frame = oriented(ram(true), 2);
  ASSERT_GT(norm(frame.spin), 0);
  advance(Driven{{0.5, 0, -0.25}}, frame, {0, 0, 0}, 0, {1, 1});
  const Vec3d place = frame.origin, ex = frame.ex;
  advance(Fixed{}, frame, {10, 10, 10}, 1, {0.1, 0.1});
  EXPECT_EQ(norm(frame.velocity), 0);
  EXPECT_EQ(norm(frame.spin), 0);
  EXPECT_EQ(norm(frame.origin - place), 0);
  EXPECT_EQ(norm(frame.ex - ex), 0);
}

TEST(motion, a_driven_wall_goes_as_it_is_told) {
  // Closed form: x = v t.
  Frame frame;
  for (int n = 0; n < 1000; ++n)
    advance(Driven{{0.5, 0, -0.25}}, frame, {9, 9, 9}, n * 1e-3, {1e-3, 1e-3});
  EXPECT_NEAR(frame.origin.x, 0.5, 1e-12);
  EXPECT_NEAR(frame.origin.z, -0.25, 1e-12);
  EXPECT_EQ(frame.velocity.z, -0.25);
  EXPECT_EQ(norm(frame.spin), 0);
}

TEST(motion, the_ram_force_ramps_up_and_stays) {
  // By definition; without a ramp it steps.
  const Ram ramped = ram(false);
  EXPECT_EQ(ramped.force_at(0.4), 0);
  EXPECT_NEAR(ramped.force_at(0.75), 10603 * 0.25, 1e-9);
  EXPECT_EQ(ramped.force_at(1.5), 10603);
  EXPECT_EQ(ramped.force_at(100), 10603);
  Ram stepped = ram(false);
  stepped.ramp = 0;
  EXPECT_EQ(stepped.force_at(0.49), 0);
  EXPECT_EQ(stepped.force_at(0.5), 10603);
}

TEST(motion, gyrations_are_counted_from_the_end_of_the_ramp) {
  // By definition: 2 pi x 0.5 rev/s; from the end of a dwell where there is one.
  EXPECT_EQ(ram(false).phase_at(1.4), 0);
  EXPECT_NEAR(ram(false).phase_at(3.5), 2 * pi, 1e-12);
  Ram dwelling = ram(false);
  dwelling.dwell = 0.5;
  EXPECT_EQ(dwelling.phase_at(2), 0);
  EXPECT_EQ(norm(oriented(dwelling, 1.9).spin), 0);
  EXPECT_NEAR(dwelling.phase_at(4), 2 * pi, 1e-12);
}

TEST(motion, the_axes_of_a_ram_stay_orthonormal) {
  // From the definition of a rotation, to rounding.
  for (const bool spin : {false, true})
    for (double time = 0; time < 6; time += 0.037) {
      const Frame f = oriented(ram(spin), time);
      EXPECT_NEAR(norm(f.ex), 1, 1e-14);
      EXPECT_NEAR(norm(cross(f.ex, f.ey) - f.ez), 0, 1e-14);
      EXPECT_NEAR(dot(f.ex, f.ey), 0, 1e-14);
    }
}

TEST(motion, the_tilt_goes_round_at_its_angle) {
  // Closed form: the axis points along (sin a cos p, sin a sin p, cos a), p the phase.
  for (const bool spin : {false, true})
    for (double time = 0; time < 6; time += 0.037) {
      const Ram made = ram(spin);
      const Frame f = oriented(made, time);
      const double p = made.phase_at(time), a = made.angle;
      const Vec3d axis = {std::sin(a) * std::cos(p), std::sin(a) * std::sin(p), std::cos(a)};
      EXPECT_NEAR(norm(f.ez - axis), 0, 1e-14);
    }
}

TEST(motion, the_spin_is_the_rate_at_which_the_axes_turn) {
  // Closed form: d e/dt = spin x e; central difference over 2e-5 s, which errs by (3.1 rad/s)^3
  // 1e-10 / 6 and by rounding over 2e-5.
  const double dt = 1e-5;
  for (const bool spin : {false, true})
    for (double time = 0.1; time < 6; time += 0.137) {
      const Ram made = ram(spin);
      const Frame before = oriented(made, time - dt), after = oriented(made, time + dt);
      const Frame f = oriented(made, time);
      const auto miss = [&](const Vec3d& e, const Vec3d& early, const Vec3d& late) {
        return norm((late - early) * (0.5 / dt) - cross(f.spin, e));
      };
      EXPECT_NEAR(miss(f.ex, before.ex, after.ex), 0, 1e-8);
      EXPECT_NEAR(miss(f.ey, before.ey, after.ey), 0, 1e-8);
      EXPECT_NEAR(miss(f.ez, before.ez, after.ez), 0, 1e-8);
    }
}

TEST(motion, precession_alone_does_not_turn_the_head_about_its_axis) {
  // By definition: after a whole gyration every point is back; a point of the rim goes up and down
  // by R sin(a) and sideways by no more than R (1 - cos a), while with spin it goes round.
  const Ram nodding = ram(false), spinning = ram(true);
  const Vec3d rim = {75e-3, 0, 0};
  double most_sideways = 0, least_along = 1;
  for (double time = 1.5; time < 3.5; time += 0.01) {
    const Vec3d at = oriented(nodding, time).to_laboratory(rim);
    most_sideways = std::max(most_sideways, std::abs(at.y));
    least_along = std::min(least_along, oriented(spinning, time).to_laboratory(rim).x);
  }
  EXPECT_LT(most_sideways, 75e-3 * (1 - std::cos(nodding.angle)));
  EXPECT_LT(least_along, -0.99 * 75e-3);
  EXPECT_NEAR(norm(oriented(nodding, 3.5).ex - oriented(nodding, 1.5).ex), 0, 1e-12);
}

TEST(motion, an_unopposed_ram_falls_under_its_force_and_weight) {
  // Closed form: v = (F + W) t / m, the origin on the axis; with velocities at half steps the
  // travel is (F + W)/m t^2/2 (1 + 1/n).
  Ram made = ram(false);
  made.ramp_start = made.ramp = 0;
  Frame frame;
  constexpr int steps = 1000;
  for (int n = 0; n < steps; ++n) advance(made, frame, {5, 5, 0}, n * 1e-6, {1e-6, 1e-6});
  const double rate = (10603 + 29.43) / 3;
  EXPECT_NEAR(frame.velocity.z / (-rate * 1e-3), 1, 1e-12);
  EXPECT_NEAR(frame.origin.z / (-rate * 1e-6 / 2 * (1 + 1.0 / steps)), 1, 1e-12);
  EXPECT_EQ(frame.origin.x, 0);
  EXPECT_EQ(frame.origin.y, 0);
}

TEST(motion, an_unopposed_ram_comes_to_the_speed_at_which_the_valve_takes_all) {
  // Closed form: F + W = F (v / v_valve)^2; steps far longer than the time it takes, m v_valve / F,
  // end there too, from above and from below.
  Ram made = ram(false);
  made.ramp_start = made.ramp = 0;
  made.valve_speed = 0.1;
  const double speed = 0.1 * std::sqrt(1 + 29.43 / 10603);
  for (const double dt : {1e-6, 1e-4, 1e-2}) {
    Frame frame;
    for (int n = 0; n < 1000; ++n) advance(made, frame, {0, 0, 0}, n * dt, {dt, dt});
    EXPECT_NEAR(frame.velocity.z / -speed, 1, 1e-9);
    EXPECT_NEAR(made.thrust_at(1, frame.velocity.z), -29.43, 1e-5);
  }
}

TEST(motion, the_valve_takes_little_of_a_creeping_ram_and_nothing_of_one_without_it) {
  // By definition: the share lost is the square of speed / valve speed, against the motion.
  Ram made = ram(false);
  EXPECT_EQ(made.thrust_at(2, -1.0), 10603);
  made.valve_speed = 0.1;
  EXPECT_NEAR(made.thrust_at(2, -0.5e-3), 10603 * (1 - 25e-6), 1e-9);
  EXPECT_NEAR(made.thrust_at(2, 0.05), 10603 * 1.25, 1e-9);
}

TEST(motion, a_ram_in_balance_keeps_its_velocity) {
  // Newton's first law: the stones carry force and weight.
  Ram made = ram(false);
  made.ramp_start = made.ramp = 0;
  Frame frame;
  frame.velocity.z = -0.01;
  advance(made, frame, {0, 0, 10603 + 29.43}, 0, {1e-3, 1e-3});
  EXPECT_NEAR(frame.velocity.z, -0.01, 1e-15);
}

}  // namespace
}  // namespace dem
