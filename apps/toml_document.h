// TOML text into a Document, mended where it does not parse. The one place that sees toml++.
#pragma once

#include "apps/document.h"

namespace apps {

// Reads document.text into its sections and values; a line that does not parse is reported and read
// without its value. Throws InputError where the rest of the text cannot be told apart from it.
void parse_document(Document& document, Mistakes& mistakes);

// Sets a key, or the section of that name, to a value as TOML; to a word where it is not TOML.
void set_value(Document& document, const std::string& key, const std::string& value,
               const Place& place);

}  // namespace apps
