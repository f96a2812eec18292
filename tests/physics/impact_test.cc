// The eight impacts of Chung & Ooi (2011), Granular Matter 13, 643-656, integrated by the
// simulation.
#include "tests/physics/impact.h"

#include <gtest/gtest.h>

namespace dem {
namespace {

constexpr Material glass = {48e9, 0.20}, limestone = {20e9, 0.25};
constexpr Material aluminium_alloy = {70e9, 0.30}, magnesium_alloy = {40e9, 0.35};
constexpr Material aluminium_oxide = {380e9, 0.23}, cast_iron = {100e9, 0.25};
constexpr Material steel = {208e9, 0.3}, polyethylene = {1e9, 0.4};
constexpr Material copper = {120e9, 0.35}, nylon = {2.5e9, 0.4};

// Of two thousand steps a contact, leapfrog errs by less than 1e-5; the closed forms are those of
// point contacts, which the test allows 1 %.
constexpr double one_percent = 0.01;

double degrees(double angle) {
  return angle * std::numbers::pi / 180;
}

TEST(impact, two_spheres_compress_each_other_as_hertz_says) {
  // Test 1. Closed form: Hertz (1882); peak force, approach and duration by Chung & Ooi's inputs.
  const auto check = [](const Material& material, double density, const HertzImpact& known) {
    const ImpactCase impact = {
        material, density, 1, 0.35, {{10e-3, {0, 0, -10}}, {10e-3, {0, 0, 10}}}};
    const Outcome after = collide(impact);
    EXPECT_NEAR(after.force / known.force, 1, 1e-3);
    EXPECT_NEAR(after.overlap / known.overlap, 1, 1e-3);
    EXPECT_NEAR(after.duration / known.duration, 1, 2e-3);
    EXPECT_NEAR(after.velocity[0].z, 10, 1e-4);
    EXPECT_NEAR(after.force / hertz_impact(impact, 20).force, 1, 1e-5);
  };
  check(glass, 2800, {10.70e3, 274.1e-6, 40.3e-6});
  check(limestone, 2500, {7.108e3, 368.3e-6, 54.2e-6});
}

TEST(impact, a_sphere_compresses_a_plane_as_hertz_says) {
  // Test 2. Closed form: Hertz (1882).
  const auto check = [](const Material& material, double density, const HertzImpact& known) {
    const Outcome after = collide({material, density, 1, 0.35, {{0.1, {0, 0, -0.2}}}});
    EXPECT_NEAR(after.force / known.force, 1, 1e-3);
    EXPECT_NEAR(after.overlap / known.overlap, 1, 1e-3);
    EXPECT_NEAR(after.duration / known.duration, 1, 1e-3);
  };
  check(aluminium_alloy, 2699, {11.37e3, 49.72e-6, 731.6e-6});
  check(magnesium_alloy, 1800, {7.233e3, 52.12e-6, 767e-6});
}

TEST(impact, a_stone_rebounds_with_its_restitution) {
  // Test 3, and beyond it: e_out = e_in for any e and any speed (Schwager & Poeschel 2007, Antypov
  // & Elliott 2011). Damping takes velocities half a step late, 2e-4 of e at two thousand steps.
  for (const double speed : {0.039, 3.9})
    for (const double e : {0.001, 0.1, 0.13, 0.14, 0.2, 0.4, 0.6, 0.8, 1.0})
      for (const auto& [material, density] :
           {std::pair{aluminium_oxide, 4000.0}, {cast_iron, 7000.0}}) {
        const Outcome after = collide({material, density, e, 0, {{2.5e-3, {0, 0, -speed}}}});
        EXPECT_NEAR(after.velocity[0].z / speed, e, 2e-4);
      }
}

TEST(impact, two_stones_rebound_with_their_restitution) {
  // Closed form: relative velocity after / before = e, momentum kept, whatever the sizes.
  const Outcome after =
      collide({aluminium_alloy, 2699, 0.5, 0, {{20e-3, {0, 0, -1}}, {5e-3, {0, 0, 1}}}});
  EXPECT_NEAR((after.velocity[0].z - after.velocity[1].z) / 2, 0.5, 2e-4);
  EXPECT_NEAR(64 * after.velocity[0].z + after.velocity[1].z, -64 + 1, 1e-10);
}

TEST(impact, damping_never_pulls) {
  // From the law: stones do not stick. The normal force of a heavily damped impact, followed step
  // by step, stays above zero.
  const ImpactLaw law = law_of({steel, 7850, 0.05, 0.3, {{1e-3, {0, 0, -1}}}});
  Contact<double> contact = {};
  contact.stone_radius = contact.outer_radius = 1e-3;
  contact.mass = 1e-5;
  contact.softness = 1;
  for (const double closing : {5.0, 0.0, -1e-3, -5.0}) {
    contact.closing = closing;
    EXPECT_GE(law.normal(1e-6, contact).force, 0);
  }
  EXPECT_EQ(law.normal(1e-6, contact).force, 0);
}

TEST(impact, a_sliding_sphere_loses_speed_and_gains_spin_by_friction) {
  // Test 4. Closed form, sliding throughout: e_t = 1 - mu (1 + e) cot(theta),
  // omega = 5/2 mu (1 + e) v cos(theta) / R; 0.895 and 355 rad/s at 60 degrees (digitised: 0.893,
  // 357).
  for (const auto& [material, density] :
       {std::pair{aluminium_oxide, 4000.0}, {Material{70e9, 0.33}, 2700.0}})
    for (const double theta : {40.0, 50.0, 60.0, 70.0, 85.0}) {
      const double vt = 3.9 * std::sin(degrees(theta)), vn = 3.9 * std::cos(degrees(theta));
      const Outcome after = collide({material, density, 0.98, 0.092, {{2.5e-3, {vt, 0, -vn}}}});
      EXPECT_NEAR(after.velocity[0].x / vt / (1 - 0.092 * 1.98 * vn / vt), 1, one_percent);
      EXPECT_NEAR(after.spin[0].y / (2.5 * 0.092 * 1.98 * vn / 2.5e-3), 1, one_percent);
    }
}

TEST(impact, a_sphere_that_sticks_rebounds_as_digitised) {
  // Test 4, aluminium oxide, curves of Chung & Ooi as digitised by others; they are good to about
  // 1 %. Below 15 degrees ours leaves them: their spring keeps its force while the contact shrinks,
  // ours gives it up with the contact radius (see the next test).
  const double theta[] = {15, 20, 25, 30}, et[] = {0.624, 0.616, 0.634, 0.684};
  const double spin[] = {378, 511, 599, 617};
  for (int k = 0; k < 4; ++k) {
    const double vt = 3.9 * std::sin(degrees(theta[k])), vn = 3.9 * std::cos(degrees(theta[k]));
    const Outcome after = collide({aluminium_oxide, 4000, 0.98, 0.092, {{2.5e-3, {vt, 0, -vn}}}});
    EXPECT_NEAR(after.velocity[0].x / vt / et[k], 1, 0.015);
    EXPECT_NEAR(after.spin[0].y / spin[k], 1, 0.015);
  }
}

TEST(impact, a_sphere_that_slides_keeps_what_friction_leaves) {
  // Test 5. Closed form, sliding throughout: psi2 = psi1 - 7, R omega = 5 mu v_n, with
  // psi = slip velocity / (mu v_n). The force acts at the arm R - h/2, the closed form takes R.
  for (const auto& [material, density] : {std::pair{steel, 7850.0}, {polyethylene, 1400.0}})
    for (const double psi : {7.5, 12.96, 20.0}) {
      const double r = 10e-6, scale = 0.3 * 5;
      const Outcome after = collide({material, density, 1, 0.3, {{r, {psi * scale, 0, -5}}}});
      const double slip = (after.velocity[0].x - r * after.spin[0].y) / scale;
      const double shorter = after.overlap / (2 * r);
      EXPECT_NEAR((psi - slip) / 7, 1, one_percent + shorter * 5.0 / 7);
      EXPECT_NEAR(r * after.spin[0].y / scale / 5, 1, one_percent + shorter);
    }
}

TEST(impact, a_sphere_that_sticks_rebounds_nearer_to_finite_elements_than_an_unscaled_spring) {
  // Test 5, the deepest reversal of slip, at psi1 = 4: finite elements -1.72, the spring of Chung &
  // Ooi -2.79, which is further from what Maw, Barber & Fawcett (1976) found. Ours, whose force
  // falls with the contact radius (Thornton et al. 2013), -1.4 to -1.6.
  for (const auto& [material, density] : {std::pair{steel, 7850.0}, {polyethylene, 1400.0}}) {
    const double r = 10e-6, scale = 0.3 * 5;
    const Outcome after = collide({material, density, 1, 0.3, {{r, {4 * scale, 0, -5}}}});
    const double slip = (after.velocity[0].x - r * after.spin[0].y) / scale;
    EXPECT_NEAR(slip, -1.72, 0.35);
  }
}

TEST(impact, a_spinning_sphere_on_a_plane_is_slowed_by_friction) {
  // Test 6. Closed form, sliding throughout: slip after / slip before = 1 - 7/2 mu (1 + e) v_n /
  // v_t. Our spring has to be loaded first, which takes 0.5 to 0.8 % of the friction impulse here.
  for (const auto& [material, density] : {std::pair{aluminium_alloy, 2699.0}, {nylon, 1000.0}})
    for (const double ratio : {6.0, 10.0, 20.0}) {
      const double r = 0.1, vt = ratio * 0.2;
      const Outcome after =
          collide({material, density, 0.5, 0.4, {{r, {0, 0, -0.2}, {0, -vt / r, 0}}}});
      const double left = (after.velocity[0].x - r * after.spin[0].y) / vt;
      EXPECT_NEAR((1 - left) / (3.5 * 0.4 * 1.5 / ratio), 1, one_percent);
    }
}

TEST(impact, spheres_that_roll_on_each_other_keep_their_spin) {
  // Test 7. Closed form: opposite spins of equal spheres leave no slip velocity, so no friction.
  for (const auto& [material, density] : {std::pair{aluminium_alloy, 2699.0}, {copper, 8900.0}}) {
    const Outcome after =
        collide({material,
                 density,
                 0.5,
                 0.4,
                 {{0.1, {0, 0, -0.2}, {0, 3, 0}}, {0.1, {0, 0, 0.2}, {0, -3, 0}}}});
    EXPECT_NEAR(after.velocity[0].x, 0, 1e-12);
    EXPECT_NEAR(after.spin[0].y, 3, 1e-12);
    EXPECT_NEAR(after.spin[1].y, -3, 1e-12);
  }
}

TEST(impact, a_spinning_sphere_drags_one_of_another_size_by_friction) {
  // Test 8. Closed form: as test 6 with the reduced mass, whatever the ratio of sizes; here 1,
  // 2, 5.
  for (const auto& [material, density] : {std::pair{aluminium_alloy, 2699.0}, {nylon, 1000.0}})
    for (const double size : {1.0, 2.0, 5.0})
      for (const double ratio : {6.0, 12.0}) {
        const double r = 0.1, other = size * r, vt = ratio * 0.2;
        const Outcome after = collide({material,
                                       density,
                                       0.5,
                                       0.4,
                                       {{r, {0, 0, -0.2}, {0, -vt / r, 0}}, {other, {0, 0, 0}}}});
        const double slip = after.velocity[0].x - after.velocity[1].x -
                            (r * after.spin[0].y + other * after.spin[1].y);
        EXPECT_NEAR((1 - slip / vt) / (3.5 * 0.4 * 1.5 / ratio), 1, one_percent);
      }
}

}  // namespace
}  // namespace dem
