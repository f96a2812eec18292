// Letters that TOML does not know outside strings and comments: all that are not ASCII. They must
// be found before toml++ 3.3 meets them, whose test for white space runs into undefined behaviour
// at most letters from U+00A1 to U+0499.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace apps {

struct ForeignLetter {
  std::string letter;
  int line, column;  // from 1
};

// The first one of a text; none where the text is malformed before it.
std::optional<ForeignLetter> foreign_letter(std::string_view text);

}  // namespace apps
