#include "dem/mix_design.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dem/gradation.h"
#include "dem/particle_store.h"

namespace dem {
namespace {

std::vector<double> radii_of(const SizeDistribution& stones) {
  std::vector<double> radii = draw_diameters(stones, 20000, 1);
  for (double& r : radii) r /= 2;
  return radii;
}

TEST(mix_design, the_binder_phase_of_sma_and_ac_has_the_shares_of_the_recipes) {
  // Reference: volumes worked out by hand, three digits.
  const BinderPhase sma = binder_phase({0.066, 1020, 2700, 0.25});
  EXPECT_NEAR(sma.volume_ratio, 0.583, 0.0005);
  EXPECT_NEAR(sma.bitumen_fraction, 0.43, 0.005);
  const BinderPhase ac = binder_phase({0.060, 1020, 2700, 0.50});
  EXPECT_NEAR(ac.volume_ratio, 1.34, 0.005);
  EXPECT_NEAR(ac.bitumen_fraction, 0.25, 0.005);
  const BinderPhase finer_ac = binder_phase({0.060, 1020, 2700, 0.41});
  EXPECT_NEAR(finer_ac.volume_ratio, 0.98, 0.005);
  EXPECT_NEAR(finer_ac.bitumen_fraction, 0.29, 0.005);
}

TEST(mix_design, the_volumes_of_a_kilogram_of_mix_add_up) {
  // Conservation: masses of bitumen, fines and stones rebuilt from the two shares.
  const MixDesign mix = {0.066, 1020, 2650, 0.25};
  const BinderPhase phase = binder_phase(mix);
  const double stones = (1 - mix.binder_content) * (1 - mix.fines) / mix.stone_density;
  const double bitumen = phase.bitumen_fraction * phase.volume_ratio * stones;
  const double fines = (1 - phase.bitumen_fraction) * phase.volume_ratio * stones;
  EXPECT_NEAR(bitumen * mix.bitumen_density, mix.binder_content, 1e-15);
  EXPECT_NEAR((stones + fines) * mix.stone_density, 1 - mix.binder_content, 1e-15);
}

TEST(mix_design, a_mix_without_binder_and_fines_has_no_binder_phase) {
  // The limit of the definition.
  const BinderPhase dry = binder_phase({0, 1020, 2650, 0});
  EXPECT_EQ(dry.volume_ratio, 0);
  EXPECT_EQ(dry.bitumen_fraction, 0);
  const std::vector<double> radii = {1e-3, 2e-3};
  EXPECT_EQ(shell_thickness(radii, 0), 0);
}

TEST(mix_design, equal_stones_have_the_shell_of_the_closed_form) {
  // (R + t)^3 = (1 + r) R^3; t is solved to 1e-12 of itself.
  for (const double ratio : {1e-6, 0.1, 0.583, 1.34, 100.0}) {
    const std::vector<double> radii(7, 2.5e-3);
    const double t = 2.5e-3 * std::expm1(std::log1p(ratio) / 3);
    EXPECT_NEAR(shell_thickness(radii, ratio) / t, 1, 2e-12);
  }
}

TEST(mix_design, the_shells_of_a_gradation_hold_the_binder_phase) {
  // Conservation: sum((R + t)^3 - R^3) = r sum(R^3), to the rounding of 20,000 terms.
  const SieveTable sma = {{0.063e-3, 2e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3},
                          {0.10, 0.25, 0.40, 0.575, 0.95, 1}};
  const std::vector<double> radii = radii_of(log_linear(sma, 2e-3));
  const double t = shell_thickness(radii, 0.583);
  double shells = 0, stones = 0;
  for (const double r : radii) {
    shells += std::pow(r + t, 3) - std::pow(r, 3);
    stones += std::pow(r, 3);
  }
  EXPECT_NEAR(shells / stones / 0.583, 1, 1e-11);
}

TEST(mix_design, stones_with_their_shells_weigh_what_the_mix_weighs) {
  // Conservation: in a kilogram of mix the modelled stones are (1 - content) (1 - fines).
  const MixDesign mix = {0.066, 1020, 2650, 0.25};
  const SieveTable sma = {{0.063e-3, 2e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3},
                          {0.10, 0.25, 0.40, 0.575, 0.95, 1}};
  const std::vector<double> radii = radii_of(log_linear(sma, 2e-3));
  const BinderPhase phase = binder_phase(mix);
  const Layers coated = {mix.stone_density, shell_thickness(radii, phase.volume_ratio),
                         phase.density};
  double with = 0, without = 0;
  for (const double r : radii) {
    with += coated.mass(r);
    without += Layers{mix.stone_density}.mass(r);
  }
  EXPECT_NEAR(without / with / ((1 - mix.binder_content) * (1 - mix.fines)), 1, 1e-11);
}

TEST(mix_design, a_coated_stone_turns_as_a_ball_within_a_shell) {
  // Closed forms: 2/5 (R + t)^2 of one stuff, 2/3 R^2 of a thin shell with nothing within (to t /
  // R).
  const double r = 3e-3, t = 1e-3;
  EXPECT_NEAR((Layers{2650, t, 2650}.turning(r)) / (0.4 * (r + t) * (r + t)), 1, 1e-12);
  EXPECT_NEAR((Layers{2650, t, 0}.turning(r)) / (0.4 * r * r), 1, 1e-12);
  EXPECT_NEAR((Layers{0, 1e-6 * r, 2650}.turning(r)) / (2.0 / 3 * r * r), 1, 1e-5);
}

TEST(mix_design, sma_has_the_shells_of_an_independent_computation) {
  // Reference: 0.51 mm (log-linear) and 0.59 mm (truncated normal), computed in Python.
  const SieveTable sma = {{0.063e-3, 2e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3},
                          {0.10, 0.25, 0.40, 0.575, 0.95, 1}};
  const double ratio = binder_phase({0.066, 1020, 2700, passing_at(sma, 2e-3)}).volume_ratio;
  EXPECT_NEAR(shell_thickness(radii_of(log_linear(sma, 2e-3)), ratio), 0.51e-3, 0.005e-3);
  const SizeDistribution normal = truncated_normal(fit_truncated_normal(sma, 2e-3));
  EXPECT_NEAR(shell_thickness(radii_of(normal), ratio), 0.59e-3, 0.005e-3);
}

}  // namespace
}  // namespace dem
