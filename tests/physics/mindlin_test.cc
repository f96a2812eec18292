#include <gtest/gtest.h>

#include <cmath>

#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/sum.h"
#include "dem/material.h"
#include "dem/simulation.h"
#include "tests/physics/binder_laws.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::absolute, checks::check, checks::relative;

constexpr Material granite = {74e9, 0.15};
constexpr double r0 = 1e-3;       // [m]
constexpr double d = 10e-6;       // [m]
constexpr double dt = 1e-6;       // [s]
constexpr double sticking = 1e6;  // a friction that no test here overcomes [-]

Mindlin<> law_of(double friction) {
  return {{0.5 / normal_compliance(granite)}, 0.5 / shear_compliance(granite), friction};
}

// 8 G* a of a contact pressed by `overlap` [N/m].
double spring(double overlap) {
  return 8 * law_of(0).shear_modulus * std::sqrt(r0 * overlap);
}

double hertz(double overlap) {
  return 4.0 / 3 * law_of(0).normal.modulus * std::sqrt(r0) * std::pow(overlap, 1.5);
}

TEST(mindlin, shear_and_normal_stiffness_are_in_mindlins_ratio) {
  // Closed form: k_t / k_n = 2 (1 - nu)/(2 - nu), 0.919 at nu = 0.15 (Mindlin 1949). The push is
  // differenced over 1e-4 d to either side, which errs by 4e-10; shear in stick is linear.
  constexpr double step = 1e-4 * d;
  OneContact<Mindlin<>> contact(law_of(sticking), r0, r0);
  const double above = contact.move(d + step, dt).push, below = contact.move(d - step, dt).push;
  contact.move(d, dt);
  const double shear = -contact.move(d, dt, {step, 0, 0}).shear.x;
  check({"shear / normal stiffness, nu = 0.15", "1", 2 * shear / (above - below), 2 * 0.85 / 1.85,
         relative(1e-8), "closed form, 2 (1 - nu)/(2 - nu), Mindlin (1949)"});
}

TEST(mindlin, a_stuck_contact_is_a_linear_spring) {
  // Closed form: T = -8 G* a s, loading and unloading alike.
  OneContact<Mindlin<>> contact(law_of(sticking), r0, r0);
  contact.move(d, dt);
  double slid = 0;
  for (const double ds : {1e-7, 2e-7, -5e-7, 3e-7}) {
    slid += ds;
    const Vec3d shear = contact.move(d, dt, {0, ds, 0}).shear;
    check({"shear force, loading and unloading in stick", "N", shear.y, -spring(d) * slid,
           relative(1e-12), "closed form, 8 G* a s, Mindlin (1949)"});
    EXPECT_EQ(shear.x, 0);
  }
}

TEST(mindlin, a_slipping_contact_carries_exactly_the_coulomb_force) {
  // Closed form: |T| = mu F, straight against the last sliding; turned back, the spring unloads
  // with the stiffness it was loaded with.
  OneContact<Mindlin<>> contact(law_of(0.7), r0, r0);
  contact.move(d, dt);
  const double limit = 0.7 * hertz(d);
  for (int k = 0; k < 50; ++k) contact.move(d, dt, {0.6e-6, 0.8e-6, 0});
  const Vec3d slipping = contact.move(d, dt, {0.6e-6, 0.8e-6, 0}).shear;
  check({"shear force in slip / mu F", "1", norm(slipping) / limit, 1, relative(1e-12),
         "closed form, Coulomb"});
  EXPECT_NEAR(slipping.x / limit, -0.6, 1e-12);
  const Vec3d back = contact.move(d, dt, {-0.06e-6, -0.08e-6, 0}).shear;
  EXPECT_NEAR((norm(slipping) - norm(back)) / (spring(d) * 1e-7), 1, 1e-9);
}

TEST(mindlin, sliding_round_a_corner_turns_the_friction_after_it) {
  // Reference: slip along y pulls the force at the Coulomb limit over into -y; the angle between
  // them falls as exp(-k s / mu F), so 40 such lengths turn it within rounding.
  OneContact<Mindlin<>> contact(law_of(0.5), r0, r0);
  contact.move(d, dt);
  const double length = 0.5 * hertz(d) / spring(d);
  for (int k = 0; k < 100; ++k) contact.move(d, dt, {length, 0, 0});
  for (int k = 0; k < 400; ++k) contact.move(d, dt, {0, 0.1 * length, 0});
  const Vec3d shear = contact.move(d, dt, {0, 0.1 * length, 0}).shear;
  EXPECT_NEAR(shear.x / norm(shear), 0, 1e-12);
  EXPECT_LT(shear.y, 0);
}

TEST(mindlin, a_growing_contact_stiffens_later_sliding_only) {
  // Closed form: d and s in proportion, T = int 8 G* a ds = 2/3 x 8 G* a s. The step takes the
  // radius at its end: first order, 3/4 / n.
  constexpr int steps = 1000;
  OneContact<Mindlin<>> contact(law_of(sticking), r0, r0);
  double shear = 0;
  for (int n = 1; n <= steps; ++n)
    shear = contact.move(d * n / steps, dt, {1e-6 / steps, 0, 0}).shear.x;
  check({"shear force / 8 G* a s, overlap and sliding in proportion, 1000 steps", "1",
         -shear / (spring(d) * 1e-6), 2.0 / 3, absolute(1.0 / steps), "closed form, 2/3"});
}

TEST(mindlin, a_shrinking_contact_gives_up_force_with_its_radius) {
  // From the law (Thornton et al. 2013, 2.3): T scales with a, and what is lost does not return.
  OneContact<Mindlin<>> contact(law_of(sticking), r0, r0);
  contact.move(d, dt);
  contact.move(d, dt, {1e-6, 0, 0});
  const double whole = spring(d) * 1e-6;
  check({"shear force left at a quarter of the overlap", "1",
         -contact.move(0.25 * d, dt).shear.x / whole, 0.5, relative(1e-12),
         "Thornton et al. (2013), 2.3"});
  EXPECT_NEAR(-contact.move(d, dt).shear.x / whole, 0.5, 1e-12);
}

TEST(mindlin, unloading_makes_a_stuck_contact_slip) {
  // Closed form: |T| <= mu F at every instant; F falls as d^1.5 but T by the radius as d^0.5 only.
  OneContact<Mindlin<>> contact(law_of(0.3), r0, r0);
  contact.move(d, dt);
  contact.move(d, dt, {1e-6, 0, 0});
  for (int k = 99; k >= 0; --k) {
    const auto at = contact.move(d * k / 100, dt);
    EXPECT_LE(norm(at.shear), 0.3 * at.push * (1 + 1e-12));
  }
  EXPECT_EQ(contact.move(d, dt).shear.x, 0);
}

TEST(mindlin, friction_counts_the_force_of_the_stones_alone) {
  // From the source: the stick-slip force is added to the binder's; its limit is mu F_stone.
  constexpr double gap = 1e-3;
  Mindlin<> stone = law_of(0.7);
  stone.cover = gap;
  const Binder<2> film = hot_binder(0.43);
  OneContact<Sum<Mindlin<>, Binder<2>>> both({stone, film}, 1.25e-3, r0);
  OneContact<Binder<2>> binder(film, 1.25e-3, r0);
  both.move(gap + d, dt);
  binder.move(gap + d, dt);
  const auto sum = both.move(gap + d, dt, {50e-6, 0, 0});
  const auto part = binder.move(gap + d, dt, {50e-6, 0, 0});
  EXPECT_NEAR(sum.stone / hertz(d), 1, 1e-10);  // gap + d - gap loses three digits of d
  check({"friction of stones in shells / mu F of the stones", "1",
         (part.shear.x - sum.shear.x) / (0.7 * hertz(d)), 1, relative(1e-9),
         "Olsson, Jelagin & Partl, section 2"});
  EXPECT_NEAR(sum.push, sum.stone + part.push, 1e-12 * sum.push);
}

constexpr double slow = 1e-3, short_step = 1e-9;  // [m/s], [s]

// A stone that slides over a plane from the start, too heavy for the force to slow it.
Simulation<Mindlin<>> sliding_stone() {
  ParticleStore stones = make_stones({{0, 0, r0 - d}}, {r0}, {2650}, 1e9);
  stones.velocity[0] = {slow, 0, 0};
  Settings settings;
  settings.gravity = 0;
  settings.largest_step = short_step;
  settings.skin = 0.1 * r0;
  Simulation<Mindlin<>> run(stones, law_of(sticking), settings);
  run.add_wall({"plane", Plane{}, {}}, law_of(sticking));
  return run;
}

TEST(mindlin, stones_that_touch_at_the_start_have_slid_by_nothing_yet) {
  // Closed form: T = 8 G* a x what was slid in the steps taken, n v dt.
  auto run = sliding_stone();
  for (int n = 1; n <= 3; ++n) {
    run.step();
    check({"shear force after few steps / that of the way slid", "1",
           -run.stones().load[0].force.x / (spring(d) * n * slow * short_step), 1, relative(1e-6),
           "closed form"});
  }
}

TEST(mindlin, a_wall_added_far_away_in_mid_run_slides_no_stone) {
  // From the promise: forces are found anew for the new wall while no time passes.
  auto run = sliding_stone(), same = sliding_stone();
  for (int n = 0; n < 5; ++n) {
    run.step();
    same.step();
  }
  Frame away;
  away.origin = {0, 0, -1};
  run.add_wall({"far", Plane{}, away}, law_of(sticking));
  run.step();
  same.step();
  EXPECT_NEAR(run.stones().load[0].force.x / same.stones().load[0].force.x, 1, 1e-12);
}

TEST(mindlin, a_stone_that_softens_gives_up_shear_force_with_its_stiffness) {
  // From the law: a spring of force T stores T^2 / 2k, so that T must fall with k, as it does when
  // the contact shrinks; otherwise a softening stone would create energy.
  OneContact<Fracture<Mindlin<>>> contact({law_of(sticking)}, r0, r0);
  contact.move(d, dt);
  const double whole = -contact.move(d, dt, {1e-6, 0, 0}).shear.x;
  contact.soften(4);
  const auto soft = contact.move(d, dt);
  EXPECT_NEAR(soft.push / hertz(d), 0.25, 1e-12);
  EXPECT_NEAR(-soft.shear.x / whole, 0.25, 1e-12);
  contact.soften(1);
  EXPECT_NEAR(-contact.move(d, dt).shear.x / whole, 0.25, 1e-12);
}

}  // namespace
}  // namespace dem
