#include "apps/scene_record.h"

#include <array>
#include <charconv>
#include <filesystem>

#include "apps/errors.h"
#include "apps/sections.h"
#include "apps/text.h"

namespace apps {
namespace {

std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

// The value that a parameter holds as TOML: a bare number is in SI.
struct BareValue {
  std::string operator()(const double* value) const { return shortest(*value); }
  std::string operator()(const std::optional<double>* value) const { return shortest(**value); }
  std::string operator()(const int* value) const { return std::to_string(*value); }
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const std::string* value) const { return '"' + *value + '"'; }
  std::string operator()(const std::vector<double>* values) const {
    std::string text;
    for (const double value : *values) text += (text.empty() ? "" : ", ") + shortest(value);
    return '[' + text + ']';
  }
};

// "[section]"; an entry of a repeated section, "section[0]", begins with "[[section]]".
std::string header(const std::string& name) {
  const std::size_t number = name.find('[');
  if (number == std::string::npos) return '[' + name + ']';
  return "[[" + name.substr(0, number) + "]]";
}

template <class Scene>
std::string complete(Scene scene) {
  scene.stones.gradation = stored_gradation_file;
  const auto given = [&](const std::string& name) { return scene.source.places.contains(name); };
  std::string text = "# The complete scene of a run, in SI units, written by the program.\n";
  // A section that may be absent is described in a copy, because describing fills it in.
  Scene described = scene;
  for (const Section& section : describe(described)) {
    if (section.drop && !given(section.name)) continue;
    text += '\n' + header(section.name) + '\n';
    for (const Parameter& parameter : section.parameters) {
      if (parameter.presence.need == Need::has_default ||
          given(section.name + '.' + parameter.name))
        text += parameter.name + " = " + std::visit(BareValue{}, parameter.value) + '\n';
    }
  }
  return text;
}

}  // namespace

std::string complete_scene(GyratoryScene scene) {
  return complete(std::move(scene));
}
std::string complete_scene(FlowTestScene scene) {
  return complete(std::move(scene));
}

template <class Scene>
StoredScene stored_scene(const Scene& scene, const Options& options) {
  const std::optional<std::string> gradation = read_text(scene.stones.gradation);
  if (!gradation) throw OutputError("cannot read '" + scene.stones.gradation + "' again");
  return {options.resume ? scene.source.text : complete_scene(scene), *gradation};
}

template StoredScene stored_scene(const GyratoryScene&, const Options&);
template StoredScene stored_scene(const FlowTestScene&, const Options&);

}  // namespace apps
