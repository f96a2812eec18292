#include "apps/forecast.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// Of a bed that nothing is to be said against.
apps::BedForecast harmless() {
  apps::BedForecast told = {};
  told.stone_count = 5000;
  told.loose_step = told.loaded_step = 1;
  told.inertial_number = 1e-4;
  told.quasi_static = 4e-4;
  told.widths = 10;
  told.container = "box";
  told.to_be_more_static = "press harder";
  return told;
}

std::vector<std::string> warnings(const apps::BedForecast& told,
                                  const apps::NumericsScene& numerics = {}) {
  std::vector<std::string> lines = apps::forecast_lines(told, numerics);
  std::erase_if(lines, [](const std::string& line) { return !line.starts_with("warning: "); });
  return lines;
}

TEST(forecast, warns_of_stones_that_are_not_those_of_the_sieve_table) {
  // Our choice: beyond 5 percentage points.
  apps::BedForecast told = harmless();
  told.fitted = told.drawn = {8e-3, 0.60, 0.649};
  EXPECT_THAT(
      apps::forecast_lines(told, {}),
      Contains(AllOf(StartsWith("sieve table"), HasSubstr("64.9 % instead of 60.0 % pass 8 mm"))));
  EXPECT_THAT(warnings(told), IsEmpty());
  told.drawn = {11.2e-3, 0.95, 1};
  EXPECT_THAT(warnings(told),
              ElementsAre(AllOf(HasSubstr("too few stones for the sieve table (5000)"),
                                HasSubstr("100.0 % instead of 95.0 %"))));
  told.fitted = {4e-3, 0.55, 0.434};
  EXPECT_THAT(warnings(told), ElementsAre(AllOf(HasSubstr("43.4 % instead of 55.0 % pass 4 mm"),
                                                HasSubstr("distribution = \"log_linear\""))));
}

TEST(forecast, names_the_mass_scale_that_would_be_quasi_static) {
  // The inertial number goes with the root of the mass scale: 1000 (4 / 20)^2 = 40.
  apps::BedForecast told = harmless();
  apps::NumericsScene numerics;
  numerics.mass_scale = 1000;
  told.inertial_number = 2e-3;
  EXPECT_THAT(warnings(told, numerics), ElementsAre(HasSubstr("(40 would be)")));
  told.inertial_number = 1.1e-2;
  EXPECT_THAT(warnings(told, numerics), ElementsAre(HasSubstr("1 would be quasi-static")));
}

TEST(forecast, knows_that_no_mass_scale_may_be_low_enough) {
  // 1000 (4 / 130)^2 = 0.95, less than the true inertia.
  apps::BedForecast told = harmless();
  apps::NumericsScene numerics;
  numerics.mass_scale = 1000;
  told.inertial_number = 1.3e-2;
  EXPECT_THAT(warnings(told, numerics),
              ElementsAre(AllOf(HasSubstr("no numerics.mass_scale is low enough"),
                                HasSubstr("press harder"))));
  numerics.mass_scale = 1;
  told.inertial_number = 5e-4;
  EXPECT_THAT(warnings(told, numerics), ElementsAre(HasSubstr("no numerics.mass_scale")));
}

TEST(forecast, warns_of_bonds_longer_than_any_stone) {
  apps::BedForecast told = harmless();
  EXPECT_THAT(apps::forecast_lines(told, {}), testing::Not(Contains(StartsWith("bonds"))));
  told.largest = 11.2e-3;
  told.shortest_bond = 2.6e-3;
  told.longest_bond = 4e-3;
  EXPECT_THAT(apps::forecast_lines(told, {}),
              Contains(AllOf(StartsWith("bonds"), HasSubstr("2.6 to 4.0 mm"))));
  EXPECT_THAT(warnings(told), IsEmpty());
  told.longest_bond = 11.3e-3;
  EXPECT_THAT(warnings(told), ElementsAre(HasSubstr("lower binder.bond_energy")));
}

TEST(forecast, warns_of_a_container_by_its_name) {
  apps::BedForecast told = harmless();
  told.widths = 3;
  EXPECT_THAT(warnings(told), ElementsAre(HasSubstr("the box is small for the largest stone")));
}

TEST(forecast, advises_a_safety_that_it_does_not_warn_of) {
  // 0.5 of the scene itself is taken without a word, and named as what to take above it.
  apps::NumericsScene numerics;
  numerics.safety = 0.5;
  EXPECT_THAT(warnings(harmless(), numerics), IsEmpty());
  numerics.safety = 0.504;
  EXPECT_THAT(warnings(harmless(), numerics),
              ElementsAre(AllOf(HasSubstr("safety = 0.504 is"), HasSubstr("take 0.5 or less"))));
}

}  // namespace
