// Reading and comparing plain text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace apps {

// The content of a file; nothing if it is missing, a folder, or cannot be read.
std::optional<std::string> read_text(const std::string& path);

// Without the byte-order mark that spreadsheets put before UTF-8.
std::string without_mark(std::string text);

// Without the white space around it.
std::string trimmed(std::string_view text);

// The word that takes the fewest insertions, deletions and substitutions to become `word`
// (Levenshtein 1966); nothing if more than a third of it would have to change.
std::optional<std::string> nearest(const std::string& word, const std::vector<std::string>& words);

}  // namespace apps
