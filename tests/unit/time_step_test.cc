#include "dem/time_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dem {
namespace {

constexpr double safety = 0.2, largest = 1e-5;

double limit_of(double rate) {
  return safety / std::sqrt(rate);
}

TEST(step_clock, it_starts_at_its_largest_step_and_stays_there_while_nothing_is_stiff) {
  // By definition.
  StepClock clock(safety, largest);
  EXPECT_EQ(clock.step(), largest);
  EXPECT_FALSE(clock.look(0));
  EXPECT_FALSE(clock.look(1e-3));
  EXPECT_EQ(clock.step(), largest);
}

TEST(step_clock, a_stiffer_contact_brings_the_step_down_at_once) {
  // By definition: never above safety sqrt(inertia / k), and at most one rung, 2^(1/4), below it.
  for (double rate = 1e9; rate < 1e20; rate *= 3.7) {
    StepClock clock(safety, largest);
    EXPECT_TRUE(clock.look(rate));
    EXPECT_LE(clock.step(), limit_of(rate) * (1 + 1e-12));
    EXPECT_GE(clock.step(), limit_of(rate) / std::pow(2, 0.25) * (1 - 1e-12));
  }
}

TEST(step_clock, the_step_goes_up_one_rung_at_a_time_and_back_to_the_largest) {
  // By definition.
  StepClock clock(safety, largest);
  clock.look(1e14);
  double before = clock.step();
  int looks = 0;
  while (clock.step() < largest) {
    EXPECT_TRUE(clock.look(0));
    EXPECT_LE(clock.step(), before * std::pow(2, 0.25) * (1 + 1e-12));
    before = clock.step();
    ASSERT_LT(++looks, 100);
  }
  EXPECT_EQ(clock.step(), largest);
  EXPECT_FALSE(clock.look(0));
}

TEST(step_clock, a_steady_bed_keeps_its_step) {
  // By definition: contacts that stiffen and soften by less than a rung change nothing.
  StepClock clock(safety, largest);
  clock.look(1e14);
  const double step = clock.step();
  for (int n = 0; n < 100; ++n) EXPECT_FALSE(clock.look(1e14 * (n % 2 ? 1.0 : 0.8)));
  EXPECT_EQ(clock.step(), step);
}

TEST(step_clock, the_step_is_never_above_what_the_stiffest_contact_allows) {
  // By definition, over a wandering stiffness.
  StepClock clock(safety, largest);
  for (int n = 0; n < 2000; ++n) {
    const double rate = std::pow(10.0, 13 + 3 * std::sin(0.05 * n) + std::sin(1.7 * n));
    clock.look(rate);
    EXPECT_LE(clock.step(), limit_of(rate) * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace dem
