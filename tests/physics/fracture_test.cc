#include "dem/fracture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"
#include "dem/simulation.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::absolute, checks::check, checks::relative;

using Law = Fracture<Mindlin<>>;
constexpr Mindlin<> stone = {{3.8e10}, 8e9, 0.7}, smooth = {{3.8e10}, 8e9, 0};
constexpr Crack crack = {0, 0, 50e6, {0, 0, 1}, 200};

TEST(fracture, a_cracked_stone_that_nothing_clamps_keeps_its_residual_stiffness) {
  // Limit of the rule: C = 0, loads along the crack included.
  const FractureRule rule;
  check({"stiffness share of a cracked stone, nothing clamps it", "1",
         stiffness_share(rule, crack, {}), rule.residual, absolute(0), "limit of the rule, C = 0"});
  EXPECT_NEAR(stiffness_share(rule, crack, {{{0, 0, 1}, 1e6, 0}, {{0, 0, -1}, 1e6, 0}}),
              rule.residual, 1e-12);
}

TEST(fracture, a_cracked_stone_clamped_hard_is_as_stiff_as_before) {
  // Limit of the rule: C -> infinity, share -> 1 as 1 - (1 - residual) F_b / C.
  const double clamp = 1e9;
  const double share = stiffness_share({}, crack, {{{1, 0, 0}, clamp, 0}, {{-1, 0, 0}, clamp, 0}});
  check({"stiffness lost of a stone clamped hard / 0.9 F_b / C", "1",
         (1 - share) / (0.9 * crack.force / clamp), 1, relative(1e-6),
         "limit of the rule, C to infinity"});
}

TEST(fracture, clamping_with_the_breaking_force_restores_half_of_what_was_lost) {
  // Closed form: C = F_b gives residual + (1 - residual)/2; a pair of opposite forces F across the
  // crack is C = F, at 45 degrees half of it.
  const double half = stiffness_share({0.2}, crack, {{{1, 0, 0}, 200, 0}, {{-1, 0, 0}, 200, 0}});
  check({"stiffness share of a stone clamped by its breaking force", "1", half, 0.2 + 0.8 / 2,
         relative(1e-12), "closed form of the rule"});
  const double s = std::sqrt(0.5);
  const double oblique =
      stiffness_share({0.2}, crack, {{{s, 0, s}, 200, 0}, {{-s, 0, -s}, 200, 0}});
  EXPECT_NEAR(oblique, 0.2 + 0.8 / 3, 1e-12);
}

TEST(fracture, more_clamping_never_makes_a_stone_softer) {
  // From the rule: share rises with every load, and stays between residual and 1.
  double before = 0;
  std::vector<StoneLoad> loads;
  for (int k = 0; k < 20; ++k) {
    loads.push_back({{std::sin(k), 0, std::cos(k)}, 10.0 * k, 0});
    const double share = stiffness_share({}, crack, loads);
    EXPECT_GE(share, before);
    EXPECT_LT(share, 1);
    before = share;
  }
}

TEST(fracture, the_crack_runs_along_the_most_crushing_load) {
  // By definition: the largest F / R0^2, not the largest force.
  const Crack made =
      crack_of(7, 0.25, {{{1, 0, 0}, 500, 1e6}, {{0, 1, 0}, 100, 9e6}, {{0, 0, 1}, 300, 2e6}});
  EXPECT_EQ(made.stone, 7u);
  EXPECT_EQ(made.time, 0.25);
  EXPECT_EQ(made.direction.y, 1);
  EXPECT_EQ(made.force, 100);
  EXPECT_EQ(made.crush, 9e6);
}

TEST(fracture, compliances_of_stone_and_wall_add_up) {
  // Closed form: 1/E0 grows by (softness - 1) x the stone's part of it: F/F_whole = 1/softness for
  // a pair, 1/(1 + share (softness - 1)) on a wall of which the stone is `share`.
  const double whole = OneContact<Law>({stone}, 1e-3, 1e-3).move(10e-6, 1e-6).push;
  for (const double softness : {1.0, 2.0, 10.0})
    for (const double share : {1.0, 0.753, 0.0}) {
      OneContact<Law> contact({stone, share}, 1e-3, 1e-3);
      contact.soften(softness);
      const auto at = contact.move(10e-6, 1e-6);
      check({"force / that of a whole stone, softness", "1", at.push / whole,
             1 / (1 + share * (softness - 1)), relative(1e-12), "compliances add up", softness});
      EXPECT_EQ(at.stone, at.push);
    }
}

// A stone squeezed between a fixed and a driven plate, both smooth.
Simulation<Law> squeeze(double strength, const Vec3d& spin = {0, 0, 0}) {
  ParticleStore stones = make_stones({{0, 0, 4e-3}}, {4e-3}, {2650}, 1);
  make_breakable(stones, {strength});
  stones.spin[0] = spin;
  Settings settings;
  settings.gravity = 0;
  settings.largest_step = 2e-7;
  settings.skin = 1e-3;
  Simulation<Law> press(stones, {stone}, settings);
  press.add_wall({"base", Plane{}, {}}, {smooth});
  Frame top;
  top.origin = {0, 0, 8e-3};
  top.ey = {0, -1, 0};
  top.ez = {0, 0, -1};
  press.add_wall({"top", Plane{}, top, Driven{{0, 0, -0.02}}}, {smooth});
  return press;
}

TEST(fracture, a_squeezed_stone_breaks_when_its_strength_is_reached_and_only_once) {
  // Closed form: F = sigma_F R0^2, here 20 MPa x (4 mm)^2 = 320 N; the plates close by 0.4 nm a
  // step, 0.1 N. Between two plates nothing clamps the crack, so that the stiffness falls to its
  // residual tenth and the force with it.
  Simulation<Law> press = squeeze(20e6);
  double most = 0;
  while (press.cracks().empty()) {
    press.step();
    most = std::max(most, press.walls()[0].push);
    ASSERT_LT(press.time(), 5e-3);
  }
  check({"force that breaks a stone of 20 MPa and 8 mm", "N", most, 320, absolute(1),
         "closed form, sigma_F R0^2; 0.1 N a step"});
  EXPECT_NEAR(press.cracks()[0].force, 320, 1);
  EXPECT_NEAR(std::abs(press.cracks()[0].direction.z), 1, 1e-12);
  const double whole = most / std::pow(0.5 * 0.02 * press.time(), 1.5);
  for (int n = 0; n < 2000; ++n) press.step();
  EXPECT_NEAR(press.stones().softness[0], 10, 1e-3);
  check({"stiffness of a broken, unclamped stone / before", "1",
         press.walls()[0].push / std::pow(0.5 * 0.02 * press.time(), 1.5) / whole, 0.1,
         absolute(0.01), "residual of the rule"});
  EXPECT_EQ(press.cracks().size(), 1u);
}

TEST(fracture, a_clamp_that_comes_and_goes_does_not_soften_a_stone_for_ever) {
  // By the rule: the share is that of the weakest clamp since the break, which is as weak in every
  // turn, and the force between the plates that broke the stone is that of a whole one times the
  // share. Closed form of the force: Hertz.
  Simulation<Law> press = squeeze(20e6);
  for (const double side : {1.0, -1.0}) {
    Frame frame;
    frame.ez = {-side, 0, 0};
    frame.ex = {0, 1, 0};
    frame.ey = cross(frame.ez, frame.ex);
    frame.origin = {side * (4e-3 - 10e-6), 0, 4e-3};
    press.add_wall({side > 0 ? "right" : "left", Plane{}, frame, Driven{{0, 0, 0}}}, {smooth});
  }
  while (press.cracks().empty()) press.step();
  press.walls()[1].motion = Fixed{};
  const auto clamp = [&](double speed, double duration) {
    for (const std::size_t wall : {2, 3})
      press.walls()[wall].motion = Driven{press.walls()[wall].frame.ez * speed};
    const double end = press.time() + duration;
    while (press.time() < end) press.step();
  };
  double after_two = 0, softest = 1;
  for (int turn = 0; turn < 40; ++turn) {
    clamp(-2e-3, 2e-3);
    EXPECT_GE(press.stones().softness[0], softest);
    softest = press.stones().softness[0];
    clamp(2e-3, 2e-3);
    if (turn == 2) after_two = press.walls()[0].push;
  }
  EXPECT_GT(softest, 1.5);
  EXPECT_LT(softest, 9.9);
  const double d = 4e-3 - press.stones().position[0].z;
  check({"force of a stone clamped 40 times / Hertz times its share", "1",
         press.walls()[0].push * softest / (4.0 / 3 * 3.8e10 * std::sqrt(4e-3) * std::pow(d, 1.5)),
         1, relative(1e-9), "Hertz, softer by the share of the weakest clamp"});
  // The walls stop up to a step late, so that the clamp wanders: a tenth. Stiffness that came back
  // to later load only left a twentieth of it.
  EXPECT_NEAR(press.walls()[0].push, after_two, 0.1 * after_two);
}

TEST(fracture, a_crack_turns_with_its_stone) {
  // Rigid rotation: by spin x time, from the break to the last of the looks every 16 steps.
  const double rate = 500;
  Simulation<Law> press = squeeze(20e6, {rate, 0, 0});
  while (press.cracks().empty()) press.step();
  const Vec3d before = press.cracks()[0].direction;
  for (int n = 0; n < 5000; ++n) press.step();
  const double turn = rate * (press.time() - press.cracks()[0].time);
  check({"angle that a crack has turned by", "rad",
         std::acos(dot(before, press.cracks()[0].direction)), turn,
         absolute(rate * check_interval * press.time_step()), "spin x time, up to the last look"});
}

TEST(fracture, a_stone_below_its_strength_stays_whole) {
  // By definition.
  Simulation<Law> press = squeeze(20e6);
  while (press.walls()[0].push < 300) press.step();
  EXPECT_TRUE(press.cracks().empty());
  EXPECT_EQ(press.stones().softness[0], 1);
}

}  // namespace
}  // namespace dem
