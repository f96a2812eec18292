#include "apps/units.h"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using apps::parse_quantity;
using apps::UnitSystem;

// A conversion is one or two multiplications: a few units in the last place.
constexpr double rounding = 1e-14;

struct Conversion {
  double value;
  const char* from;
  const char* to;
  double expected;
};

TEST(units, quantities_of_a_scene_convert_to_si) {
  // The definitions of the units: BIPM, The International System of Units (2019), tables 4 to 8.
  const UnitSystem units;
  const Conversion conversions[] = {
      {600, "kPa", "Pa", 600e3},
      {0.6, "N/mm2", "Pa", 600e3},
      {74, "GPa", "Pa", 74e9},
      {15, "mm/min", "m/s", 15e-3 / 60},
      {1, "deg", "rad", std::numbers::pi / 180},
      {1, "°", "rad", std::numbers::pi / 180},
      {0.01, "J/mm2", "J/m2", 1e4},
      {0.01, "J/mm^2", "J/m2", 1e4},
      {110, "degC", "K", 383.15},
      {2.65, "g/cm3", "kg/m3", 2650},
      {244, "mm3", "m3", 244e-9},
      {6.5, "%", "1", 0.065},
      {1, "ms", "s", 1e-3},
  };
  for (const Conversion& c : conversions) {
    const auto converted = units.convert(c.value, c.from, c.to);
    ASSERT_TRUE(converted) << c.from;
    EXPECT_NEAR(*converted, c.expected, rounding * c.expected) << c.value << ' ' << c.from;
  }
}

TEST(units, a_revolution_is_one_count) {
  // 30 rpm = 30 rev/min = 0.5 rev/s = 0.5 Hz. Of UDUNITS-2 alone, 30 rpm would be 3.14 /s.
  const UnitSystem units;
  EXPECT_NEAR(units.convert(30, "rev/min", "rev/s").value(), 0.5, rounding);
  EXPECT_NEAR(units.convert(30, "rpm", "rev/s").value(), 0.5, rounding);
  EXPECT_DOUBLE_EQ(units.convert(0.5, "rev/s", "1/s").value(), 0.5);
  EXPECT_DOUBLE_EQ(units.convert(0.5, "/s", "rev/s").value(), 0.5);
  EXPECT_DOUBLE_EQ(units.convert(0.5, "Hz", "rev/s").value(), 0.5);
}

TEST(units, an_angle_is_not_a_pure_number) {
  // By value 180 deg/s would be 3.14 /s, but it is half a revolution a second.
  const UnitSystem units;
  EXPECT_FALSE(units.convert(180, "deg/s", "rev/s"));
  EXPECT_FALSE(units.convert(1, "deg", "1"));
  EXPECT_FALSE(units.convert(1, "%", "rad"));
}

TEST(units, another_dimension_does_not_convert) {
  // Pressure, force and length differ in their exponents of metre and kilogram.
  const UnitSystem units;
  EXPECT_TRUE(units.knows("kN"));
  EXPECT_FALSE(units.convert(600, "kN", "Pa"));
  EXPECT_FALSE(units.convert(600, "kPa", "m"));
}

TEST(units, an_unknown_unit_is_not_guessed) {
  // UDUNITS-2 would read "5 kPa" as a scaled unit, so that 600 5 kPa passed for 3000 kPa.
  const UnitSystem units;
  for (const char* unit : {"kpascalz", "Mpa", "5 kPa", "kPa 5", "(5 kPa)", "-5 kPa", ".500 kPa",
                           "1/5 Pa", "kPa extra", "mm//s"}) {
    EXPECT_FALSE(units.knows(unit)) << unit;
    EXPECT_FALSE(units.convert(1, unit, "Pa")) << unit;
  }
}

TEST(units, exponents_are_no_second_numbers) {
  const UnitSystem units;
  EXPECT_NEAR(*units.convert(1, "N mm-2", "Pa"), 1e6, 1e-6);
  EXPECT_NEAR(*units.convert(1, "N/mm2", "Pa"), 1e6, 1e-6);
  EXPECT_NEAR(*units.convert(1, "N mm^-2", "Pa"), 1e6, 1e-6);
  EXPECT_NEAR(*units.convert(1, "N.mm-2", "Pa"), 1e6, 1e-6);
  EXPECT_NEAR(*units.convert(3, "1/min", "1/s"), 0.05, 1e-15);
}

TEST(units, a_quantity_is_a_number_and_a_unit) {
  // The grammar of units.h, with the exact decimals that were written.
  const auto with_space = parse_quantity(" 600 kPa ");
  ASSERT_TRUE(with_space);
  EXPECT_EQ(with_space->value, 600);
  EXPECT_EQ(with_space->unit, "kPa");
  const auto without_space = parse_quantity("+1.5e3mm/min");
  ASSERT_TRUE(without_space);
  EXPECT_EQ(without_space->value, 1500);
  EXPECT_EQ(without_space->unit, "mm/min");
  const auto bare = parse_quantity("-3");
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->value, -3);
  EXPECT_EQ(bare->unit, "");
  EXPECT_FALSE(parse_quantity("kPa 600"));
  EXPECT_FALSE(parse_quantity("+-3"));
  EXPECT_FALSE(parse_quantity(""));
}

}  // namespace
