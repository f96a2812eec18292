#include "apps/toml_document.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <set>
#include <string_view>

#include "apps/foreign_letter.h"
#include "apps/toml_line.h"

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

// Begins the name of the section that takes in what stands below a header that cannot be taken.
constexpr std::string_view aside = "below_the_header_in_line_";

// Parses the text, mending each line that does not parse, so that one slip hides no other.
class Parser {
 public:
  Parser(Document& document, Mistakes& mistakes) : document_(document), mistakes_(mistakes) {}

  void parse() {
    std::string text = document_.text;
    for (;;) {
      try {
        take_out_foreign_letters(text);
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
    take_in_repeated();
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

  void take_out_foreign_letters(std::string& text) {
    while (const auto found = foreign_letter(text)) {
      mistakes_.add({document_.path, found->line, found->column},
                    "ASCII outside quotes and comments", '`' + found->letter + '`',
                    "put words in quotes, or remove the letter; this line was not read");
      TomlLine(text, found->line).clear();
    }
  }

  // Reports the error; false if the rest of the file cannot be told apart from it.
  bool mend(std::string& text, const toml::parse_error& error) {
    Place place{document_.path, static_cast<int>(error.source().begin.line),
                static_cast<int>(error.source().begin.column)};
    const std::string description(error.description());
    const bool repeated = description.find("cannot redefine") != std::string::npos;
    TomlLine line(text, place.line);
    const bool fresh = mended_.insert(place.line).second;
    if (line.is_header() && fresh) {
      set_aside(line, place, repeated);
      return true;
    }
    if (!line.has_pair() || !fresh) {
      mistakes_.add(place, "TOML", "a syntax error (" + description + ")",
                    "mend this line; what follows it was not read");
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

  void set_aside(TomlLine& line, const Place& place, bool repeated) {
    const std::string header = line.written();
    const std::string name = std::string(aside) + std::to_string(place.line);
    if (repeated) {
      mistakes_.add(place, "each section once", header + " again",
                    "move its keys under the first header");
      repeated_[name] = header.substr(1, header.size() - 2);
    } else {
      mistakes_.add(place, "a section in brackets", '`' + header + '`',
                    "write it like [stones]; the keys below it were not read");
      document_.in_part = true;
    }
    line.set('[' + name + ']');
  }

  // Keys below a repeated header are judged as if they stood below the first one.
  void take_in_repeated() {
    std::map<std::string, Value> taken_in;
    for (const auto& [key, value] : document_.values) {
      const auto dot = std::min(key.find('.'), key.size());
      const auto section = repeated_.find(key.substr(0, dot));
      if (section != repeated_.end()) taken_in[section->second + key.substr(dot)] = value;
    }
    const auto is_aside = [](const auto& item) { return item.first.starts_with(aside); };
    std::erase_if(document_.sections, is_aside);
    std::erase_if(document_.values, is_aside);
    document_.values.merge(taken_in);
  }

  Document& document_;
  Mistakes& mistakes_;
  std::map<std::string, std::string> repeated_;  // set aside, and below which header it stood
  std::set<int> mended_;
  std::set<int> broken_;  // lines whose value was put in for one that did not parse
};

// The value alone as a table {value = ...}; as a string where it is not TOML.
toml::table option_value(const std::string& value) {
  if (foreign_letter(value)) return toml::table{{"value", value}};
  try {
    toml::table table = toml::parse("value = " + value);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error&) {
  } catch (const Unparsable&) {
  }
  return toml::table{{"value", value}};
}

}  // namespace

void parse_document(Document& document, Mistakes& mistakes) {
  Parser(document, mistakes).parse();
}

void set_value(Document& document, const std::string& key, const std::string& value,
               const Place& place) {
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

}  // namespace apps
