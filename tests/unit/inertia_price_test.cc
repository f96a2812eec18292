#include "apps/inertia_price.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using testing::HasSubstr;

TEST(inertia_price, is_told_by_what_was_measured) {
  EXPECT_DOUBLE_EQ(apps::densification_lost(3.0e-4), 0.24);
  // Between two of them, in the middle of the logarithms.
  EXPECT_NEAR(apps::densification_lost(std::sqrt(2.2e-4 * 3.0e-4)), (0.13 + 0.24) / 2, 1e-12);
  EXPECT_THAT(apps::inertia_line(3.0e-4), HasSubstr("about 24 %"));
}

TEST(inertia_price, is_told_no_further_than_it_was_measured) {
  EXPECT_EQ(apps::densification_lost(1e-6), 0);
  EXPECT_EQ(apps::densification_lost(1), 0.83);
  EXPECT_THAT(apps::inertia_line(1e-6), HasSubstr("less of the densification than"));
  EXPECT_THAT(apps::inertia_line(1), HasSubstr("more than 83 %"));
}

TEST(inertia_price, takes_more_the_more_there_is) {
  double before = 0;
  for (double number = 7e-5; number < 1e-2; number *= 1.1) {
    EXPECT_GE(apps::densification_lost(number), before);
    before = apps::densification_lost(number);
  }
}

}  // namespace
