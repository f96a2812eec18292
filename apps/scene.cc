#include "apps/scene.h"

#include <algorithm>

#include "apps/document.h"
#include "apps/fidelity.h"
#include "apps/scene_checks.h"
#include "apps/sections.h"
#include "apps/units.h"

namespace apps {
namespace {

SceneSource source_of(const Document& document, const std::vector<std::string>& overrides) {
  SceneSource source{document.path, document.text, overrides, {}};
  for (const auto& [name, place] : document.sections) source.places[name] = place.text();
  for (const auto& [key, value] : document.values) source.places[key] = value.place.text();
  return source;
}

// Makes room for what a scene may name more than once, and lets it be taken away where none is.
void make_room(GyratoryScene& scene, Document& document) {
  scene.gauges.resize(document.repetitions("output.gauge"));
  document.removed.erase("output.gauge");
}
void make_room(FlowTestScene&, Document&) {}

// Before anything is read: a set of fidelity is nothing but defaults.
template <class Scene>
void take_fidelity(const Document& document, Scene& scene) {
  const Value* value = document.find("run.fidelity");
  const std::string* word = value ? std::get_if<std::string>(&value->content) : nullptr;
  if (word && std::ranges::find(fidelities, *word) != fidelities.end()) take_fidelity(*word, scene);
}

template <class Scene>
Scene read_scene(const std::string& path, const std::vector<std::string>& overrides) {
  const UnitSystem units;
  Mistakes mistakes;
  Document document = read_document(path, overrides, mistakes);
  Scene scene;
  make_room(scene, document);
  take_fidelity(document, scene);
  read_sections(describe(scene), document, units, mistakes);
  check(scene, document, mistakes);
  if (mistakes.any()) throw InputError(mistakes.lines());
  scene.source = source_of(document, overrides);
  return scene;
}

}  // namespace

std::string SceneSource::where(const std::string& key) const {
  for (std::string name = key;;) {
    if (const auto found = places.find(name); found != places.end()) return found->second;
    const auto dot = name.rfind('.');
    if (dot == std::string::npos) return path;
    name.resize(dot);
  }
}

GyratoryScene read_gyratory_scene(const std::string& path,
                                  const std::vector<std::string>& overrides) {
  return read_scene<GyratoryScene>(path, overrides);
}

FlowTestScene read_flow_scene(const std::string& path, const std::vector<std::string>& overrides) {
  return read_scene<FlowTestScene>(path, overrides);
}

}  // namespace apps
