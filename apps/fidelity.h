// Fidelity as one word: named sets of the keys that trade accuracy for speed. A set gives defaults;
// a key that the scene gives holds. What each costs and errs is measured in apps/docs/trade.md.
#pragma once

#include <string>
#include <vector>

#include "apps/scene.h"

namespace apps {

inline const std::vector<std::string> fidelities = {"draft", "standard", "reference"};

// `fidelity` is one of them.
void take_fidelity(const std::string& fidelity, GyratoryScene& scene);
void take_fidelity(const std::string& fidelity, FlowTestScene& scene);

// The scene run numerics.time_compression times as fast, with a binder that relaxes as much
// faster: what depends on time but inertia and gravity stays as it was. Durations and histories
// are then those of the faster process.
GyratoryScene compressed(const GyratoryScene& scene);
FlowTestScene compressed(const FlowTestScene& scene);

}  // namespace apps
