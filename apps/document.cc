#include "apps/document.h"

#include <algorithm>
#include <filesystem>

#include "apps/text.h"
#include "apps/toml_document.h"

namespace apps {
namespace {

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
  set_value(document, key, value, place);
}

// Lays a document over the one that it includes.
Document overlaid(Document base, const Document& document) {
  base.path = document.path;
  base.text = document.text;
  base.files.insert(base.files.begin(), document.files.begin(), document.files.end());
  base.in_part |= document.in_part;
  for (const auto& [name, place] : document.sections) base.sections[name] = place;
  for (const auto& [key, value] : document.values) {
    const std::string* word = std::get_if<std::string>(&value.content);
    if (word && *word == "none") {
      remove(base, key, value.key);
    } else {
      base.removed.erase(key);
      base.values.insert_or_assign(key, value);
    }
  }
  return base;
}

Document read_file(const std::string& path, const std::string& text, Mistakes& mistakes,
                   std::vector<std::string> trail);

// What `asked` includes; nothing if it cannot be read. `trail`: the files that include one
// another down to here, outermost first.
std::optional<Document> included(const Value& asked, Mistakes& mistakes,
                                 const std::vector<std::string>& trail) {
  const std::string* name = std::get_if<std::string>(&asked.content);
  if (!name) {
    mistakes.add(asked.place, "for include the path of a scene", asked.written,
                 "write it like include = \"base.toml\"");
    return std::nullopt;
  }
  const std::string path =
      (std::filesystem::path(trail.back()).parent_path() / *name).lexically_normal().string();
  if (std::ranges::find(trail, path) != trail.end()) {
    mistakes.add(asked.place, "a file that does not include this one", asked.written,
                 "remove one of the two includes");
    return std::nullopt;
  }
  const std::optional<std::string> text = read_text(path);
  if (!text) {
    mistakes.add(asked.place, "a scene to include", "no file to read at " + path,
                 "give the path from the folder of this file");
    return std::nullopt;
  }
  return read_file(path, *text, mistakes, trail);
}

Document read_file(const std::string& path, const std::string& text, Mistakes& mistakes,
                   std::vector<std::string> trail) {
  Document document;
  document.path = path;
  document.text = text;
  document.files = {path};
  parse_document(document, mistakes);
  const Value* include = document.find("include");
  if (!include) return document;
  const Value asked = *include;
  document.values.erase("include");
  trail.push_back(std::filesystem::path(path).lexically_normal().string());
  const std::optional<Document> base = included(asked, mistakes, trail);
  if (base) return overlaid(*base, document);
  document.in_part = true;
  return document;
}

}  // namespace

std::string Document::path_from(const std::string& key, const std::string& relative) const {
  const std::string& source = place(key).source;
  const std::filesystem::path file = source.starts_with("--set") ? path : source;
  return (file.parent_path() / relative).lexically_normal().string();
}

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
  const std::optional<std::string> text = read_text(path);
  if (!text)
    throw InputError({path + ": expected a scene file, found none to read; check the path"});
  Document document = read_file(path, *text, mistakes, {});
  for (const std::string& option : overrides) apply_option(document, option, mistakes);
  return document;
}

}  // namespace apps
