#include "apps/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apps/text.h"

namespace apps {
namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string quantity_text(double si, const Unit& unit, const UnitSystem& units) {
  if (unit.shown == std::string("1")) return number_text(si);
  return '"' + number_text(units.convert(si, unit.si, unit.shown).value()) + ' ' + unit.shown + '"';
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// Reads one value of the document into its parameter.
class ValueReader {
 public:
  ValueReader(const Parameter& parameter, const std::string& key, const UnitSystem& units,
              Mistakes& mistakes)
      : parameter_(parameter), key_(key), units_(units), mistakes_(mistakes) {}

  void read(const Value& value) const {
    if (std::holds_alternative<Broken>(value.content)) return;
    std::visit([&](auto* target) { read_into(*target, value); }, parameter_.value);
  }

 private:
  void read_into(double& target, const Value& value) const {
    if (const auto si = number(value)) target = *si;
  }
  void read_into(std::optional<double>& target, const Value& value) const {
    if (const auto si = number(value)) target = *si;
  }
  void read_into(int& target, const Value& value) const {
    const auto* integer = std::get_if<std::int64_t>(&value.content);
    const auto* real = std::get_if<double>(&value.content);
    if (!integer && !(real && *real == std::round(*real))) return refuse(value, "a whole number");
    const double whole = integer ? static_cast<double>(*integer) : *real;
    constexpr double largest = std::numeric_limits<int>::max();
    const double most = std::min(parameter_.bounds.most, largest);
    if (whole > most) return refuse(value, "a whole number of at most " + number_text(most));
    if (whole < std::max(parameter_.bounds.least, -largest))
      return refuse(value, "a whole number " + bounds_text(parameter_));
    target = static_cast<int>(whole);
  }
  void read_into(bool& target, const Value& value) const {
    const auto* truth = std::get_if<bool>(&value.content);
    if (!truth) return refuse(value, "true or false");
    target = *truth;
  }
  void read_into(std::string& target, const Value& value) const {
    const auto* word = std::get_if<std::string>(&value.content);
    if (!word || word->empty()) return refuse(value, "a word in quotes");
    const auto& choices = parameter_.choices;
    if (!choices.empty() && std::ranges::find(choices, *word) == choices.end())
      return refuse(value, "one of " + joined(choices));
    target = *word;
  }
  void read_into(std::vector<double>& target, const Value& value) const {
    const auto* elements = std::get_if<std::vector<Value>>(&value.content);
    if (!elements || elements->empty()) return refuse(value, "a list of numbers");
    std::vector<double> numbers;
    for (const Value& element : *elements) {
      if (const auto si = number(element)) numbers.push_back(*si);
    }
    if (numbers.size() == elements->size()) target = numbers;
  }

  // In SI and within its bounds; the mistake is added otherwise.
  std::optional<double> number(const Value& value) const {
    const std::optional<double> si = in_si(value);
    if (!si) return std::nullopt;
    const Bounds& bounds = parameter_.bounds;
    const Unit& unit = parameter_.unit;
    const double least = units_.convert(bounds.least, unit.shown, unit.si).value();
    const double most = units_.convert(bounds.most, unit.shown, unit.si).value();
    const bool above = bounds.least_excluded ? *si > least : *si >= least;
    const bool under = bounds.most_excluded ? *si < most : *si <= most;
    if (!above || !under || !std::isfinite(*si)) {
      const std::string range = bounds_text(parameter_);
      const bool bare = !std::holds_alternative<std::string>(value.content);
      const std::string found =
          bare && unit.shown != std::string("1") ? value.written + ' ' + unit.si : value.written;
      refuse(value, range.empty() ? "a finite number" : "a value " + range, found);
      return std::nullopt;
    }
    return si;
  }

  std::optional<double> in_si(const Value& value) const {
    if (const auto* integer = std::get_if<std::int64_t>(&value.content))
      return static_cast<double>(*integer);
    if (const auto* real = std::get_if<double>(&value.content)) return *real;
    const bool pure = parameter_.unit.shown == std::string("1");
    const std::string kind = pure ? "a number" : "a number with a unit";
    const auto* text = std::get_if<std::string>(&value.content);
    const auto quantity = text ? parse_quantity(*text) : std::nullopt;
    if (!quantity || (quantity->unit.empty() && !pure)) {
      refuse(value, kind);
      return std::nullopt;
    }
    if (quantity->unit.empty()) return quantity->value;
    const auto si = units_.convert(quantity->value, quantity->unit, parameter_.unit.si);
    if (!si) {
      const std::string expected =
          pure ? "a number without dimension"
               : "a unit that converts to " + std::string(parameter_.unit.shown);
      const std::string unknown = units_.knows(quantity->unit) ? "" : " with an unknown unit";
      refuse(value, expected, value.written + unknown);
    }
    return si;
  }

  void refuse(const Value& value, const std::string& expected) const {
    refuse(value, expected, value.written);
  }
  void refuse(const Value& value, const std::string& expected, const std::string& found) const {
    std::string advice = "remove it";
    const std::string sample = parameter_.presence.example.empty() ? as_toml(parameter_, units_)
                                                                   : parameter_.presence.example;
    if (!sample.empty()) advice = "write for example " + parameter_.name + " = " + sample;
    mistakes_.add(value.place, "for " + key_ + " " + expected, found, advice);
  }

  const Parameter& parameter_;
  const std::string& key_;
  const UnitSystem& units_;
  Mistakes& mistakes_;
};

std::string parent(const std::string& key) {
  const auto dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string last_part(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

// As a scene writes it: [stones], and [[output.gauge]] for what stands in a list.
std::string header(const std::string& section) {
  return section.ends_with(']') ? "[[" + section.substr(0, section.rfind('[')) + "]]"
                                : '[' + section + ']';
}

// The names a scene may use, to find those that it may not.
class Vocabulary {
 public:
  explicit Vocabulary(const std::vector<Section>& sections) {
    for (const Section& section : sections) {
      sections_.push_back(section.name);
      for (const Parameter& parameter : section.parameters)
        keys_.push_back(section.name + '.' + parameter.name);
    }
  }

  void refuse_unknown(const Document& document, Mistakes& mistakes) const {
    for (const auto& [name, place] : document.sections) {
      if (!knows_section(name) && knows_section_above(name))
        mistakes.add(place, "a known section", "[" + name + "]", advice(name, sections_));
    }
    for (const auto& [key, value] : document.values) {
      if (is(key, sections_)) {
        mistakes.add(value.place, "a section [" + key + "]", "one value, " + value.written,
                     "write its keys below a header [" + key + "]");
      } else if (!is(key, keys_) && knows_section_above(key)) {
        mistakes.add(value.key, "a known key", "\"" + key + "\"", advice(key, keys_));
      }
    }
    std::vector<std::string> names = keys_;
    names.insert(names.end(), sections_.begin(), sections_.end());
    for (const auto& [key, place] : document.removed) {
      if (!is(key, names))
        mistakes.add(place, "a known key or section", "\"" + key + "\"", advice(key, names));
    }
  }

 private:
  static bool is(const std::string& name, const std::vector<std::string>& names) {
    return std::ranges::find(names, name) != names.end();
  }
  // A section of the scene, or a table on the way to one.
  bool knows_section(const std::string& name) const {
    return std::ranges::any_of(sections_, [&](const std::string& known) {
      return known == name || known.starts_with(name + '.');
    });
  }
  // What stands below an unknown section is reported once, at that section.
  bool knows_section_above(const std::string& key) const {
    return parent(key).empty() || knows_section(parent(key));
  }

  static std::string advice(const std::string& name, const std::vector<std::string>& names) {
    std::vector<std::string> siblings;
    for (const std::string& other : names) {
      if (parent(other) == parent(name)) siblings.push_back(other);
    }
    std::optional<std::string> meant = nearest(name, siblings);
    for (const std::string& other : names) {
      if (!meant && last_part(other) == last_part(name)) meant = other;
    }
    if (!meant) meant = nearest(name, names);
    if (meant) return "did you mean \"" + *meant + "\"?";
    if (siblings.empty()) return "remove it, or move it below its section";
    return "remove it, or use one of " + joined(siblings);
  }

  std::vector<std::string> sections_, keys_;
};

}  // namespace

std::string as_toml(const Parameter& parameter, const UnitSystem& units) {
  struct Writer {
    const Unit& unit;
    const UnitSystem& units;
    std::string operator()(const double* value) const { return quantity_text(*value, unit, units); }
    std::string operator()(const std::optional<double>* value) const {
      return *value ? quantity_text(**value, unit, units) : "";
    }
    std::string operator()(const int* value) const { return std::to_string(*value); }
    std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
    std::string operator()(const std::string* value) const { return '"' + *value + '"'; }
    std::string operator()(const std::vector<double>* value) const {
      std::vector<std::string> elements;
      for (const double element : *value) elements.push_back(quantity_text(element, unit, units));
      return '[' + joined(elements) + ']';
    }
  };
  return std::visit(Writer{parameter.unit, units}, parameter.value);
}

std::string bounds_text(const Parameter& parameter) {
  const Bounds& bounds = parameter.bounds;
  const std::string unit =
      parameter.unit.shown == std::string("1") ? "" : std::string(" ") + parameter.unit.shown;
  std::string text;
  if (std::isfinite(bounds.least))
    text = (bounds.least_excluded ? "above " : "at least ") + number_text(bounds.least) + unit;
  if (std::isfinite(bounds.most)) {
    text += (text.empty() ? "" : " and ") +
            std::string(bounds.most_excluded ? "below " : "at most ") + number_text(bounds.most) +
            unit;
  }
  return text;
}

void read_sections(const std::vector<Section>& sections, const Document& document,
                   const UnitSystem& units, Mistakes& mistakes) {
  Vocabulary(sections).refuse_unknown(document, mistakes);
  for (const Section& section : sections) {
    if (section.drop && !document.sections.contains(section.name)) {
      section.drop();
      continue;
    }
    for (const Parameter& parameter : section.parameters) {
      const std::string key = section.name + '.' + parameter.name;
      if (const Value* value = document.find(key)) {
        ValueReader(parameter, key, units, mistakes).read(*value);
      } else if (parameter.presence.need == Need::required && !document.in_part) {
        mistakes.add(document.place(key), "the key " + key, "none",
                     "add below " + header(section.name) + ' ' + parameter.name + " = " +
                         parameter.presence.example);
      }
    }
  }
}

}  // namespace apps
