// Quantities as users write them ("600 kPa", "15 mm/min", "6.5 %") and their values in SI.
// The unit tables are those of UDUNITS-2; the revolution, "rev", is one count here,
// and "rpm" is "rev/min".
#pragma once

#include <memory>
#include <optional>
#include <string>

struct ut_system;
union ut_unit;

namespace apps {

struct Quantity {
  double value;
  std::string unit;  // empty: none was written
};

// A number, then a unit; nothing if the text does not begin with a number.
std::optional<Quantity> parse_quantity(const std::string& text);

class UnitSystem {
 public:
  UnitSystem();  // throws OutputError where the unit tables cannot be read

  bool knows(const std::string& unit) const;

  // The same quantity in another unit; nothing if either is unknown or the dimensions differ.
  // An angle is a dimension of its own: "deg/s" does not convert to "rev/s".
  std::optional<double> convert(double value, const std::string& from, const std::string& to) const;

 private:
  struct Free {
    void operator()(ut_system* system) const;
    void operator()(ut_unit* unit) const;
  };
  using UnitPointer = std::unique_ptr<ut_unit, Free>;

  UnitPointer parse(const std::string& unit) const;  // null if unknown

  std::unique_ptr<ut_system, Free> system_;
};

}  // namespace apps
