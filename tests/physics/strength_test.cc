#include "dem/strength.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dem/random.h"
#include "tests/physics/check.h"

namespace dem {
namespace {

using checks::absolute, checks::check, checks::relative;

// Of the paper: V_ref = (6.25 mm)^3.
const Weibull granite = {386.5e6, 3.87, 244e-9};
constexpr int draws = 100000;

std::vector<double> strengths(double radius, std::uint64_t seed) {
  std::vector<double> values(draws);
  for (int id = 0; id < draws; ++id) values[id] = strength(granite, radius, seed, id);
  return values;
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + draws / 2);
  return values[draws / 2];
}

TEST(random, numbers_of_two_purposes_and_of_two_draws_know_nothing_of_each_other) {
  // Closed form: 1e5 independent pairs of uniform numbers have a mean of 1/2 and a correlation of
  // 0, which scatter by 1 / sqrt(12 n) and 1 / sqrt(n); four such deviations, fixed seed.
  const auto one = [](int id) { return uniform(1, Purpose::strength, id); };
  const auto another_purpose = [](int id) { return uniform(1, Purpose::size, id); };
  const auto another_draw = [](int id) { return uniform(1, Purpose::strength, id, 1); };
  const auto another_seed = [](int id) { return uniform(1ull << 32 | 1, Purpose::strength, id); };
  const auto next = [](int id) { return uniform(1, Purpose::strength, id + 1); };
  const auto check = [&](auto other) {
    double sum = 0, products = 0;
    for (int id = 0; id < draws; ++id) {
      sum += other(id) - 0.5;
      products += (one(id) - 0.5) * (other(id) - 0.5) * 12;
    }
    EXPECT_NEAR(sum / draws, 0, 4 / std::sqrt(12.0 * draws));
    EXPECT_NEAR(products / draws, 0, 4 / std::sqrt(double(draws)));
  };
  check(another_purpose);
  check(another_draw);
  check(another_seed);
  check(next);
}

TEST(strength, drawn_strengths_follow_the_weibull_curve) {
  // Closed form: Weibull (1939). Kolmogorov (1933): the distance of 1e5 draws exceeds 0.005 with
  // probability 2 exp(-2 n 0.005^2) = 1.3 %; the seeds are fixed.
  for (const double radius : {1e-3, 2.8e-3, 5.6e-3}) {
    std::vector<double> values = strengths(radius, 1);
    std::ranges::sort(values);
    double distance = 0;
    for (int k = 0; k < draws; ++k) {
      const double volume = radius * radius * radius / granite.reference_volume;
      const double share =
          -std::expm1(-volume * std::pow(values[k] / granite.scale, granite.exponent));
      distance = std::max({distance, share - k / double(draws), (k + 1) / double(draws) - share});
    }
    check({"Kolmogorov distance of 1e5 strengths, radius / m", "1", distance, 0, absolute(0.005),
           "Weibull (1939)", radius});
  }
}

TEST(strength, the_median_force_grows_as_the_diameter_to_the_power_of_1_22) {
  // Closed form: F = sigma_F R0^2 ~ D^(2 - 3/m), 2 - 3/3.87 = 1.225. The ids of the two sets
  // differ, so their medians scatter by 0.2 % each, which is 0.002 in the slope.
  std::vector<double> small(draws), large(draws);
  for (int k = 0; k < draws; ++k) {
    small[k] = strength(granite, 1e-3, 1, k) * 0.5e-3 * 0.5e-3;
    large[k] = strength(granite, 5.6e-3, 1, draws + k) * 2.8e-3 * 2.8e-3;
  }
  const double slope = std::log(median(large) / median(small)) / std::log(5.6);
  check({"slope of the median force over the diameter, log-log", "1", slope, 1.22, absolute(0.02),
         "closed form, 2 - 3/m"});
}

TEST(strength, the_median_force_is_that_of_the_closed_form) {
  // Closed form: F = sigma0 (V_ref / R^3 ln 2)^(1/m) R^2 of a stone on a wall, 1455 N at 2 mm and
  // 12,003 N at 11.2 mm; the median of 1e5 draws scatters by 0.1 %.
  check({"median force of stones of 2 mm on a wall", "N", median(strengths(1e-3, 1)) * 1e-3 * 1e-3,
         1455, relative(0.005), "closed form"});
  check({"median force of stones of 11.2 mm on a wall", "N",
         median(strengths(5.6e-3, 1)) * 5.6e-3 * 5.6e-3, 12003, relative(0.005), "closed form"});
}

TEST(strength, a_stone_has_one_strength_whatever_the_order_of_asking) {
  // From the promise: a function of seed and id alone.
  const std::vector<double> forward = strengths(2e-3, 3);
  for (int id = draws - 1; id >= 0; --id) {
    ASSERT_EQ(strength(granite, 2e-3, 3, id), forward[id]);
  }
  EXPECT_NE(strength(granite, 2e-3, 4, 0), forward[0]);
}

}  // namespace
}  // namespace dem
