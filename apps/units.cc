#include "apps/units.h"

#include <udunits2.h>

#include <array>
#include <charconv>
#include <string_view>

#include "apps/errors.h"
#include "apps/text.h"

namespace apps {
namespace {

// UDUNITS counts the radian as a pure number and would let a frequency pass for an angular speed.
bool has_angle(const ut_unit* unit) {
  std::array<char, 256> definition{};
  ut_format(unit, definition.data(), definition.size() - 1, UT_ASCII | UT_DEFINITION);
  return std::string_view(definition.data()).find("rad") != std::string_view::npos;
}

// A number that is no exponent, as in "5 kPa", would silently scale the one before the unit.
bool is_scaled(std::string_view unit) {
  constexpr std::string_view digits = "0123456789", of_exponent = "0123456789+-^", apart = " ./*()";
  const bool inverse = unit == "1" || unit.starts_with("1/");
  for (std::size_t k = inverse ? 1 : 0; k < unit.size(); ++k) {
    if (digits.find(unit[k]) == digits.npos) continue;
    const std::size_t name = unit.substr(0, k).find_last_not_of(of_exponent);
    if (name == unit.npos || apart.find(unit[name]) != apart.npos) return true;
  }
  return false;
}

}  // namespace

std::optional<Quantity> parse_quantity(const std::string& text) {
  const std::string whole = trimmed(text);
  if (whole.starts_with("+-")) return std::nullopt;
  const char* begin = whole.data() + (whole.starts_with('+') ? 1 : 0);
  const char* end = whole.data() + whole.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error != std::errc()) return std::nullopt;
  return Quantity{value, trimmed({rest, end})};
}

void UnitSystem::Free::operator()(ut_system* system) const {
  ut_free_system(system);
}
void UnitSystem::Free::operator()(ut_unit* unit) const {
  ut_free(unit);
}

UnitSystem::UnitSystem() {
  ut_set_error_message_handler(ut_ignore);
  system_.reset(ut_read_xml(nullptr));
  if (!system_)
    throw OutputError(
        "the unit tables of UDUNITS-2 cannot be read: install libudunits2-data, or let the "
        "environment variable UDUNITS2_XML name udunits2.xml");
  const UnitPointer degree = parse("degree");
  const UnitPointer count(ut_get_dimensionless_unit_one(system_.get()));
  if (!degree || ut_map_name_to_unit("deg", UT_UTF8, degree.get()) != UT_SUCCESS ||
      ut_map_name_to_unit("rev", UT_UTF8, count.get()) != UT_SUCCESS)
    throw OutputError("the unit tables of UDUNITS-2 do not take the names \"deg\" and \"rev\"");
  // Theirs is an angular speed, 2 pi rad/min.
  const UnitPointer per_minute = parse("rev/min");
  ut_unmap_symbol_to_unit(system_.get(), "rpm", UT_UTF8);
  if (!per_minute || ut_map_symbol_to_unit("rpm", UT_UTF8, per_minute.get()) != UT_SUCCESS)
    throw OutputError("the unit tables of UDUNITS-2 do not take \"rpm\" for \"rev/min\"");
}

UnitSystem::UnitPointer UnitSystem::parse(const std::string& unit) const {
  if (is_scaled(unit)) return nullptr;
  const std::string whole = unit.starts_with('/') ? "1" + unit : unit;
  return UnitPointer(ut_parse(system_.get(), whole.c_str(), UT_UTF8));
}

bool UnitSystem::knows(const std::string& unit) const {
  return parse(unit) != nullptr;
}

std::optional<double> UnitSystem::convert(double value, const std::string& from,
                                          const std::string& to) const {
  const UnitPointer source = parse(from), target = parse(to);
  if (!source || !target || !ut_are_convertible(source.get(), target.get())) return std::nullopt;
  if (has_angle(source.get()) != has_angle(target.get())) return std::nullopt;
  cv_converter* converter = ut_get_converter(source.get(), target.get());
  if (!converter) return std::nullopt;
  const double converted = cv_convert_double(converter, value);
  cv_free(converter);
  return converted;
}

}  // namespace apps
