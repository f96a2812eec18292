// The scene of a run, to be stored with it: every key as it was read or by default, in SI to the
// last bit, so that neither the scene's file, nor what it refers to, nor a default can change
// later.
#pragma once

#include "apps/program.h"
#include "apps/run_folder.h"
#include "apps/scene.h"

namespace apps {

// The scene as TOML. Reading it gives the same scene and writing that the same text. The sieve
// table is named as the one beside it.
std::string complete_scene(GyratoryScene scene);
std::string complete_scene(FlowTestScene scene);

// What the folder of a run holds of its scene: a resumed one what it was resumed with.
template <class Scene>
StoredScene stored_scene(const Scene& scene, const Options& options);

extern template StoredScene stored_scene(const GyratoryScene&, const Options&);
extern template StoredScene stored_scene(const FlowTestScene&, const Options&);

}  // namespace apps
