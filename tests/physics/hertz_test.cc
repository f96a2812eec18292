#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "dem/laws/mindlin.h"
#include "dem/material.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::absolute, checks::check, checks::relative;

constexpr Material granite = {74e9, 0.15}, steel = {210e9, 0.3};

Mindlin<> law_of(const Material& one, const Material& other, double gap = 0) {
  return {{1 / (normal_compliance(one) + normal_compliance(other))},
          1 / (shear_compliance(one) + shear_compliance(other)),
          0.7,
          gap};
}

TEST(hertz, the_reduced_moduli_are_those_of_granite_and_steel) {
  // Closed form: 1/E0 = sum (1 - nu^2)/E: 37.85 GPa for a pair of stones, 57.00 GPa on steel;
  // 1/G* = sum (2 - nu)/G with G = 32.17 GPa. Given to four digits.
  const auto known = [](const std::string& what, double computed, double reference) {
    check({what, "GPa", computed / 1e9, reference, absolute(0.005), "closed form, four digits"});
  };
  known("reduced modulus of two granite stones", law_of(granite, granite).normal.modulus, 37.85);
  known("reduced modulus of granite on steel", law_of(granite, steel).normal.modulus, 57.00);
  known("shear modulus of granite", shear_modulus(granite), 32.17);
  known("G* of two granite stones", law_of(granite, granite).shear_modulus, 32.17 / (2 * 1.85));
}

TEST(hertz, the_force_is_that_of_hertz) {
  // Closed form: Hertz (1882); two stones of 4 mm approach by 3.4 um under 10 N and 15.8 um under
  // 100 N, of 11.2 mm by 11.2 um under 100 N.
  const Mindlin<> law = law_of(granite, granite);
  for (const auto& [diameter, force, approach] :
       {std::array{4e-3, 10.0, 3.4e-6}, {4e-3, 100.0, 15.8e-6}, {11.2e-3, 100.0, 11.2e-6}}) {
    const double r0 = diameter / 4;
    const double exact = std::pow(force / (4.0 / 3 * law.normal.modulus * std::sqrt(r0)), 2.0 / 3);
    EXPECT_NEAR(exact, approach, 0.05e-6);
    OneContact<Mindlin<>> contact(law, r0, r0);
    check({"force of two granite stones, approach / m", "N", contact.move(exact, 1e-6).push, force,
           relative(1e-12), "closed form, Hertz (1882)", exact});
  }
}

TEST(hertz, stones_meet_where_their_shells_are_squeezed_out) {
  // Closed form: F = 4/3 E0 sqrt(R0) (h - gap)^1.5 H(h - gap) with the R0 of the bare stones.
  constexpr double gap = 1e-3, d = 10e-6, stone = 1e-3;
  OneContact<Mindlin<>> contact(law_of(granite, granite, gap), 1.25e-3, stone);
  EXPECT_EQ(contact.move(gap, 1e-6).push, 0);
  EXPECT_EQ(contact.move(0.5 * gap, 1e-6).stone, 0);
  const auto at = contact.move(gap + d, 1e-6);
  const double exact =
      4.0 / 3 * law_of(granite, granite).normal.modulus * std::sqrt(stone) * std::pow(d, 1.5);
  check({"force of stones within squeezed shells", "N", at.push, exact,
         relative(1e-10),  // gap + d - gap loses three digits of d
         "closed form, Hertz (1882)"});
  EXPECT_EQ(at.push, at.stone);
}

TEST(hertz, the_reported_stiffness_is_the_slope_of_the_force) {
  // Closed form: k = dF/dd = 2 E0 a; central difference over 1e-4 d, whose own error is 1e-9.
  OneContact<Mindlin<>> contact(law_of(granite, granite), 1e-3, 1e-3);
  constexpr double d = 10e-6, step = 1e-4 * d;
  const double above = contact.move(d + step, 1e-6).push, below = contact.move(d - step, 1e-6).push;
  check({"tangent stiffness / slope of the force", "1",
         contact.move(d, 1e-6).stiffness / ((above - below) / (2 * step)), 1, relative(1e-8),
         "central difference"});
}

}  // namespace
}  // namespace dem
