#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/physics/binder_laws.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::check, checks::relative;

constexpr double r0 = 1.4e-3;  // [m]
constexpr double deep = 0.8e-3;
constexpr double slide = 0.1e-3;

OneContact<Binder<2>> contact_of(const Binder<2>& law) {
  return {law, r0, r0};
}

// G0 A / b: shear stiffness of a film that does not relax [N/m].
double stiffness(const Binder<2>& law, double overlap) {
  return law.modulus * std::numbers::pi * r0 * overlap / law.film;
}

TEST(film, a_step_of_sliding_relaxes_as_the_modulus) {
  // Closed form: T = G(t) A s / b, A = pi R0 h, against the sliding. Exact but for rounding.
  const Binder<2> law = hot_binder(0.43);
  auto contact = contact_of(law);
  contact.move(deep, 0);
  const double whole = stiffness(law, deep) * slide;
  EXPECT_NEAR(contact.move(deep, 0, {0.6 * slide, -0.8 * slide, 0}).shear.x / whole, -0.6, 1e-12);
  double time = 0;
  for (const double dt : {1e-3, 0.2, 30.0}) {
    time += dt;
    const Vec3d shear = contact.move(deep, dt).shear;
    check({"shear force of a step of sliding / G0 A s / b, time / s", "1", shear.x / whole / -0.6,
           relaxation(law, time), relative(1e-12), "closed form, G(t) / G0", time});
    EXPECT_NEAR(shear.y / whole, 0.8 * relaxation(law, time), 1e-12);
  }
}

TEST(film, steady_sliding_is_exact_for_any_step) {
  // Closed form: T = G0 A v / b [g t + sum A_i tau_i (1 - exp(-t/tau_i))].
  const Binder<2> law = hot_binder(1);
  const double speed = 1e-3;
  auto contact = contact_of(law);
  contact.move(deep, 0);
  double time = 0;
  for (const double dt : {1e-5, 0.02, 0.3, 1e-3, 4.0}) {
    time += dt;
    double sum = (1 - law.weight[0] - law.weight[1]) * time;
    for (int i = 0; i < 2; ++i)
      sum -= law.weight[i] * law.time[i] * std::expm1(-time / law.time[i]);
    const double shear = contact.move(deep, dt, {speed * dt, 0, 0}).shear.x;
    check({"shear force of steady sliding / exact, time / s", "1",
           -shear / (stiffness(law, deep) * speed * sum), 1, relative(1e-12),
           "closed form, int G dt", time});
  }
}

TEST(film, growing_contact_adds_area_to_later_sliding_only) {
  // Reference: adaptive quadrature of T = 1/b int G(t - s) A(s) ds under h = v t, s = u t. The step
  // takes the area at its end, an error of first order: 1/n.
  const Binder<2> law = hot_binder(0.43);
  constexpr double duration = 0.3;
  const double exact = integral(
      [&](double s) { return relaxation(law, duration - s) * stiffness(law, deep * s / duration); },
      0, duration, 1e-9);
  constexpr int steps = 2000;
  auto contact = contact_of(law);
  double shear = 0;
  for (int n = 1; n <= steps; ++n)
    shear = contact.move(deep * n / steps, duration / steps, {slide / steps, 0, 0}).shear.x;
  check({"shear force of a growing contact / exact, 2000 steps", "1",
         -shear / (exact * slide / duration), 1, relative(2.0 / steps),
         "hereditary integral by quadrature"});
}

TEST(film, shrinking_contact_gives_up_force_with_its_area) {
  // From the law: history shrinks as the area does, and what is lost does not come back.
  const Binder<2> law = hot_binder(0);
  auto contact = contact_of(law);
  contact.move(deep, 0);
  contact.move(deep, 0, {slide, 0, 0});
  const double whole = stiffness(law, deep) * slide;
  check({"shear force left at a quarter of the area", "1",
         -contact.move(0.25 * deep, 1e-3).shear.x / whole, 0.25, relative(1e-12),
         "the law: history shrinks with the area"});
  EXPECT_NEAR(-contact.move(deep, 1e-3).shear.x / whole, 0.25, 1e-12);
}

TEST(film, rings_forget_what_their_rim_has_been_sheared_by_and_no_more) {
  // From geometry: of a film sheared all alike, a fall to 10 of its 16 rings leaves as much of the
  // force, and no swing between the two takes more: what comes back has not been sheared. One ring
  // forgets the same share with every swing.
  const Binder<2> law = hot_binder(0);
  OneContact<Binder<2, 16>> rings(in_rings(law), r0, r0);
  auto even = contact_of(law);
  const double wide = 0.96 * law.film, narrow = 10.0 / 16 * law.film, left = narrow / wide;
  const double whole = stiffness(law, wide) * slide;
  const auto swing = [&](auto& contact) {
    const double force = -contact.move(narrow, 1e-3).shear.x;
    contact.move(wide, 1e-3);
    return force / whole;
  };
  for (const double overlap : {0.0, wide}) {
    rings.move(overlap, 0);
    even.move(overlap, 0);
  }
  EXPECT_NEAR(-rings.move(wide, 0, {slide, 0, 0}).shear.x / whole, 1, 1e-12);
  even.move(wide, 0, {slide, 0, 0});
  for (int n = 1; n <= 10; ++n) {
    check({"shear force left after swings of the area, 16 rings, swings", "1", swing(rings), left,
           relative(1e-12), "geometry: the rim alone is lost", double(n)});
    EXPECT_NEAR(swing(even), std::pow(left, n), 1e-12);
  }
}

TEST(film, rings_of_a_growing_contact_are_sheared_as_a_film) {
  // From the law: while the contact grows and slides, nothing is forgotten, in one ring or in many.
  const Binder<2> law = hot_binder(0.43);
  OneContact<Binder<2, 16>> rings(in_rings(law), r0, r0);
  auto even = contact_of(law);
  for (int n = 1; n <= 100; ++n) {
    const double overlap = 0.0105 * n * law.film;
    const Vec3d ds = {0.01 * slide * n, 0.02 * slide, 0};
    const Vec3d one = even.move(overlap, 0.01, ds).shear;
    const Vec3d many = rings.move(overlap, 0.01, ds).shear;
    EXPECT_NEAR(norm(many - one), 0, 1e-12 * norm(one)) << n;
  }
}

TEST(film, a_stretched_bond_carries_no_shear) {
  // From the law: no area below h = 0; pressed again, the film starts anew.
  const Binder<2> law = hot_binder(0.43, 1e4);
  auto contact = contact_of(law);
  contact.move(deep, 0);
  contact.move(deep, 1e-3, {slide, 0, 0});
  EXPECT_EQ(contact.move(-0.1 * deep, 1e-3, {slide, 0, 0}).shear.x, 0);
  EXPECT_TRUE(contact.held());
  EXPECT_EQ(contact.move(deep, 1e-3).shear.x, 0);
}

TEST(film, a_pair_sticks_although_it_is_pulled) {
  // From the law: no friction limit between stones; tension from relaxation inside h > 0 leaves the
  // film and its force alone.
  const Binder<2> law = hot_binder(1, 1e4);
  auto contact = contact_of(law);
  contact.move(deep, 0);
  contact.move(deep, 1000);
  EXPECT_LT(contact.move(0.5 * deep, 0).push, 0);
  const double whole = stiffness(law, 0.5 * deep) * slide;
  EXPECT_NEAR(-contact.move(0.5 * deep, 0, {slide, 0, 0}).shear.x / whole, 1, 1e-12);
}

TEST(film, a_film_on_a_wall_slips_at_its_friction) {
  // From the law: |T| <= mu x push, along the last sliding; turned back, the film unloads with the
  // stiffness G0 A / b, and none of it is left when the push is gone.
  Binder<2> law = hot_binder(0);
  law.friction = 0.3;
  auto contact = contact_of(law);
  const double push = contact.move(deep, 0).push;
  for (int n = 0; n < 40; ++n) contact.move(deep, 1e-3, {slide, 0, 0});
  check({"shear force of a film slipping on a wall / mu F", "1",
         contact.move(deep, 1e-3, {slide, 0, 0}).shear.x / (-0.3 * push), 1, relative(1e-12),
         "closed form, Coulomb"});
  EXPECT_NEAR(contact.move(deep, 1e-3, {-0.1 * slide, 0, 0}).shear.x,
              -0.3 * push + 0.1 * slide * stiffness(law, deep), 1e-9);
  contact.move(0, 1e-3);
  EXPECT_EQ(contact.move(deep, 1e-3).shear.x, 0);
}

TEST(film, half_the_thickness_is_twice_the_stiffness) {
  // Closed form: G A / b; at a wall b = t, half that of a pair.
  Binder<2> wall = hot_binder(0.43);
  wall.film /= 2;
  auto at_wall = contact_of(wall), of_pair = contact_of(hot_binder(0.43));
  at_wall.move(deep, 0);
  of_pair.move(deep, 0);
  const double ratio = at_wall.move(deep, 1e-2, {slide, 0, 0}).shear.x /
                       of_pair.move(deep, 1e-2, {slide, 0, 0}).shear.x;
  check({"shear force of half the film thickness / of the whole", "1", ratio, 2, relative(1e-12),
         "closed form, G A / b"});
}

}  // namespace
}  // namespace dem
