// A TOML file flattened to `section.key` -> value, each with its place in the text, laid over the
// file that it includes and with the --set options of the command line laid over both.
//
// `include = "base.toml"`, above the first section, names a file from the folder of this one. What
// the including file gives replaces what the base gives; key = "none" takes a key or section away.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/mistakes.h"

namespace apps {

// A value that no parameter can take: a date, a time, a table inside an array.
struct Misfit {
  std::string kind;
};

// A value whose line did not parse; the mistake is already reported.
struct Broken {};

struct Value {
  std::variant<std::int64_t, double, bool, std::string, std::vector<Value>, Misfit, Broken> content;
  std::string written;  // as TOML text
  Place key;            // where its key stands
  Place place;          // where the value itself stands
};

// The name of the entry of [[section]] that stands at `number`, counted from 0: "section[0]".
std::string repeated(const std::string& section, std::size_t number);

struct Document {
  std::string path;
  std::string text;                       // as read
  std::vector<std::string> files;         // that it was read from, outermost first
  std::map<std::string, Place> sections;  // "stones.fracture" -> its header
  std::map<std::string, Value> values;    // "stones.count" -> value
  std::map<std::string, Place> removed;   // keys and sections that --set took away with `none`
  bool in_part = false;  // not all of it could be read: what is missing may stand there

  const Value* find(const std::string& key) const;
  std::size_t repetitions(const std::string& section) const;  // of [[section]]
  // Of a value, else of the nearest section above it, else the top of the file.
  Place place(const std::string& key) const;
  // The path in a value, which is meant from the folder of the file that it is written in.
  std::string path_from(const std::string& key, const std::string& path) const;
};

// `overrides` are `key=value`; a value that is not TOML is taken as a string, `none` removes the
// key or the section. What can be parsed is returned, what cannot is added to the mistakes.
Document read_document(const std::string& path, const std::vector<std::string>& overrides,
                       Mistakes& mistakes);

}  // namespace apps
