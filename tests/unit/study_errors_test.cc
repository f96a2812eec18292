#include "apps/study_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/recorder_fixture.h"

namespace apps {
namespace {

TEST(study_errors, are_means_of_pairs_over_the_size_of_the_reference) {
  // Closed form: differences 3 and 1, size 10: error 0.2; deviation sqrt(2), noise t / sqrt(2) of
  // it, with t of one degree of freedom from a table.
  const BySeed reference = {{1, {9}}, {2, {11}}};
  const Judgement j = judge({{1, {12}}, {2, {12}}}, reference, 0);
  EXPECT_TRUE(j.known);
  EXPECT_NEAR(j.error, 0.2, 1e-15);
  EXPECT_NEAR(j.noise, 12.7062 / 10, 1e-5);
  EXPECT_EQ(j.sign, 1);
  EXPECT_FALSE(j.beyond());
  EXPECT_EQ(judge({{1, {5}}, {2, {6}}}, reference, 0).sign, -1);
}

TEST(study_errors, that_all_seeds_share_are_told_however_these_scatter) {
  const Judgement j = judge({{1, {1.5}}, {2, {20.5}}}, {{1, {1}}, {2, {20}}}, 0);
  EXPECT_EQ(j.noise, 0);
  EXPECT_TRUE(j.beyond());
  EXPECT_GT(scatter({{1, {1}}, {2, {20}}}, 0).noise, 1);
}

TEST(study_errors, count_the_seeds_that_both_have) {
  // By definition: the third seed of the reference has no partner, nor the fourth of the setting.
  const BySeed reference = {{1, {10}}, {2, {10}}, {3, {1000}}};
  EXPECT_NEAR(judge({{1, {11}}, {2, {11}}, {4, {0}}}, reference, 0).error, 0.1, 1e-15);
  EXPECT_FALSE(judge({{1, {11}}, {4, {0}}}, reference, 0).known);
}

TEST(study_errors, do_not_lie_in_one_seed) {
  // One stone that breaks in one of six runs is chance, though it breaks in none of the reference.
  BySeed none, one;
  for (int seed = 1; seed <= 6; ++seed) none[seed] = one[seed] = {0};
  one[3] = {1};
  EXPECT_NEAR(judge(one, none, 1).error, 1.0 / 6, 1e-15);
  EXPECT_FALSE(judge(one, none, 1).beyond());
}

TEST(study_errors, of_what_no_run_has_are_at_most_three_per_run_over_their_number) {
  // Poisson: what happens 3 / n times in a run stays away from n runs in exp(-3) of the cases.
  BySeed none, one;
  for (int seed = 1; seed <= 6; ++seed) none[seed] = one[seed] = {0};
  one[3] = {1};
  for (const Judgement& j : {judge(none, none, 2), scatter(none, 2)}) {
    EXPECT_EQ(j.none_in, 6);
    EXPECT_NEAR(j.noise, 3.0 / 6 / 2, 1e-15);
    EXPECT_FALSE(j.beyond());
  }
  EXPECT_EQ(judge(one, none, 1).none_in, 0);
  EXPECT_EQ(judge(one, one, 1).none_in, 0);
  EXPECT_EQ(scatter(one, 1).none_in, 0);
}

TEST(study_errors, of_chance_alone_stay_inside_the_noise_in_19_of_20_cases) {
  // 4000 studies of five seeds of normal numbers; the share scatters by 0.0034.
  std::mt19937 random(7);
  std::normal_distribution<double> normal(10, 1);
  const auto runs = [&] {
    BySeed found;
    for (int seed = 1; seed <= 5; ++seed) found[seed] = {normal(random)};
    return found;
  };
  int beyond = 0;
  for (int k = 0; k < 4000; ++k) beyond += judge(runs(), runs(), 0).beyond();
  EXPECT_NEAR(beyond / 4000.0, 0.05, 0.012);
}

TEST(study_errors, of_chance_alone_scatter_as_the_reference_says) {
  // Closed form: t of ten degrees of freedom x sqrt(2 / 6) x the deviation 1, over the mean 10.
  BySeed reference;
  for (int seed = 1; seed <= 6; ++seed)
    reference[seed] = {10 + std::sqrt(5.0 / 6) * (seed % 2 ? 1 : -1)};
  EXPECT_NEAR(scatter(reference, 0).noise, 2.22814 * std::sqrt(2.0 / 6) / 10, 1e-6);
}

TEST(study_errors, of_curves_are_rms_over_their_points) {
  // Closed form: differences 3 and 4, reference 5 and 5.
  const Judgement j = judge({{1, {8, 9}}, {2, {8, 9}}}, {{1, {5, 5}}, {2, {5, 5}}}, 0);
  EXPECT_NEAR(j.error, std::sqrt(12.5) / 5, 1e-15);
  EXPECT_EQ(j.noise, 0);
  EXPECT_EQ(j.sign, 0);
  EXPECT_TRUE(j.beyond());
}

TEST(study_errors, are_told_in_parts_of_the_least_size_where_the_reference_is_small) {
  // Two broken stones more than none are two, not infinitely many times more.
  EXPECT_EQ(judge({{1, {2}}, {2, {2}}}, {{1, {0}}, {2, {0}}}, 1).error, 2);
}

TEST(study_errors, are_unknown_without_scatter_or_result) {
  EXPECT_FALSE(judge({{1, {1}}}, {{1, {1}}}, 0).known);
  EXPECT_FALSE(judge({}, {{1, {1}}, {2, {2}}}, 0).known);
  EXPECT_FALSE(judge({{1, {}}, {2, {}}}, {{1, {1}}, {2, {2}}}, 0).known);
  EXPECT_FALSE(judge({{1, {}}, {2, {}}}, {{1, {}}, {2, {}}}, 0).known);
  EXPECT_FALSE(judge({{1, {1}}, {2, {2}}, {3, {}}}, {{1, {1}}, {2, {2}}, {3, {3}}}, 0).known);
  EXPECT_FALSE(scatter({{1, {1}}}, 0).known);
}

class StudyResults : public tests::RecorderTest {};

TEST_F(StudyResults, have_the_slope_over_a_logarithm_beyond_the_first_half_unit) {
  // By construction: 3 per decade beyond 0.5, something else before; 1e-4 for the straight lines
  // between rows.
  const Interest interest = {"gyration", {{"slope", "density", Quantity::per_decade, 1}}};
  Recorder recorder(file(), tests::provenance(), {{"gyration", "1"}, {"density", "1"}});
  for (int k = 0; k < 400; ++k) {
    const double gyration = 0.01 * k;
    recorder.append({{gyration, gyration > 0.5 ? 7 + 3 * std::log10(gyration) : -100}});
  }
  recorder.flush();
  const Found found = read_found(file(), interest);
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].size(), 1u);
  EXPECT_NEAR(found[0][0], 3, 1e-4);
}

TEST_F(StudyResults, weigh_every_part_of_a_decade_alike) {
  // By construction: a curve through (1, 0), (10, 1), (100, 4), straight between them over the
  // logarithm, has by least squares over its decades the slope 2; by rows, of which nine tenths lie
  // in its second decade, one near 3.
  const Interest interest = {"gyration", {{"slope", "density", Quantity::per_decade, 1}}};
  Recorder recorder(file(), tests::provenance(), {{"gyration", "1"}, {"density", "1"}});
  for (int k = 100; k <= 10000; ++k) {
    const double decades = std::log10(0.01 * k);
    recorder.append({{0.01 * k, decades < 1 ? decades : 3 * decades - 2}});
  }
  recorder.flush();
  EXPECT_NEAR(read_found(file(), interest)[0][0], 2, 1e-3);
}

}  // namespace
}  // namespace apps
