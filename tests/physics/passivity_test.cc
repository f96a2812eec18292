#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "dem/laws/fracture.h"
#include "dem/laws/mindlin.h"
#include "dem/laws/slip_rings.h"
#include "dem/laws/sum.h"
#include "dem/material.h"
#include "tests/physics/binder_laws.h"
#include "tests/physics/check.h"
#include "tests/physics/one_contact.h"

namespace dem {
namespace {

using checks::at_least, checks::check;

using Stone = Mindlin<Hertz<>>;
using Damped = Mindlin<Hertz<Damping::restitution>>;

class Dice {
 public:
  explicit Dice(int seed) : engine_(seed) {}
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double decade(double least, double most) {
    return std::pow(10.0, between(std::log10(least), std::log10(most)));
  }

 private:
  std::mt19937_64 engine_;
};

// A smooth closed curve from -1, to +1 somewhere and back: harmonics of random size and phase.
class Curve {
 public:
  Curve(Dice& dice, int points) : value_(points) {
    constexpr int harmonics = 4;
    for (int k = 1; k <= harmonics; ++k) {
      const double size = dice.between(0, 1) / k, phase = dice.between(0, 2 * std::numbers::pi);
      for (int n = 0; n < points; ++n)
        value_[n] += size * std::sin(2 * std::numbers::pi * k * n / points + phase);
    }
    const auto [least, most] = std::ranges::minmax(value_);
    for (double& v : value_) v = 2 * (v - least) / (most - least) - 1;
    std::rotate(value_.begin(), std::ranges::min_element(value_), value_.end());
  }
  double at(int n) const { return value_[n % value_.size()]; }

 private:
  std::vector<double> value_;
};

struct Loop {
  double middle, depth;  // of the overlap [m]
  double slide;          // [m]
  double duration;       // of one turn [s]
  double softening = 0;  // softness of the stones in the end - 1 [-]
};

// Drives a contact that nobody has touched along two turns of a random loop. The work put into it
// never falls below zero if the law is passive: from nothing, nothing can be taken out. The
// trapezoidal rule leaves one step's worth of work open wherever a bond breaks, and a hundredth of
// that elsewhere.
template <class Law>
void expect_passive(const Law& law, double radius, const Loop& loop, Dice& dice,
                    const std::string& what, int seed) {
  constexpr int steps = 2000;
  const Curve overlap(dice, steps), x(dice, steps), y(dice, steps), softness(dice, steps);
  OneContact<Law> contact(law, 1.2 * radius, radius);
  double work = 0, least = 0, force = 0, stride = 0, old_h = 0, push = 0, soft = 1;
  Vec3d old_slide = {0, 0, 0}, shear = {0, 0, 0};
  int breaks = 0;
  for (int n = 0; n <= 2 * steps; ++n) {
    const double h = loop.middle + loop.depth * overlap.at(n);
    const Vec3d slide = {loop.slide * x.at(n), loop.slide * y.at(n), 0};
    if (n == 0) {
      ASSERT_LT(h, 0) << what << " of seed " << seed;  // a loop begins with the bodies apart
      old_h = h;
      old_slide = slide;
    }
    const bool held = contact.held();
    const Vec3d ds = slide - old_slide;
    soft = std::max(soft, 1 + loop.softening * (1 + softness.at(n)) / 2);
    contact.soften(soft);
    const Response<double> now = contact.move(h, loop.duration / steps, ds);
    ASSERT_TRUE(std::isfinite(now.push + norm(now.shear) + now.stiffness))
        << what << " of seed " << seed;
    work += 0.5 * (push + now.push) * (h - old_h) - 0.5 * dot(shear + now.shear, ds);
    least = std::min(least, work);
    breaks += held && !contact.held();
    force = std::max({force, std::abs(now.push), norm(now.shear)});
    stride = std::max({stride, std::abs(h - old_h), norm(ds)});
    old_h = h;
    old_slide = slide;
    push = now.push;
    shear = now.shear;
  }
  if (force > 0)
    check({"least work into a random closed path / (force x step), " + what + ", seed", "1",
           least / (force * stride), -(0.01 + breaks), at_least,
           "thermodynamics; a step for each break of a bond", double(seed)});
}

// The admissible box: modulus over 6 decades, shells to R, bonds to 0.1 J/mm2, any bitumen content.
template <int Terms>
Binder<Terms> any_binder(Dice& dice, double shell) {
  Binder<Terms> law;
  law.modulus = dice.decade(1e3, 1e9);
  double left = 1;
  for (int i = 0; i < Terms; ++i) {
    law.weight[i] = dice.between(0, left);
    left -= law.weight[i];
    law.time[i] = dice.decade(1e-3, 1e3);
  }
  law.normal_factor = dice.between(0, 1) < 0.5 ? pair_factor : wall_factor;
  law.film = law.normal_factor == pair_factor ? 2 * shell : shell;
  if (law.normal_factor == wall_factor) law.friction = dice.between(0, 1.5);
  law.bond.energy = dice.between(0, 1) < 0.3 ? 0 : dice.decade(1, 1e5);
  return law;
}

template <class Law>
Law any_stone(Dice& dice, double gap) {
  const Material material = {dice.decade(1e8, 1e11), dice.between(0, 0.49)};
  Law law = {{0.5 / normal_compliance(material)},
             0.5 / shear_compliance(material),
             dice.between(0, 1.5),
             gap};
  law.normal.damping_ratio = damping_ratio(dice.between(0.01, 1));
  return law;
}

constexpr int loops = 300;

template <int Rings>
void expect_passive_shells(const std::string& what) {
  for (int seed = 0; seed < loops; ++seed) {
    Dice dice(seed);
    const double radius = dice.decade(1e-3, 1e-2), shell = radius * dice.decade(1e-3, 1);
    const Loop loop = {shell * dice.between(-0.5, 1), 2 * shell, shell * dice.decade(1e-3, 1),
                       dice.decade(1e-5, 1e3)};
    expect_passive(in_rings<Rings>(any_binder<3>(dice, shell)), radius, loop, dice, what, seed);
  }
}

TEST(passivity, no_loop_takes_energy_out_of_binder_shells) {
  // From thermodynamics: normal force and film shear of a generalised Maxwell model, through
  // touching, sticking, tension, breaking and touching again.
  expect_passive_shells<1>("binder shells");
}

TEST(passivity, no_loop_takes_energy_out_of_films_in_rings) {
  // From thermodynamics: each ring is a film of its own.
  expect_passive_shells<16>("films in rings");
}

// Loops sized so that stones stick, slip and part; a turn takes shortest to longest [s].
template <class Law>
void expect_passive_stones(const std::string& what, double shortest, double longest) {
  for (int seed = 0; seed < loops; ++seed) {
    Dice dice(seed);
    const double radius = dice.decade(1e-3, 1e-2), depth = radius * dice.decade(1e-5, 1e-2);
    const Loop loop = {depth * dice.between(-0.5, 0.9), depth, depth * dice.decade(1e-2, 10),
                       dice.decade(shortest, longest)};
    expect_passive(any_stone<Law>(dice, 0), radius, loop, dice, what, seed);
  }
}

TEST(passivity, no_loop_takes_energy_out_of_bare_stones) {
  // From thermodynamics: Hertz and Mindlin with slip.
  expect_passive_stones<Stone>("bare stones", 1e-5, 1e3);
}

TEST(passivity, no_loop_takes_energy_out_of_stones_that_slip_from_their_rim) {
  // From thermodynamics: each ring is a spring that slips.
  expect_passive_stones<SlipRings<>>("slip rings", 1e-5, 1e3);
}

TEST(passivity, no_loop_takes_energy_out_of_damped_stones) {
  // From thermodynamics: damping only ever takes energy, whatever the restitution.
  expect_passive_stones<Damped>("damped stones", 1e-6, 1e-1);
}

TEST(passivity, no_loop_takes_energy_out_of_stones_in_their_shells) {
  // From thermodynamics: both laws side by side, loops about the depth where the stones meet.
  for (int seed = 0; seed < loops; ++seed) {
    Dice dice(seed);
    const double radius = dice.decade(1e-3, 1e-2), shell = radius * dice.decade(1e-3, 1);
    const Binder<3> binder = any_binder<3>(dice, shell);
    const Stone stone = any_stone<Stone>(dice, binder.film);
    const double depth = binder.film * dice.decade(1e-4, 1);
    const Loop loop = {binder.film - 0.5 * depth, depth + binder.film, depth,
                       dice.decade(1e-5, 1e3)};
    expect_passive(Sum<Stone, Binder<3>>{stone, binder}, radius, loop, dice, "stones in shells",
                   seed);
  }
}

TEST(passivity, stones_that_lose_stiffness_create_no_energy) {
  // A broken stone whose clamp goes while it is pressed and rubbed, on random paths.
  for (int seed = 0; seed < loops; ++seed) {
    Dice dice(seed);
    const double radius = dice.decade(1e-3, 1e-2), depth = radius * dice.decade(1e-5, 1e-2);
    const Fracture<Stone> law = {any_stone<Stone>(dice, 0)};
    const Loop loop = {0.5 * depth, depth, depth, 1e-3, dice.decade(0.1, 9)};
    expect_passive(law, radius, loop, dice, "stones that break", seed);
  }
}

TEST(passivity, a_stone_that_breaks_under_load_creates_no_energy) {
  // From the law: softening at constant overlap lets go of force and of what is stored; work put in
  // less work taken out stays positive while a stone softens step by step under load.
  const Stone stone = {{3.8e10}, 8e9, 0.7};
  OneContact<Fracture<Stone>> contact({stone}, 1e-3, 1e-3);
  constexpr int steps = 1000;
  double work = 0, push = 0;
  Vec3d shear = {0, 0, 0};
  const auto drive = [&](double from, double to, double slide, bool softening) {
    for (int n = 1; n <= steps; ++n) {
      if (softening) contact.soften(1 + 9.0 * n / steps);
      const double h = from + (to - from) * n / steps;
      const Vec3d ds = {slide / steps, 0, 0};
      const auto now = contact.move(h, 1e-6, ds);
      work += 0.5 * (push + now.push) * (to - from) / steps - 0.5 * dot(shear + now.shear, ds);
      push = now.push;
      shear = now.shear;
    }
  };
  drive(0, 10e-6, 0, false);
  drive(10e-6, 10e-6, 3e-6, false);
  const double put_in = work, pressed = push, sheared = norm(shear);
  drive(10e-6, 10e-6, 0, true);
  EXPECT_NEAR(push, 0.1 * pressed, 1e-12 * pressed);
  EXPECT_NEAR(norm(shear), 0.1 * sheared, 1e-11 * sheared);  // rounding of 1000 steps
  drive(10e-6, 10e-6, -3e-6, false);
  drive(10e-6, 0, 0, false);
  EXPECT_GT(work, 0.89 * put_in);  // a tenth of the stiffness gives back a tenth, and 1 % of slip
}

}  // namespace
}  // namespace dem
