#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/physics/binder_laws.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::absolute, checks::check, checks::relative;

constexpr double r0 = 1.4e-3;          // [m]
constexpr double bond_energy = 1e4;    // w of the source, 0.01 J/mm2 [J/m2]
constexpr double deep = 0.5e-3;        // [m]
constexpr double small_step = 0.1e-6;  // of overlap [m]

double pull_off(double energy) {
  return 1.5 * std::numbers::pi * energy * r0;
}

OneContact<Binder<2>> pressed_contact(double bitumen_fraction, double energy) {
  OneContact<Binder<2>> contact(hot_binder(bitumen_fraction, energy), r0, r0);
  contact.move(deep, 0);
  return contact;
}

TEST(bond, the_pull_off_force_is_that_of_johnson_kendall_and_roberts) {
  // Closed form: 3/2 pi w R0 (Johnson, Kendall & Roberts 1971); 66 N for two stones of 5.6 mm and
  // w = 0.01 J/mm2.
  check({"pull-off force, two stones of 5.6 mm, 0.01 J/mm2", "N", Bond{bond_energy}.pull_off(r0),
         66, absolute(0.05), "Johnson, Kendall & Roberts (1971), two digits"});
  check({"pull-off force, two stones of 5.6 mm, 0.01 J/mm2", "N", Bond{bond_energy}.pull_off(r0),
         pull_off(bond_energy), relative(1e-12), "closed form, 3/2 pi w R0"});
  EXPECT_EQ(Bond{0}.pull_off(r0), 0);
}

TEST(bond, an_elastic_bond_stretches_to_exactly_its_pull_off_force) {
  // Closed form: -K G0 |h|^1.5 = -F_min at the break; one step of overlap more and it is gone.
  OneContact<Binder<2>> contact = pressed_contact(0, bond_energy);
  const double stiffness = pair_factor * std::sqrt(r0) * hot_binder(0).modulus;
  const double stretch = std::pow(pull_off(bond_energy) / stiffness, 2.0 / 3);
  const double last = contact.move(-stretch * (1 - 1e-9), 1e-3).push;
  check({"elastic bond: tension just before the break / F_min", "1", last / pull_off(bond_energy),
         -1, relative(1e-8), "closed form"});
  EXPECT_TRUE(contact.held());
  EXPECT_EQ(contact.move(-stretch * (1 + 1e-9), 1e-3).push, 0);
  EXPECT_FALSE(contact.held());
}

TEST(bond, tension_grows_to_the_pull_off_force_and_never_beyond) {
  // From the law: a relaxing bond, pulled at any speed, carries F_min and then breaks. The last
  // force before the break is within one step of overlap of it.
  for (const double speed : {1e-4, 1e-2, 1.0}) {
    OneContact<Binder<2>> contact = pressed_contact(0.43, bond_energy);
    double least = 0, h = deep;
    while (contact.held()) {
      h -= small_step;
      const double force = contact.move(h, small_step / speed).push;
      least = std::min(least, force);
      ASSERT_GT(h, -10e-3);
    }
    EXPECT_GE(least, -pull_off(bond_energy));
    check({"relaxing bond: largest tension / F_min, speed / (m/s)", "1",
           least / pull_off(bond_energy), -1, relative(1e-3), "the law, within a step of overlap",
           speed});
  }
}

TEST(bond, shells_still_pressed_are_pulled_by_at_most_the_pull_off_force_without_breaking) {
  // From the law: tension from relaxation inside h > 0 is limited, the contact stays bonded.
  constexpr double weak = 10;  // [J/m2]
  OneContact<Binder<2>> contact = pressed_contact(1, weak);
  contact.move(deep, 1000);  // relaxed wholly
  EXPECT_EQ(contact.move(0.5 * deep, 0).push, -pull_off(weak));
  EXPECT_TRUE(contact.held());
}

TEST(bond, without_energy_shells_part_and_never_pull) {
  // From the law: F_min = 0.
  OneContact<Binder<2>> contact = pressed_contact(1, 0);
  for (double h = deep; h > -small_step; h -= small_step)
    EXPECT_GE(contact.move(h, small_step / 1e-2).push, 0);
  EXPECT_EQ(contact.move(-small_step, 1e-6).push, 0);
  EXPECT_FALSE(contact.held());
}

TEST(bond, what_was_broken_is_forgotten_and_bonds_again_when_pressed) {
  // From the law: the history resets, so that a pair pressed again answers like a new one, shear
  // included.
  OneContact<Binder<2>> old_pair = pressed_contact(0.43, bond_energy);
  old_pair.move(deep, 0.3, {1e-4, 0, 0});
  old_pair.move(-10e-3, 1e-3);
  EXPECT_FALSE(old_pair.held());
  EXPECT_EQ(old_pair.move(-0.5e-3, 1e-3).push, 0);
  OneContact<Binder<2>> new_pair(hot_binder(0.43, bond_energy), r0, r0);
  for (const double h : {0.2e-3, 0.4e-3, -0.1e-3, 0.1e-3}) {
    const auto again = old_pair.move(h, 1e-2, {1e-5, 0, 0});
    const auto first = new_pair.move(h, 1e-2, {1e-5, 0, 0});
    EXPECT_EQ(again.push, first.push);
    EXPECT_EQ(again.shear.x, first.shear.x);
    EXPECT_TRUE(old_pair.held());
  }
}

}  // namespace
}  // namespace dem
