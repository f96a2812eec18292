// One line of a TOML text, to be mended in place so that a parser can go on to the next mistake.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "apps/text.h"

namespace apps {

class TomlLine {
 public:
  TomlLine(std::string& text, int number) : text_(text) {
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

}  // namespace apps
