// A check that is written down: it asserts like any expectation and, where the environment variable
// GYRATORY_CHECKS names a file, adds a row to it. tests/physics/checks.py makes a page of the rows.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

namespace checks {

// How far the computed value may be from its reference, or on which side of it.
struct Tolerance {
  enum class Kind { relative, absolute, at_least, at_most } kind;
  double size = 0;
};
constexpr Tolerance relative(double share) {
  return {Tolerance::Kind::relative, share};
}
constexpr Tolerance absolute(double size) {
  return {Tolerance::Kind::absolute, size};
}
inline constexpr Tolerance at_least = {Tolerance::Kind::at_least};
inline constexpr Tolerance at_most = {Tolerance::Kind::at_most};

inline constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

struct Check {
  std::string quantity, unit;
  double computed, reference;
  Tolerance tolerance;
  std::string source;   // of the reference: closed form, author and year, or how it was computed
  double at = nowhere;  // where on a curve, in the unit that the quantity names
};

inline bool holds(const Check& check) {
  const double error = std::abs(check.computed - check.reference);
  switch (check.tolerance.kind) {
    case Tolerance::Kind::relative:
      return error <= check.tolerance.size * std::abs(check.reference);
    case Tolerance::Kind::absolute:
      return error <= check.tolerance.size;
    case Tolerance::Kind::at_least:
      return check.computed >= check.reference;
    default:
      return check.computed <= check.reference;
  }
}

inline void write_row(const Check& check, const std::string& file) {
  constexpr const char* kinds[] = {"relative", "absolute", "at_least", "at_most"};
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::ofstream out(file, std::ios::app);
  out.precision(12);
  out << test.test_suite_name() << ',' << test.name() << ",\"" << check.quantity << "\","
      << check.unit << ',' << check.at << ',' << check.computed << ',' << check.reference << ','
      << kinds[static_cast<int>(check.tolerance.kind)] << ',' << check.tolerance.size << ",\""
      << check.source << "\"\n";
}

inline void check(const Check& check) {
  EXPECT_TRUE(holds(check)) << check.quantity << (std::isnan(check.at) ? "" : " at ")
                            << (std::isnan(check.at) ? "" : std::to_string(check.at)) << ": "
                            << check.computed << ' ' << check.unit << " against " << check.reference
                            << ", " << check.source;
  if (const char* file = std::getenv("GYRATORY_CHECKS")) write_row(check, file);
}

}  // namespace checks
