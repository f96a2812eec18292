#include "apps/foreign_letter.h"

#include <algorithm>

namespace apps {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool continues(char byte) {  // a letter of UTF-8 that began before
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}
bool is_ascii(char byte) {
  return static_cast<unsigned char>(byte) < 0x80;
}

// What is not UTF-8 is no letter; toml++ stops there by itself.
bool is_letter(std::string_view bytes) {
  const auto first = static_cast<unsigned char>(bytes.front());
  return (first >= 0xC2 && first < 0xE0 && bytes.size() == 2) ||
         (first >= 0xE0 && first < 0xF0 && bytes.size() == 3) ||
         (first >= 0xF0 && first < 0xF5 && bytes.size() == 4);
}

// Behind the string that begins at `at`; a string of one line ends with its line at the latest.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool long_one = text.substr(at).starts_with(three);
  for (std::size_t k = at + (long_one ? 3 : 1); k < text.size(); ++k) {
    if (quote == '"' && text[k] == '\\')
      ++k;
    else if (long_one && text.substr(k).starts_with(three))
      return std::min(text.find_first_not_of(quote, k), text.size());
    else if (!long_one && (text[k] == quote || text[k] == '\n'))
      return k + (text[k] == quote ? 1 : 0);
  }
  return text.size();
}

std::size_t first_foreign(std::string_view text) {
  std::size_t k = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
  while (k < text.size() && is_ascii(text[k])) {
    if (text[k] == '"' || text[k] == '\'')
      k = end_of_string(text, k);
    else if (text[k] == '#')
      k = std::min(text.find('\n', k), text.size());
    else
      ++k;
  }
  return k;
}

}  // namespace

std::optional<ForeignLetter> foreign_letter(std::string_view text) {
  const std::size_t at = first_foreign(text);
  if (at >= text.size()) return std::nullopt;
  std::size_t end = at + 1;
  while (end < text.size() && continues(text[end])) ++end;
  if (!is_letter(text.substr(at, end - at))) return std::nullopt;
  ForeignLetter found{std::string(text.substr(at, end - at)), 1, 1};
  for (const char byte : text.substr(0, at)) {
    if (byte == '\n') {
      ++found.line;
      found.column = 1;
    } else if (!continues(byte)) {
      ++found.column;
    }
  }
  return found;
}

}  // namespace apps
