#include "apps/toml_document.h"

#include <array>
#include <charconv>
#include <set>
#include <string_view>

#include "apps/foreign_letter.h"
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

  bool is_header() const { return written().starts_with('['); }
  std::string written() const { return trimmed(content().substr(0, content().find('#'))); }
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

  void clear() { set(""); }
  void set(const std::string& words) { text_.replace(begin_, length_, words); }
  void set_value(const std::string& value) {
    text_.replace(begin_ + equals_ + 1, length_ - equals_ - 1, value);
  }

 private:
  std::string_view content() const { return std::string_view(text_).substr(begin_, length_); }

  std::string& text_;
  std::size_t begin_ = 0, length_ = 0, equals_ = std::string::npos;
};

// Begins the name of the section that takes in what stands below a header that cannot be read.
constexpr std::string_view unread = "below_an_unreadable_header_in_line_";

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
    const auto is_unread = [](const auto& item) { return item.first.starts_with(unread); };
    std::erase_if(document_.sections, is_unread);
    std::erase_if(document_.values, is_unread);
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
      Line(text, found->line).clear();
    }
  }

  // Reports the error; false if the rest of the file cannot be told apart from it.
  bool mend(std::string& text, const toml::parse_error& error) {
    Place place{document_.path, static_cast<int>(error.source().begin.line),
                static_cast<int>(error.source().begin.column)};
    const std::string description(error.description());
    const bool repeated = description.find("cannot redefine") != std::string::npos;
    Line line(text, place.line);
    const bool fresh = mended_.insert(place.line).second;
    if (!line.has_pair() && line.is_header() && fresh) {
      if (repeated) {
        mistakes_.add(place, "each section once", line.written() + " again",
                      "move its keys under the first header");
      } else {
        mistakes_.add(place, "a section in brackets", '`' + line.written() + '`',
                      "write it like [stones]; the keys below it were not read");
      }
      line.set('[' + std::string(unread) + std::to_string(place.line) + ']');
      document_.in_part = true;
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

  Document& document_;
  Mistakes& mistakes_;
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
