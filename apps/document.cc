#include "apps/document.h"

#include <array>
#include <charconv>
#include <set>
#include <string_view>

#include "apps/text.h"

namespace apps {
namespace {

struct Unparsable {};

[[noreturn]] void refuse_text() {
  throw Unparsable();
}

}  // namespace
}  // namespace apps

// toml++ 3.3 asserts on some malformed keys, such as "[\stones]", where it should report them:
// here its assertions throw, whatever the build.
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void() : apps::refuse_text())
#include <toml++/toml.h>

namespace apps {
namespace {

// A value as the user would write it.
struct Writer {
  std::string operator()(std::int64_t integer) const { return std::to_string(integer); }
  std::string operator()(double real) const {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.begin(), text.end(), real).ptr};  // the shortest
  }
  std::string operator()(bool truth) const { return truth ? "true" : "false"; }
  std::string operator()(const std::string& word) const { return '"' + word + '"'; }
  std::string operator()(const std::vector<Value>& elements) const {
    std::string text;
    for (const Value& element : elements) text += (text.empty() ? "" : ", ") + element.written;
    return '[' + text + ']';
  }
  std::string operator()(const Misfit& misfit) const { return misfit.kind; }
  std::string operator()(const Broken&) const { return "nothing readable"; }
};

// Lays tables and values out flat. A --set option has one place for all it sets.
class Flattener {
 public:
  Flattener(Document& document, std::string source, bool is_option)
      : document_(document), source_(std::move(source)), is_option_(is_option) {}

  void flatten(const toml::table& table, const std::string& prefix) const {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      if (const toml::table* section = node.as_table()) {
        document_.sections[name] = place(section->source());
        flatten(*section, name + ".");
      } else if (node.is_array_of_tables()) {
        const toml::array& entries = *node.as_array();
        for (std::size_t i = 0; i < entries.size(); ++i) {
          document_.sections[repeated(name, i)] = place(entries[i].source());
          flatten(*entries[i].as_table(), repeated(name, i) + '.');
        }
      } else {
        document_.values[name] = value(node, place(key.source()));
      }
    }
  }

 private:
  Place place(const toml::source_region& region) const {
    if (is_option_) return {source_};
    return {source_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
  }

  Value value(const toml::node& node, const Place& key) const {
    Value value{Misfit{}, "", key, place(node.source())};
    if (const auto* integer = node.as_integer()) {
      value.content = integer->get();
    } else if (const auto* real = node.as_floating_point()) {
      value.content = real->get();
    } else if (const auto* truth = node.as_boolean()) {
      value.content = truth->get();
    } else if (const auto* string = node.as_string()) {
      value.content = string->get();
    } else if (const auto* array = node.as_array()) {
      std::vector<Value> elements;
      for (const toml::node& element : *array) elements.push_back(this->value(element, key));
      value.content = std::move(elements);
    } else {
      value.content = Misfit{node.is_table() ? "a table" : "a date or time"};
    }
    value.written = std::visit(Writer{}, value.content);
    return value;
  }

  Document& document_;
  std::string source_;
  bool is_option_;
};

// One line of the text, to be mended in place so that the parser can go on to the next mistake.
class Line {
 public:
  Line(std::string& text, int number) : text_(text) {
    for (int line = 1; line < number && begin_ != std::string::npos; ++line) {
      begin_ = text.find('\n', begin_);
      if (begin_ != std::string::npos) ++begin_;
    }
    if (begin_ == std::string::npos) begin_ = text.size();
    length_ = std::min(text.find('\n', begin_), text.size()) - begin_;
    equals_ = content().find('=');
  }

  bool has_pair() const { return equals_ != std::string::npos && !key().empty(); }
  std::string key() const { return trimmed(content().substr(0, equals_)); }
  std::string value() const {
    const std::string_view rest = content().substr(equals_ + 1);
    return trimmed(rest.substr(0, rest.find('#')));
  }
  int key_column() const { return static_cast<int>(content().find_first_not_of(" \t")) + 1; }
  int value_column() const {
    const auto first = content().find_first_not_of(" \t", equals_ + 1);
    return static_cast<int>(first == std::string_view::npos ? equals_ : first) + 1;
  }

  void clear() { text_.replace(begin_, length_, ""); }
  void set_value(const std::string& value) {
    text_.replace(begin_ + equals_ + 1, length_ - equals_ - 1, value);
  }

 private:
  std::string_view content() const { return std::string_view(text_).substr(begin_, length_); }

  std::string& text_;
  std::size_t begin_ = 0, length_ = 0, equals_ = std::string::npos;
};

// Parses the text, mending each line that does not parse, so that one slip hides no other.
class Parser {
 public:
  Parser(Document& document, Mistakes& mistakes) : document_(document), mistakes_(mistakes) {}

  void parse() {
    std::string text = document_.text;
    for (;;) {
      try {
        const toml::table table =
            toml::parse(std::string_view(text), std::string_view(document_.path));
        Flattener(document_, document_.path, false).flatten(table, "");
        break;
      } catch (const toml::parse_error& error) {
        if (!mend(text, error)) throw InputError(mistakes_.lines());
      } catch (const Unparsable&) {
        mistakes_.add({document_.path, last_parsable_line(text) + 1, 1}, "TOML", "a malformed key",
                      "mend this line; what follows it was not read");
        throw InputError(mistakes_.lines());
      }
    }
    for (auto& [name, value] : document_.values) {
      if (broken_.contains(value.key.line)) value.content = Broken{};
    }
  }

 private:
  static int last_parsable_line(const std::string& text) {
    int line = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', end + 1)) {
      try {
        static_cast<void>(toml::parse(std::string_view(text).substr(0, end + 1)));
      } catch (const toml::parse_error&) {  // a value that spans lines
      } catch (const Unparsable&) {
        return line;
      }
      ++line;
    }
    return line;
  }

  // Reports the error; false if the rest of the file cannot be told apart from it.
  bool mend(std::string& text, const toml::parse_error& error) {
    Place place{document_.path, static_cast<int>(error.source().begin.line),
                static_cast<int>(error.source().begin.column)};
    const std::string description(error.description());
    const bool repeated = description.find("cannot redefine") != std::string::npos;
    Line line(text, place.line);
    const bool fresh = mended_.insert(place.line).second;
    if (!line.has_pair() || !fresh) {
      if (repeated) {
        mistakes_.add(place, "each section once", "it again",
                      "move its keys under the first header");
      } else {
        mistakes_.add(place, "TOML", "a syntax error (" + description + ")",
                      "mend this line; what follows it was not read");
      }
      return false;
    }
    if (repeated) {
      place.column = line.key_column();
      mistakes_.add(place, "each key once", "\"" + line.key() + "\" again",
                    "remove one of the two lines");
      line.clear();
      return true;
    }
    place.column = line.value_column();
    const std::string value = line.value();
    mistakes_.add(place, "a TOML value for \"" + line.key() + "\"",
                  value.empty() ? "nothing" : "`" + value + "`",
                  "a value with a unit or of words is written in quotes: \"600 kPa\"");
    line.set_value(" 0");
    broken_.insert(place.line);
    return true;
  }

  Document& document_;
  Mistakes& mistakes_;
  std::set<int> mended_;
  std::set<int> broken_;  // lines whose value was put in for one that did not parse
};

void remove(Document& document, const std::string& key, const Place& place) {
  const auto at_or_below = [&](const auto& item) {
    return item.first == key || item.first.starts_with(key + ".") ||
           item.first.starts_with(key + "[");
  };
  const bool was_repeated = document.repetitions(key) > 0;
  std::erase_if(document.values, at_or_below);
  std::erase_if(document.sections, at_or_below);
  if (!was_repeated) document.removed[key] = place;
}

// The value alone as a table {value = ...}; as a string where it is not TOML.
toml::table option_value(const std::string& value) {
  try {
    toml::table table = toml::parse("value = " + value);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
  } catch (const Unparsable&) {
  }
  return toml::table{{"value", value}};
}

void apply_option(Document& document, const std::string& option, Mistakes& mistakes) {
  const auto equals = option.find('=');
  const std::string key = trimmed(option.substr(0, equals));
  const Place place{"--set " + key};
  if (equals == std::string::npos || key.empty()) {
    mistakes.add(place, "key=value", "\"" + option + "\"",
                 "write it like --set gyration.pressure=\"300 kPa\"");
    return;
  }
  const std::string value = trimmed(option.substr(equals + 1));
  remove(document, key, place);
  if (value == "none") return;
  document.removed.erase(key);
  for (auto dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1))
    document.sections.try_emplace(key.substr(0, dot), place);
  const toml::table parsed = option_value(value);
  Flattener flattener(document, place.source, true);
  if (const toml::table* section = parsed["value"].as_table()) {
    document.sections[key] = place;
    flattener.flatten(*section, key + ".");
  } else {
    toml::table named;
    named.insert(key, *parsed.get("value"));
    flattener.flatten(named, "");
  }
}

}  // namespace

std::string repeated(const std::string& section, std::size_t number) {
  return section + '[' + std::to_string(number) + ']';
}

std::size_t Document::repetitions(const std::string& section) const {
  std::size_t count = 0;
  while (sections.contains(repeated(section, count))) ++count;
  return count;
}

const Value* Document::find(const std::string& key) const {
  const auto found = values.find(key);
  return found == values.end() ? nullptr : &found->second;
}

Place Document::place(const std::string& key) const {
  for (std::string name = key;;) {
    if (const Value* value = find(name)) return value->place;
    if (const auto section = sections.find(name); section != sections.end()) return section->second;
    const auto dot = name.rfind('.');
    if (dot == std::string::npos) return {path, 1, 1};
    name.resize(dot);
  }
}

Document read_document(const std::string& path, const std::vector<std::string>& overrides,
                       Mistakes& mistakes) {
  Document document;
  document.path = path;
  const std::optional<std::string> text = read_text(path);
  if (!text)
    throw InputError({path + ": expected a scene file, found none to read; check the path"});
  document.text = *text;
  Parser(document, mistakes).parse();
  for (const std::string& option : overrides) apply_option(document, option, mistakes);
  return document;
}

}  // namespace apps
