#include "apps/scene_manual.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/sections.h"

namespace apps {
namespace {

using Json = nlohmann::ordered_json;

std::string comment(const std::string& text) {
  std::string commented = "# ";
  for (const char letter : text) commented += letter == '\n' ? "\n# " : std::string(1, letter);
  return commented + '\n';
}

std::string default_or_example(const Parameter& parameter, const UnitSystem& units) {
  if (parameter.presence.need == Need::has_default) return as_toml(parameter, units);
  return parameter.presence.example;
}

// The meaning, what values it takes, and where the number is from.
std::string explanation(const Parameter& parameter) {
  std::string text = parameter.meaning;
  const std::string bounds = bounds_text(parameter);
  if (!bounds.empty()) text += "; " + bounds;
  for (const std::string& choice : parameter.choices)
    text += (&choice == &parameter.choices.front() ? "; " : " or ") + choice;
  if (parameter.presence.need == Need::required) text += "; required";
  if (!parameter.source.empty()) text += "\n(" + parameter.source + ")";
  return text;
}

std::string explained(const Section& section, const std::string& header, const UnitSystem& units) {
  std::string text = comment(section.meaning) + header + '\n';
  for (const Parameter& parameter : section.parameters) {
    text += comment(explanation(parameter));
    if (parameter.presence.need == Need::optional) text += "# ";
    text += parameter.name + " = " + default_or_example(parameter, units) + '\n';
  }
  return text;
}

// A section that a scene may name any number of times, as a comment: none is the default.
std::string repeatable(const Section& section, const std::string& name, const UnitSystem& units) {
  std::string text = comment(explained(section, "[[" + name + "]]", units));
  text.resize(text.size() - 3);  // the comment sign after the last line
  return '\n' + text;
}

template <class Scene>
std::string manual() {
  Scene scene;
  std::string text = apps::manual(describe(scene));
  if constexpr (std::is_same_v<Scene, GyratoryScene>) {
    const UnitSystem units;
    GaugeScene gauge;
    text += repeatable(describe(gauge, 0), "output.gauge", units);
  }
  return text;
}

// Of a table: one line, with nothing in it that ends a cell.
std::string cell(const std::string& text) {
  std::string plain;
  for (const char letter : text)
    plain += letter == '\n' ? " " : letter == '|' ? "\\|" : std::string(1, letter);
  return plain;
}

std::string default_cell(const Parameter& parameter, const UnitSystem& units) {
  if (parameter.presence.need == Need::has_default) return '`' + as_toml(parameter, units) + '`';
  if (parameter.presence.need == Need::required) return "required";
  return "absent; `" + parameter.presence.example + '`';
}

using Names = std::set<std::string>;

Names names_of(const std::vector<Section>& sections) {
  Names names;
  for (const Section& section : sections) {
    names.insert(section.name);
    for (const Parameter& parameter : section.parameters)
      names.insert(section.name + '.' + parameter.name);
  }
  return names;
}

// Marks the keys that a flow test has not, if it has the section.
std::string table(const Section& section, const Names& flow, const UnitSystem& units) {
  std::string text = "## [" + section.name + "]\n\n" + section.meaning + "\n\n" +
                     "| key | default | values | meaning | source |\n|---|---|---|---|---|\n";
  for (const Parameter& parameter : section.parameters) {
    std::string values = bounds_text(parameter);
    for (const std::string& choice : parameter.choices)
      values += (values.empty() ? "" : " or ") + choice;
    const bool missing =
        flow.contains(section.name) && !flow.contains(section.name + '.' + parameter.name);
    text += "| `" + parameter.name + (missing ? "` (g) | " : "` | ") +
            cell(default_cell(parameter, units)) + " | " + cell(values) + " | " +
            cell(parameter.meaning) + " | " + cell(parameter.source) + " |\n";
  }
  return text + '\n';
}

Json bounded(const char* type, const Parameter& parameter, const UnitSystem& units) {
  const auto si = [&](double bound) {
    return units.convert(bound, parameter.unit.shown, parameter.unit.si).value();
  };
  const Bounds& bounds = parameter.bounds;
  Json number{{"type", type}};
  if (std::isfinite(bounds.least))
    number[bounds.least_excluded ? "exclusiveMinimum" : "minimum"] = si(bounds.least);
  if (std::isfinite(bounds.most))
    number[bounds.most_excluded ? "exclusiveMaximum" : "maximum"] = si(bounds.most);
  return number;
}

// A bare number is in SI; a string holds a number with a unit, which a schema cannot check.
Json quantity(const Parameter& parameter, const UnitSystem& units) {
  return {{"anyOf", {bounded("number", parameter, units), {{"type", "string"}}}}};
}

struct SchemaOf {
  const Parameter& parameter;
  const UnitSystem& units;

  Json operator()(const double*) const { return quantity(parameter, units); }
  Json operator()(const std::optional<double>*) const { return quantity(parameter, units); }
  Json operator()(const int*) const { return bounded("integer", parameter, units); }
  Json operator()(const bool*) const { return {{"type", "boolean"}}; }
  Json operator()(const std::string*) const {
    if (parameter.choices.empty()) return {{"type", "string"}};
    return {{"enum", parameter.choices}};
  }
  Json operator()(const std::vector<double>*) const {
    return {{"type", "array"}, {"minItems", 1}, {"items", quantity(parameter, units)}};
  }
};

Json closed_object() {
  return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
}

// The object of a section, within those of the sections above it.
Json& object_of(const std::string& section, Json& root) {
  Json* object = &root;
  for (std::size_t begin = 0; begin < section.size();) {
    const std::size_t dot = std::min(section.find('.', begin), section.size());
    Json& child = (*object)["properties"][section.substr(begin, dot - begin)];
    if (child.is_null()) child = closed_object();
    object = &child;
    begin = dot + 1;
  }
  return *object;
}

// Adds the parameters of a section to the object that describes it.
void add_properties(const Section& section, const UnitSystem& units, Json& object) {
  object["description"] = section.meaning;
  for (const Parameter& parameter : section.parameters) {
    Json property = std::visit(SchemaOf{parameter, units}, parameter.value);
    property["description"] = explanation(parameter);
    if (parameter.presence.need == Need::has_default)
      property["default"] = Json::parse(as_toml(parameter, units));
    if (parameter.presence.need == Need::required) object["required"].push_back(parameter.name);
    object["properties"][parameter.name] = property;
  }
}

template <class Scene>
std::string schema() {
  const UnitSystem units;
  Scene scene;
  Json root = closed_object();
  root["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  root["properties"]["include"] = {{"type", "string"},
                                   {"description", "path of the scene that this one lies over"}};
  for (const Section& section : describe(scene)) {
    const auto required = [](const Parameter& p) { return p.presence.need == Need::required; };
    if (!section.drop && std::ranges::any_of(section.parameters, required))
      root["required"].push_back(section.name);
    add_properties(section, units, object_of(section.name, root));
  }
  if constexpr (std::is_same_v<Scene, GyratoryScene>) {
    GaugeScene gauge;
    Json item = closed_object();
    add_properties(describe(gauge, 0), units, item);
    object_of("output", root)["properties"]["gauge"] = {{"type", "array"}, {"items", item}};
  }
  return root.dump(2) + '\n';
}

}  // namespace

std::string manual(const std::vector<Section>& sections) {
  const UnitSystem units;
  std::string text;
  for (const Section& section : sections) {
    if (!text.empty()) text += '\n';
    text += explained(section, '[' + section.name + ']', units);
  }
  return text;
}
std::string gyratory_scene_manual() {
  return manual<GyratoryScene>();
}
std::string flow_scene_manual() {
  return manual<FlowTestScene>();
}
std::string scene_reference() {
  const UnitSystem units;
  GyratoryScene gyratory;
  FlowTestScene flow;
  std::string text =
      "# The keys of a scene\n\n"
      "Written by the program from the declarations that it reads scenes with; a test keeps the "
      "two "
      "equal.\n"
      "A quantity is a string with its unit, in any unit of its dimension, or a bare number in SI. "
      "`gyratory`\n"
      "takes all sections but `[flow]`; `flow_test` takes `[run]`, `[stones]`, "
      "`[stones.fracture]`, "
      "`[binder]`,\n"
      "`[fill]`, `[flow]`, `[numerics]` and `[output]`; keys marked (g) are those of `gyratory` "
      "only. Above the\n"
      "first section, `include = \"base.toml\"` lays the file over another one, whose keys and "
      "sections it replaces,\n"
      "or takes away with `key = \"none\"`.\n\n";
  const Names of_flow = names_of(describe(flow));
  for (const Section& section : describe(gyratory)) text += table(section, of_flow, units);
  GaugeScene gauge;
  Section repeated = describe(gauge, 0);
  repeated.name = "[output.gauge]";
  text += table(repeated, of_flow, units);
  for (const Section& section : describe(flow))
    if (section.name == "flow") text += table(section, of_flow, units);
  text.pop_back();
  return text;
}
std::string gyratory_scene_schema() {
  return schema<GyratoryScene>();
}
std::string flow_scene_schema() {
  return schema<FlowTestScene>();
}

}  // namespace apps
