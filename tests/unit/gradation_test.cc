#include "dem/gradation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dem {
namespace {

// SMA 11 S, means of the limits of TL Asphalt-StB 07.
const SieveTable sma = {{0.063e-3, 2e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3},
                        {0.10, 0.25, 0.40, 0.575, 0.95, 1}};
// A dense AC 11, for which half of the stones are fines.
const SieveTable ac = {{0.063e-3, 2e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3},
                       {0.08, 0.50, 0.66, 0.775, 0.95, 1}};
constexpr double cut = 2e-3;  // [m]

double mean_volume(const std::vector<double>& diameters) {
  double sum = 0;
  for (const double d : diameters) sum += std::numbers::pi / 6 * d * d * d;
  return sum / static_cast<double>(diameters.size());
}

// Largest distance between the volume curve of rising diameters and C(d).
double volume_distance(const std::vector<double>& diameters, const SizeDistribution& wanted) {
  const double total = mean_volume(diameters) * static_cast<double>(diameters.size());
  double finer = 0, distance = 0;
  for (const double d : diameters) {
    distance = std::max(distance, std::abs(finer / total - wanted.mass_finer(d)));
    finer += std::numbers::pi / 6 * d * d * d;
    distance = std::max(distance, std::abs(finer / total - wanted.mass_finer(d)));
  }
  return distance;
}

// Between the fit and C(d).
double largest_error(const TruncatedNormal& fit, const SieveTable& table) {
  const Departure largest = largest_departure(table, truncated_normal(fit));
  return std::abs(largest.found - largest.asked) / (1 - passing_at(table, fit.smallest));
}

TEST(gradation, log_linear_curves_have_the_mean_stones_of_an_independent_computation) {
  // Reference: f_n = f_m / d^3 integrated piece by piece in Python. Tolerance: its last digit.
  const SizeDistribution sma_stones = log_linear(sma, cut);
  EXPECT_NEAR(sma_stones.mean_diameter(), 3.55e-3, 0.005e-3);
  EXPECT_NEAR(sma_stones.mean_volume(), 57.0e-9, 0.05e-9);
  EXPECT_NEAR(sma_stones.quantile(0.5), 2.64e-3, 0.005e-3);
  const SizeDistribution ac_stones = log_linear(ac, cut);
  EXPECT_NEAR(ac_stones.mean_diameter(), 3.20e-3, 0.005e-3);
  EXPECT_NEAR(ac_stones.mean_volume(), 38.4e-9, 0.05e-9);
  EXPECT_NEAR(ac_stones.quantile(0.5), 2.57e-3, 0.005e-3);
}

TEST(gradation, the_number_curve_is_the_integral_of_the_mass_density_over_the_volume) {
  // Reference: midpoint sums of dC / d^3 over 20,000 pieces, whose error falls as 1/pieces^2.
  const SizeDistribution stones = log_linear(sma, cut);
  constexpr int pieces = 20000;
  const double ratio = std::pow(stones.largest() / stones.smallest(), 1.0 / pieces);
  std::vector<double> number = {0};
  double d = stones.smallest();
  for (int k = 0; k < pieces; ++k, d *= ratio) {
    const double middle = d * std::sqrt(ratio);
    number.push_back(number.back() + (stones.mass_finer(d * ratio) - stones.mass_finer(d)) /
                                         (middle * middle * middle));
  }
  d = stones.smallest();
  for (int k = 0; k <= pieces; ++k, d *= ratio) {
    ASSERT_NEAR(stones.number_finer(d), number[k] / number.back(), 1e-6);
  }
}

TEST(gradation, the_truncated_normal_is_the_least_squares_fit_of_an_independent_computation) {
  // Reference: scipy least squares on C(d) at the sieves. Tolerance: its last digit.
  const TruncatedNormal sma_fit = fit_truncated_normal(sma, cut);
  EXPECT_NEAR(sma_fit.mean, 8.10e-3, 0.005e-3);
  EXPECT_NEAR(sma_fit.deviation, 2.51e-3, 0.005e-3);
  EXPECT_NEAR(largest_error(sma_fit, sma), 0.047, 0.0005);
  const TruncatedNormal ac_fit = fit_truncated_normal(ac, cut);
  EXPECT_NEAR(ac_fit.mean, 6.93e-3, 0.005e-3);
  EXPECT_NEAR(ac_fit.deviation, 3.64e-3, 0.005e-3);
  EXPECT_NEAR(largest_error(ac_fit, ac), 0.033, 0.0005);
}

TEST(gradation, the_truncated_normal_has_the_number_curve_of_an_independent_computation) {
  // Reference: f_m / d^3 of the fits integrated in Python. Tolerance: its last digit.
  const std::vector<double> diameter = {2.5e-3, 3e-3, 4e-3, 5.6e-3, 8e-3, 11.2e-3};
  const std::vector<double> sma_finer = {0.112, 0.208, 0.375, 0.609, 0.862, 0.986};
  const std::vector<double> ac_finer = {0.273, 0.448, 0.663, 0.839, 0.950, 0.993};
  const SizeDistribution sma_stones = truncated_normal(fit_truncated_normal(sma, cut));
  const SizeDistribution ac_stones = truncated_normal(fit_truncated_normal(ac, cut));
  for (std::size_t k = 0; k < diameter.size(); ++k) {
    EXPECT_NEAR(sma_stones.number_finer(diameter[k]), sma_finer[k], 0.0006);
    EXPECT_NEAR(ac_stones.number_finer(diameter[k]), ac_finer[k], 0.0006);
  }
  EXPECT_NEAR(sma_stones.mean_diameter(), 5.22e-3, 0.005e-3);
  EXPECT_NEAR(sma_stones.mean_volume(), 125e-9, 0.5e-9);
  EXPECT_NEAR(ac_stones.mean_diameter(), 3.87e-3, 0.005e-3);
  EXPECT_NEAR(ac_stones.mean_volume(), 60.6e-9, 0.05e-9);
}

TEST(gradation, a_normal_cut_far_out_in_either_tail_keeps_its_shape) {
  // Reference: midpoint sums of exp(-((d - mean) / deviation)^2 / 2), scaled by its largest value.
  for (const double mean : {-40e-3, -8e-3, 0.0, 9e-3, 20e-3, 60e-3}) {
    const TruncatedNormal normal = {mean, 1e-3, 2e-3, 16e-3};
    const double top = std::clamp(mean, normal.smallest, normal.largest);
    const auto density = [&](double d) {
      const double a = (d - mean) / normal.deviation, b = (top - mean) / normal.deviation;
      return std::exp((b * b - a * a) / 2);
    };
    constexpr int pieces = 200000;
    const double step = (normal.largest - normal.smallest) / pieces;
    double sum = 0;
    std::vector<double> finer = {0};
    for (int k = 0; k < pieces; ++k) {
      sum += density(normal.smallest + (k + 0.5) * step);
      finer.push_back(sum);
    }
    for (int k = 0; k <= pieces; k += 100) {
      // The sum errs by (slope step)^2 / 24, below 3e-7 of itself for a slope of 58 per mm.
      ASSERT_NEAR(normal.mass_finer(normal.smallest + k * step), finer[k] / sum, 1e-6) << mean;
    }
  }
}

TEST(gradation, a_curve_that_no_normal_fits_still_gives_a_rising_distribution) {
  // From the definition: whatever the fit, the shares rise from 0 to 1 over the sieve range.
  const SieveTable falling = {{2e-3, 2.1e-3, 4e-3, 8e-3, 16e-3}, {0, 0.9, 0.99, 0.995, 1}};
  const SieveTable gap = {{2e-3, 4e-3, 8e-3, 11.2e-3, 16e-3}, {0, 0.5, 0.5, 0.5, 1}};
  const SieveTable step = {{2e-3, 7.9e-3, 8e-3, 16e-3}, {0, 0, 1, 1}};
  const SieveTable straight = {{2e-3, 16e-3}, {0, 1}};
  for (const SieveTable& table : {falling, gap, step, straight}) {
    const SizeDistribution stones = truncated_normal(fit_truncated_normal(table, cut));
    double finer = 0;
    for (int k = 0; k <= 100; ++k) {
      const double d = stones.smallest() + k / 100.0 * (stones.largest() - stones.smallest());
      EXPECT_GE(stones.mass_finer(d), finer);
      finer = stones.mass_finer(d);
    }
    EXPECT_EQ(finer, 1);
  }
}

TEST(gradation, a_higher_cut_is_the_same_curve_without_its_small_stones) {
  // From the definition of C(d): C_3(d) = (C_2(d) - C_2(3 mm)) / (1 - C_2(3 mm)).
  const SizeDistribution at_2 = log_linear(sma, 2e-3), at_3 = log_linear(sma, 3e-3);
  const double removed = at_2.mass_finer(3e-3);
  for (double d = 3e-3; d < 16e-3; d += 0.1e-3) {
    EXPECT_NEAR(at_3.mass_finer(d), (at_2.mass_finer(d) - removed) / (1 - removed), 1e-14);
  }
}

TEST(gradation, the_quantile_is_the_inverse_of_the_number_curve) {
  // From the definition; a few roundings of 1 / d^3 times the steepness of the curve.
  for (const SizeDistribution& stones :
       {log_linear(sma, cut), truncated_normal(fit_truncated_normal(sma, cut))}) {
    EXPECT_EQ(stones.quantile(0), stones.smallest());
    EXPECT_EQ(stones.quantile(1), stones.largest());
    for (double u = 0.0005; u < 1; u += 0.001) {
      EXPECT_NEAR(stones.number_finer(stones.quantile(u)), u, 1e-12);
    }
  }
}

TEST(gradation, drawn_stones_reproduce_the_sieve_curve_by_volume) {
  // Kolmogorov distance below 0.02: the largest stone alone is 1 % of the volume.
  for (const SizeDistribution& stones :
       {log_linear(sma, cut), truncated_normal(fit_truncated_normal(sma, cut)), log_linear(ac, cut),
        truncated_normal(fit_truncated_normal(ac, cut))}) {
    for (int seed = 0; seed < 20; ++seed) {
      const std::vector<double> diameters = draw_diameters(stones, 5000, seed);
      ASSERT_TRUE(std::ranges::is_sorted(diameters));
      EXPECT_LT(volume_distance(diameters, stones), 0.02);
      EXPECT_NEAR(mean_volume(diameters) / stones.mean_volume(), 1, 0.02);
    }
  }
}

TEST(gradation, a_gap_in_the_curve_is_followed_by_log_linear_pieces_and_lost_by_a_normal) {
  // Asked: the table itself, which holds 60 % at 8 mm. Found: scipy least squares, to its last
  // digit.
  const SieveTable gap = {{2e-3, 4e-3, 5.6e-3, 8e-3, 11.2e-3, 16e-3, 22.4e-3},
                          {0.20, 0.55, 0.58, 0.60, 0.95, 1, 1}};
  const Departure lost = largest_departure(gap, truncated_normal(fit_truncated_normal(gap, cut)));
  EXPECT_EQ(lost.sieve, 8e-3);
  EXPECT_EQ(lost.asked, 0.60);
  EXPECT_NEAR(lost.found, 0.7377, 0.0001);
  const Departure kept = largest_departure(gap, log_linear(gap, cut));
  EXPECT_NEAR(kept.found, kept.asked, 1e-15);
}

TEST(gradation, stones_depart_from_their_table_by_what_they_weigh) {
  // By hand: of diameters 3 and 6 mm the smaller is 27 / (27 + 216) = 1 / 9 of the mass of the
  // stones, which are 0.75 of the mix; (0.25 + 0.75 / 9) - 0.7 is farther off than 1 - 0.8.
  const SieveTable table = {{2e-3, 5e-3, 8e-3, 11e-3}, {0.25, 0.7, 0.8, 1}};
  const Departure departure = largest_departure(table, cut, {3e-3, 6e-3});
  EXPECT_EQ(departure.sieve, 5e-3);
  EXPECT_EQ(departure.asked, 0.7);
  EXPECT_NEAR(departure.found, 1.0 / 3, 1e-15);
}

TEST(gradation, the_seed_alone_decides_the_stones) {
  // From the promise: same seed, same bits.
  const SizeDistribution stones = log_linear(sma, cut);
  EXPECT_EQ(draw_diameters(stones, 100, 7), draw_diameters(stones, 100, 7));
  EXPECT_NE(draw_diameters(stones, 100, 7), draw_diameters(stones, 100, 8));
}

}  // namespace
}  // namespace dem
