// What a gyratory run will be, see forecast.h.
#pragma once

#include "apps/forecast.h"
#include "apps/machine.h"

namespace apps {

Loading gyratory_loading(const GyratoryScene& scene, const Machine& machine);

// How the modes of each elastic body will move; meshes and reduces the bodies.
std::vector<std::string> steel_forecast(const GyratoryScene& scene, const Machine& machine);

}  // namespace apps
