// The declaration of a scene's parameters: one per parameter, of its name, type, unit, bounds,
// meaning and source. Reading, checking and the printed manual are loops over these declarations.
// The type is that of the member a parameter is read into, the default what that member holds.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/document.h"
#include "apps/units.h"

namespace apps {

struct Unit {
  const char* shown;  // the one a manual shows and in which bounds are declared
  const char* si;     // the one the program computes in
};

struct Bounds {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false, most_excluded = false;
};
inline constexpr Unit pure{"1", "1"};  // a number without dimension
inline constexpr Bounds unbounded{};
inline constexpr Bounds positive{.least = 0, .least_excluded = true};
constexpr Bounds at_least(double least) {
  return {.least = least};
}
constexpr Bounds between(double least, double most) {
  return {.least = least, .most = most};
}
constexpr Bounds within(double least, double most) {
  return {.least = least, .most = most, .least_excluded = true, .most_excluded = true};
}
constexpr Bounds above_zero_to(double most) {
  return {.least = 0, .most = most, .least_excluded = true};
}

enum class Need {
  has_default,
  required,
  optional,
  alternative,  // optional, but what a scene most often gives of several keys that exclude another
};

struct Presence {
  Need need = Need::has_default;
  std::string example{};  // as TOML, where there is no default to show
};
inline Presence required(std::string example) {
  return {Need::required, std::move(example)};
}
inline Presence optional(std::string example) {
  return {Need::optional, std::move(example)};
}
inline Presence alternative(std::string example) {
  return {Need::alternative, std::move(example)};
}

using Target =
    std::variant<double*, std::optional<double>*, int*, bool*, std::string*, std::vector<double>*>;

struct Parameter {
  Target value;
  std::string name;
  Unit unit;
  Bounds bounds;  // of a list: of each element
  std::string meaning, source;
  Presence presence{};
  std::vector<std::string> choices{};  // of a word; empty: any word
};

struct Section {
  std::string name;  // "stones.fracture"
  std::string meaning;
  std::vector<Parameter> parameters;
  std::function<void()> drop{};  // what a scene without this section does; empty: defaults hold
};

// The value a parameter now holds, as TOML in the unit shown: "600 kPa", 0.15, true.
std::string as_toml(const Parameter& parameter, const UnitSystem& units);

// "above 0 kPa", "at least 0 deg and at most 5 deg"; empty without bounds.
std::string bounds_text(const Parameter& parameter);

// Reads every parameter of every section, drops the sections that are absent, and adds unknown
// keys, wrong types, units and bounds, and missing keys to the mistakes.
void read_sections(const std::vector<Section>& sections, const Document& document,
                   const UnitSystem& units, Mistakes& mistakes);

}  // namespace apps
