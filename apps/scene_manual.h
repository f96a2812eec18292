// The manual of a scene, printed from the declarations that it is read with.
#pragma once

#include <string>
#include <vector>

#include "apps/parameters.h"

namespace apps {

// Sections as TOML: every parameter with its default, unit, bounds, meaning and source.
std::string manual(const std::vector<Section>& sections);
// A complete scene.
std::string gyratory_scene_manual();
std::string flow_scene_manual();

// The reference page: every key of both scenes in tables (Markdown).
std::string scene_reference();

// A JSON Schema (draft 2020-12), with which an editor checks and completes a scene as it is typed.
std::string gyratory_scene_schema();
std::string flow_scene_schema();

}  // namespace apps
